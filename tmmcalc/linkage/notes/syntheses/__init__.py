"""What the chapter on the synthesis tells of each kind of it, a file a kind or a few that are alike.

Each has ``task(told)``, a sentence on what is sought; ``given(told)``, what is asked, by names; ``further(told)``, what
is asked beside that: points, choices, the rule by which a free size is found; and ``blocks(told)``, the equations and
how the dimensions follow from them. ``conditions(told)`` are those on the linkage that was found.
"""
