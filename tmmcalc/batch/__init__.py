"""Many variants of one spec: solved point by point or in blocks, here, in processes or on a cluster, into one table.

task.py        the points: which values of which keys, and what is asked of each
table.py       a table of variants, a row each
reading.py     the task from the flags of a user
quantities.py  what a stage tells of a variant, chosen by name
points.py      points solved one by one through the pipeline: works for every stage
content.py     what a task depends on: the files that its spec names, and the hash of all
preparing.py   what points need to be solved together, or why they cannot be
stacked.py     points solved together, and in which way they were; stacked_columns.py values of columns at once,
               stacked_results.py results of every variant, stacked_inputs.py what their stages read,
               stacked_acting.py which causes act, stacked_machine.py their steady motions
places.py      the same at places that are chosen while one goes on
outcomes.py    the result of one stage at every point
regions.py     where constraints hold over one or two keys
choice.py      by which solver, in what blocks, in how many processes
executors.py   who solves the blocks: this process or others; a lost block is solved again
local.py       local processes by joblib
cluster.py     the workers of a Dask cluster
journal.py     finished points beside the table, so that a killed sweep goes on where it was
sheet.py       the tidy CSV in the order of the points, and what vouches for it
sweep.py       one sweep from the task to the table
"""
