"""Constraints inside the search of a synthesis, against the ready specs of the designs that are listed."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import tmmcalc
from tmmcalc.linkage.stages.synthesis import inputs

POSES = """[synthesis]
solutions = 3
[synthesis.motion]
points = [[0, 0], ["60 mm", "40 mm"], ["120 mm", "45 mm"], ["150 mm", "20 mm"]]
angles = ["0 deg", "20 deg", "50 deg", "80 deg"]
region = [["-150 mm", "-150 mm"], ["250 mm", "200 mm"]]
"""
SHORT = '[[constraints]]\nname = "short"\nstage = "synthesis"\ncolumn = "a"\nat_most = "{}"\n'
SLOW = '[[constraints]]\nname = "slow"\nstage = "kinematics"\ncolumn = "omega_3"\nof = "size"\nat_most = "{}"\n'


def designs(text: str) -> Any:
    return tmmcalc.solve_synthesis(tmmcalc.parse_spec(text))


def fastest(design: Any) -> float:
    motion = tmmcalc.solve_kinematics(tmmcalc.parse_spec(design.spec))
    return float(np.max(np.abs(motion.trace.dangle[motion.trace.link_ids.index(3)])))  # the crank turns at 1 rad/s


@pytest.mark.slow
def test_the_search_goes_on_to_designs_that_keep_the_constraints() -> None:
    plain = designs(POSES)
    assert all(design.size("a") > 0.06 for design in plain.designs)
    found = designs(POSES + SHORT.format("60 mm") + SLOW.format("1.4 rad/s"))
    assert len(found.designs) == 3
    for design in found.designs:
        assert design.size("a") <= 0.06
        assert fastest(design) <= 1.4
    assert any("short (" in note and "passed over" in note for note in found.notes)
    assert found.counters["passed over"] > 0


@pytest.mark.slow
def test_a_rule_lets_pass_what_a_single_constraint_would_not() -> None:
    text = POSES + SHORT.format("60 mm") + SLOW.format("0.6 rad/s")
    for design in designs(text + '[feasibility]\nrule = "short or slow"\n').designs:
        assert design.size("a") <= 0.06 or fastest(design) <= 0.6
    for design in designs(text + '[feasibility]\nrule = "not short"\n').designs:
        assert design.size("a") > 0.06


@pytest.mark.slow
def test_where_no_design_keeps_them_the_nearest_are_listed() -> None:
    found = designs(POSES + SHORT.format("1 mm"))
    sizes = [design.size("a") for design in found.designs]
    assert sizes == sorted(sizes)
    assert max(sizes) < min(design.size("a") for design in designs(POSES).designs)
    assert any(note.startswith("warning") and "passed over" in note for note in found.notes)


@pytest.mark.parametrize(("text", "kept"), [(POSES, False), (POSES + SHORT.format("1 m"), True)])
def test_what_the_search_reads(text: str, kept: bool) -> None:
    """A scene without constraints has the inputs, and so the stored results, that it would have without this."""
    request = inputs(tmmcalc.parse_spec(text))
    assert (request.task.constraints is not None) == kept
    assert request.own == (("synthesis", "feasibility") if kept else ())
