"""Where the pipeline meets the rooms: one module a stage.

Each says what the stage reads from the spec, calls the room's one function, and turns the result into the
stored form and back: ``inputs``, ``solve``, ``dump``, ``load``, ``table``.
"""
