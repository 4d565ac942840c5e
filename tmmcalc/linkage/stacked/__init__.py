"""Many variants of one linkage in one pass of the array code: their rows stand one behind the other.

scene.py      the variants of a block, with all that is the same for them, and their constants at any rows
settle.py     the survey of all of them: which are far from any trouble, position 0, where rubbing pairs turn back
zeros.py      zeros of periodic functions of many variants at once
tables.py     results of kinematics and forces, whose rows are those of all variants
ragged.py     panels of all variants, of each as many as it needs
reduction.py  reduced moments and inertia on these panels

A variant that comes near to a limit position, a dead point, self-locking, or a rest between two turning points is not
decided here: it is told apart (``clear``), to be solved alone.
"""
