"""The stages of a scene run in order: loaded where their files are valid, computed where not.

hashing.py   one hash of everything that a result depends on
store.py     OUT/<stage>.toml, .npz, .csv: atomic, verified, locked
archive.py   the output folder of one run
runner.py    load or compute each stage in turn
summary.py   the document of a whole run
why.py       what decided the plan, what would bring a stage in
depfile.py   a Makefile rule for the files of a run
"""
