"""The parts of the chapter on forces: what acts, the groups, the input link, friction, tables, the lever."""
