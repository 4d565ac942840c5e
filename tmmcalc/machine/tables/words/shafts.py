"""Words for faults in ``[[shafts]]``."""

ELEMENTS = {"": ("name", 'shaft "{}"')}
