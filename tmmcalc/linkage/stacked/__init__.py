"""Many variants of one linkage in one pass of the array code: their rows stand one behind the other.

scene.py      the variants of a block, with all that is the same for them, and their constants at any rows
settle.py     the survey of all of them: which are far from any trouble, position 0, where rubbing pairs turn back
closer.py     a closer look at those that come near to a limit position: whether they pass it
zeros.py      zeros of periodic functions of many variants at once
dense.py      the survey that extremes of kinematics are refined from
summaries.py  strokes and extremes of outputs, transmission of dyads
tables.py     results of kinematics and forces, whose rows are those of all variants
reactions.py  the largest reactions between the positions

A variant that comes so near to a limit position or a dead point that digits are lost, to self-locking, or to a rest
between two turning points is not decided here: it is told apart (``clear``), to be solved alone.

One linkage by itself is a stack of one, wherever a computation has the same steps: the chain, the dyads, the statics,
extremes of outputs (`outputs.extremes_of`) and transmission (`quality.assessed`), the panels of reactions
(`forces.refinement`) and of what is reduced (`machine.reduction.mesh`). What differs, differs on purpose:

dead centres and reversals  alone they are sought with every turning point that may hide two of them, and a dead point
    is refused with its place and cause (`outputs.dead_centres`, `crossings`); here a variant with such a place is told
    apart, so that all have as many zeros and these are arrays (`survey`, `zeros`)
position 0 and strokes  alone of any output with any number of reversals, over a part of the turn too; here of two dead
    centres, where both ways to order them cannot be confused
self-locking  alone it is refused with its place and the part of the friction that is taken, and other solutions of
    friction are graded; here the growth of errors tells a variant apart long before
edges of panels  alone an edge that was put for a kink by a guess moves to it; here it stays, for to move edges takes
    the variants one by one, and what lies beside them is evaluated again
errors  alone the rounding of what is reduced is measured in extended precision; here that of kinematics bounds it
regimes of machines  alone the regime is told from others, and from a stall, however the motor goes; here only where
    the machine is drawn to it from the no-load speed without any doubt (`machine.stacked.regimes`)
"""
