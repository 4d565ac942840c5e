"""What the documents of synthesis and pressure angle say, against the records that they show."""

from math import degrees, radians

import numpy as np
import pytest

from cams.turns import task_of, turn
from tmmcalc.cams.facts.cam_pressure import document as pressure_document
from tmmcalc.cams.facts.cam_pressure import summary as pressure_summary
from tmmcalc.cams.facts.cam_synthesis import document as synthesis_document
from tmmcalc.cams.facts.cam_synthesis import summary as synthesis_summary
from tmmcalc.cams.pressure.solve import solve_pressure
from tmmcalc.cams.synthesis.solve import solve_synthesis
from tmmcalc.cams.task import AngleLimits

LIMITS = AngleLimits(radians(32), radians(40))
TASKS = {
    "translating": task_of(turn("shun", "sine", back=90), limits=LIMITS, offset=None, sense=-1),
    "oscillating": task_of(turn("const", back=90, stroke=0.3), "oscillating", limits=LIMITS, rocker=0.1),
    "flat": task_of(turn(), "flat", limits=LIMITS, margin=0.002),
}


def payload(document):
    return {name: value for fact in document.facts for name, value in fact.values.items()}


@pytest.mark.parametrize("kind", TASKS)
def test_sizes_and_designs(kind):
    found = solve_synthesis(TASKS[kind])
    document = synthesis_document(found, "synthesis")
    values = payload(document)
    for size in found.sizes:
        unit, told = ("deg", degrees(size.value)) if size.symbol == "psi0" else ("m", size.value)
        assert values[f"{size.symbol}[{unit}]"] == pytest.approx(told, rel=1e-15)
    assert values["governs"] == found.governs
    assert len(values["designs"]) == len(found.designs)
    assert all(fact.label for fact in document.facts)
    summary = synthesis_summary(found, "synthesis")
    assert len(summary.facts) == 1 + len(found.sizes)
    if found.designs:
        view = document.table
        base = view.columns[list(view.headers).index("R0[mm]")]
        assert base == pytest.approx([1e3 * design.base for design in found.designs])
        whole = synthesis_document(found, "synthesis", everything=True).table
        assert len(whole.columns[0]) == len(found.region.x)


def test_offset_is_told_in_the_users_sense():
    found = solve_synthesis(TASKS["translating"])
    document = synthesis_document(found, "synthesis")
    assert payload(document)["e[m]"] == -found.follower.offset
    view = document.table
    assert view.columns[list(view.headers).index("e[mm]")][0] == pytest.approx(-1e3 * found.designs[0].offset)


def test_face():
    found = solve_synthesis(TASKS["flat"])
    values = payload(synthesis_document(found, "synthesis"))
    assert values["F_min[m]"] == found.convexity.least.value
    assert values["S0_min[m]"] == found.follower.start
    assert values["face_left[m]"] == found.convexity.left


@pytest.mark.parametrize("kind", TASKS)
def test_pressure(kind):
    task = TASKS[kind]
    found = solve_pressure(task, solve_synthesis(task).follower)
    whole = pressure_document(found, "pressure", everything=True)
    assert len(whole.table.columns[0]) == len(found.phi)
    told = pressure_document(found, "pressure")
    assert payload(told)["verdict"] == "ok"
    assert pressure_summary(found, "pressure").table is None
    if kind == "flat":
        return
    assert payload(told)["theta_rise_max[deg]"] == degrees(found.rise.largest.value)
    rows = told.table.columns[1]
    assert 5 < len(rows) < 60
    ends = np.degrees(task.program.starts[:-1])
    assert all(np.min(np.abs(np.array(rows) - end)) < 1e-9 for end in ends)


def test_a_limit_that_is_exceeded_is_told():
    task = task_of(turn(), limits=LIMITS, start=0.03)
    found = solve_pressure(task, solve_synthesis(task).follower)
    document = pressure_document(found, "pressure")
    assert any(note.startswith("warning") for note in document.notes)
    assert payload(document)["exceeded_rise[deg]"] == [[degrees(a), degrees(b)] for a, b in found.rise.exceeded]
