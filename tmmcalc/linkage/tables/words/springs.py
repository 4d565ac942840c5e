"""Words for faults in ``[[springs]]``: what a missing key is for, what to write in its lists and tables."""

MISSING = {
    "links": ("every spring connects two links", "add links = [2, 0]; 0 is the frame"),
}

LISTS = {
    "links": ("two link numbers", "links = [2, 0]"),
    "points": ("the ends of the spring on the two links", 'points = ["B", [0.1, 0.2]]'),
}

PLACES = ("points[]",)
ELEMENTS = {"": ("name", 'spring "{}"')}
