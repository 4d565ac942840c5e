"""Stage ``wheel``: a wheel without a mate: circles, limits, measures, profile."""

from __future__ import annotations

from tmmcalc.gears.single.results import SingleWheel
from tmmcalc.gears.tables.tasks.wheel import to_wheel

inputs = to_wheel
solve = "tmmcalc.gears.single.solve:solve_single"
kind = SingleWheel
columns = "tmmcalc.gears.single.columns:wheel_columns"
declares = ()
