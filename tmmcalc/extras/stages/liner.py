"""Stage ``liner``: a cylinder liner as ring and shell."""

from __future__ import annotations

from tmmcalc.extras.liner import Liner, solve_liner
from tmmcalc.extras.tables.tasks.liner import to_liner

inputs = to_liner
solve = solve_liner
kind = Liner
columns = "tmmcalc.extras.columns:liner_columns"
declares = ()
