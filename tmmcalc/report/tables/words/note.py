"""Words for faults in ``[note]``: what to write in its lists."""

LISTS = {
    "chapters": ("the chapters of the note", 'chapters = ["kinematics", "forces"]'),
    "chapters[]": ("the name of a chapter", '"forces"'),
    "units": ("units of results", 'units = ["mm", "MPa"]'),
    "units[]": ("a unit", '"mm"'),
    "who.organisation": ("the lines at the top of the title page", 'organisation = ["University", "Department"]'),
    "who.organisation[]": ("a line of the title page", '"Department"'),
}
