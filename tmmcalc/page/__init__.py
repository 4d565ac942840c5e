"""The page: one HTML file in which what a run found is looked at, moved and read, without a network.

    run -> content (stages, views, given data) -> packing (numbers in one block) -> document (one file)

`web/` holds what runs in the browser. What moves, rooms say (`tmmcalc.report.moving`).
"""
