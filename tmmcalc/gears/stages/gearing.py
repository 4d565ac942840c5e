"""Stage ``gearing``: a train that is written out, its speeds, torques, power flow and efficiency."""

from __future__ import annotations

from tmmcalc.gears.gearing import Gearing, solve_gearing
from tmmcalc.gears.members import member_columns
from tmmcalc.gears.tables.tasks.gearing import to_gearing

inputs = to_gearing
solve = solve_gearing
kind = Gearing
columns = member_columns
declares = ("carrier", "count", "i exact", "member")
details = "tmmcalc.gears.details:of_gearing"
