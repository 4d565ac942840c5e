"""Words for faults in ``[sheets]``: what to write in its lists."""

LISTS = {
    "diagrams": ("the columns of the diagrams", 'diagrams = ["S_*", "v_*"]'),
    "diagrams[]": ("the name of a column", '"S_*"'),
}
