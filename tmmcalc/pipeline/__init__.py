"""Stages by name: which of them run and why, how they are stored, when a stored one is still valid.

stage.py     what a stage is, and the record and table that it leaves
stages.py    the registry, in the order of the pipeline
plan.py      which stages a scene and a target need, with the reason
hashing.py   one hash of everything that a result depends on
store.py     OUT/<stage>.toml, .npz, .csv: atomic, verified, locked
runner.py    load or compute each stage in turn
depfile.py   a Makefile rule for the files of a run
"""
