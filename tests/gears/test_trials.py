"""What a page computes when shifts are moved by hand: the program's values, teeth and refusals at a hundred points."""

from __future__ import annotations

import json
import math
import os
import shutil
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest

from gears.outlines import far, followed
from tmmcalc.core.errors import TmmError
from tmmcalc.core.plane import Plane, Real
from tmmcalc.gears.involute.rack import RACKS, Rack
from tmmcalc.gears.meshing.blocking import solve_blocking
from tmmcalc.gears.meshing.halftooth import fault_of
from tmmcalc.gears.meshing.members import both
from tmmcalc.gears.meshing.results import MeshPair, Pairs
from tmmcalc.gears.meshing.solve import solve_pair
from tmmcalc.gears.meshing.task import PairTask
from tmmcalc.gears.notes.pairs.lexicon import told_of
from tmmcalc.gears.pictures.placedpair import from_gap_to_gap, placed_pair, placings_of
from tmmcalc.gears.views.blocking import contact_of, sizes_of, trial_of
from tmmcalc.page.document import WEB
from tmmcalc.report.exploring import Trial
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.formula.tree import Call, Name, value

PAIRS = {
    "spur": PairTask((14, 27), 0.005, strategy="given", shifts=(0.5, 0.4)),
    "helical": PairTask((17, 31), 0.003, helix=math.radians(15), face_width=0.04, strategy="given", shifts=(0.3, 0.2)),
    "unshifted": PairTask((20, 40), 0.002, strategy="given", shifts=(0.0, 0.0)),
    "few teeth": PairTask((9, 13), 0.006, strategy="given", shifts=(0.4, 0.3)),
    "few helical": PairTask((8, 11), 0.004, helix=math.radians(25), strategy="given", shifts=(0.4, 0.3)),
    "circle": PairTask((10, 15), 0.02, helix=-0.3, fillet="circle", strategy="given", shifts=(0.3, 0.3)),
    "sharp": PairTask((11, 19), 0.008, rack=Rack(tip_radius=0.0), strategy="given", shifts=(0.4, 0.3)),
    "stub": PairTask((12, 60), 0.01, rack=RACKS["ISO 53 D"], strategy="given", shifts=(0.3, 0.2)),
    "cut off": PairTask((4, 18), 0.005, strategy="given", shifts=(0.7, 0.5), refuse=False),
    "full": PairTask((13, 21), 0.005, rack=Rack(math.radians(25), 1.0, 0.25), strategy="given", shifts=(0.3, 0.2)),
    "tips": PairTask((16, 23), 0.004, tips=(0.0362, 0.0512), strategy="given", shifts=(0.2, 0.2)),
}
QUICK = {"few helical": 24, "cut off": 6}  # the first points of those that are quick
FEET = (-0.74, 0.5), (-0.71, 0.5), (-0.68, 1.0), (-0.62, 0.5)  # shifts at which 4 teeth are, or all but are, cut off
COUNT = 100
NEAR = 1e-2, 1e-4, 1e-6, 1e-8  # below the limit of undercut
EXACT = 1e-9
MICROMETRE = 1e-3  # mm
SCRIPT = """
import {{ chained, compiled }} from "{folder}/formulas.js";
import {{ teethAt, toothed }} from "{folder}/outlines.js";
let text = "";
process.stdin.on("data", (part) => (text += part));
process.stdin.on("end", () => {{
  const {{ steps, conditions, bodies, middle, points }} = JSON.parse(text);
  const compute = chained(steps);
  const spares = conditions.map(([formula]) => compiled(formula));
  const placed = bodies.map(toothed);
  const [x, y] = middle.map(compiled);
  process.stdout.write(JSON.stringify(points.map((point) => {{
    const values = compute(point);
    const broken = spares.map((spare, k) => (spare(values) >= 0 ? -1 : k)).filter((k) => k >= 0);
    if (broken.some((k) => conditions[k][1])) return {{ values, broken, bodies: null }};
    const bodies = placed.map((each) => each(values, 5e-4));
    const seen = bodies.map((each) => teethAt(each, [x(values), y(values)], 3 * Math.PI * values.m));
    return {{ values, broken, bodies: bodies.some((each) => each.beyond) ? null : bodies, seen }};
  }})));
}});
"""


class Tried(NamedTuple):
    """A point of a plane: the pair there, None where the program refuses it, and whether its wheels have profiles."""

    found: MeshPair | None
    whole: bool
    given: dict[str, float]


class Plan(NamedTuple):
    """A plane with a hundred of its points, and what the page makes of each."""

    trial: Trial
    points: list[Tried]
    page: list[Any]


def node() -> str | None:
    """Node where there is one: beside the interpreter, as developers have it, or installed."""
    own = Path(sys.executable).parent / "node"
    return str(own) if own.exists() else shutil.which("node")


def shifted(task: PairTask, shifts: tuple[float, float]) -> MeshPair | None:
    """The pair with other shifts; None: they give no mesh."""
    try:
        return solve_pair(replace(task, strategy="given", shifts=shifts, refuse=False))
    except TmmError:
        return None


def computed(trial: Trial, points: list[Tried]) -> list[Any]:
    """What the page makes of the points, without a browser."""
    program = node()
    if program is None:
        assert not os.environ.get("CI"), "node is not installed"
        pytest.skip("there is no node to run the page's formulas by themselves")
    sketch = trial.sketch
    said = {
        "steps": trial.steps,
        "conditions": [(each.formula, each.needed) for each in trial.conditions],
        "bodies": [
            {**body._asdict(), "half": [each._asdict() for each in body.half], "worked": body.worked._asdict()}
            for body in sketch.bodies
        ],
        "middle": sketch.middle,
        "points": [each.given for each in points],
    }
    run = subprocess.run(
        [program, "--input-type=module", "-e", SCRIPT.format(folder=WEB.as_uri())],
        input=json.dumps(said),
        capture_output=True,
        text=True,
        check=True,
    )
    found: list[Any] = json.loads(run.stdout)
    return found


@pytest.fixture(
    scope="module",
    params=[pytest.param((name, count), id=name) for name, count in QUICK.items()]
    + [pytest.param((name, COUNT), id=f"all of {name}", marks=pytest.mark.slow) for name in PAIRS],
)
def plan(request: pytest.FixtureRequest) -> Plan:
    """All over the plane that is shown and far beyond it, and close to the limits of undercut."""
    name, count = request.param
    task = PAIRS[name]
    found = solve_pair(task)
    contour = solve_blocking(Pairs((found,), "", ())).pairs[0]
    trial = trial_of(found, contour, "trial")
    random = np.random.default_rng(7)
    (low, high), points = trial.box, list[Tried]()
    least = [size.least_shift or 0.0 for size in found.sizes]
    shifts = [
        (random.uniform(low.real - 0.1, high.real + 0.1), random.uniform(low.imag - 0.1, high.imag + 0.1))
        if k % 2
        else (random.uniform(least[0] - 1.6, least[0] + 2), random.uniform(least[1] - 1.6, least[1] + 2))
        for k in range(count)
    ]
    shifts += [(least[0] - near, 0.3 - least[0]) for near in NEAR] + [(0.5, least[1] - near) for near in NEAR]
    shifts += FEET if name == "cut off" else ()
    for x1, x2 in shifts:
        other = shifted(task, (x1, x2))
        whole = other is not None and all(fault_of(each) is None for each in both(other))
        points.append(Tried(other, whole, {**trial.given, "x_1": x1, "x_2": x2}))
    return Plan(trial, points, computed(trial, points))


def inner(given: Given) -> float:
    assert isinstance(given.value, float | int)
    return math.radians(given.value) if given.unit == "deg" else float(given.value)


def wrong(trial: Trial, ours: dict[str, float], found: MeshPair) -> list[str]:
    """What is shown and not the program's, to 1e-9 of it, of small values to 1e-9 mm or rad."""
    lexicon, bad = told_of(found).lexicon, []
    for shown in trial.shown:
        hidden = bool(shown.where) and ours[shown.where] < 0
        if hidden or shown.name not in lexicon:
            bad += [shown.name] if hidden != (shown.name not in lexicon) else []
            continue
        true = inner(lexicon[shown.name])
        if not abs(ours[shown.name] - true) <= EXACT * max(abs(true), 1.0):
            bad.append(shown.name)
    return bad


def test_formulas_give_what_the_program_finds(plan: Plan) -> None:
    """In Python, by the trees: also what no function of one name on the left side tells."""
    trial, points, _ = plan
    for point in [each for each in points if each.whole][:20]:
        assert point.found is not None
        told = told_of(point.found)
        values: dict[str, Any] = point.given | {key: inner(told.lexicon[key]) for key in ("rho_F1", "rho_F2")}
        for text in (*sizes_of(told), *contact_of(told)):
            left, right = read(text).sides
            name = left.arguments[0] if isinstance(left, Call) else left
            assert isinstance(name, Name)
            if isinstance(left, Call):
                angle = point.found.angle_w
                assert value(right, values) == pytest.approx(math.tan(angle) - angle, rel=EXACT)
                values[name.key] = angle
            else:
                values[name.key] = value(right, values)
        assert wrong(trial, values, point.found) == []


def test_the_page_computes_the_same(plan: Plan) -> None:
    """Also what an undercut leaves of the contact."""
    seen = under = 0
    for point, page in zip(plan.points, plan.page, strict=True):
        if point.whole and point.found is not None:
            assert wrong(plan.trial, page["values"], point.found) == []
            seen += 1
            under += point.found.shortened < point.found.contact_ratio - 1e-6
    assert seen > 0.2 * len(plan.points)
    assert under > 0.1 * len(plan.points)


def test_the_page_refuses_what_the_program_refuses(plan: Plan) -> None:
    for point, page in zip(plan.points, plan.page, strict=True):
        assert (page["bodies"] is not None) == point.whole, (point.given["x_1"], point.given["x_2"], page["broken"])
        if point.found is None or not point.whole:
            continue
        failed = {check.name for check in point.found.checks if check.verdict == "fail"}
        told = [plan.trial.conditions[k].text for k in page["broken"]]
        assert any("cuts into the fillet" in text for text in told) == ("interference" in failed)
        assert any("pointed" in text for text in told) == any(
            check.name == "tip thickness" and check.value < 0 for check in point.found.checks
        )


def line(chain: list[list[float]]) -> Plane:
    """Points along the cubics of the page."""
    points: Real = np.array(chain)
    return followed(points[:, 0] + 1j * points[:, 1])


def test_teeth_are_the_programs_to_a_micrometre(plan: Plan) -> None:
    """Half a tooth, both ways, and where the wheels stand; the curves themselves, fillets of undercut teeth too."""
    for point, page in zip(plan.points, plan.page, strict=True):
        if page["bodies"] is None or point.found is None:
            continue
        m = 1e3 * point.found.task.module
        for member, placing, body in zip(both(point.found), placings_of(point.found, 0.0), page["bodies"], strict=True):
            whole = m * from_gap_to_gap(member.element, 2e-5)
            ours = line(body["half"])
            assert far(ours, whole) < MICROMETRE
            assert far(whole[whole.real <= 0], ours) < MICROMETRE
            assert body["turn"] == pytest.approx(placing.turn, abs=1e-11)
            assert complex(body["x"], body["y"]) == pytest.approx(m * placing.centre, abs=1e-9)
            assert body["count"] == member.wheel.teeth


def test_wheels_stand_in_mesh_as_in_the_picture(plan: Plan) -> None:
    """What is drawn around the pitch point, against what `placed_pair` draws there, with the flanks that work."""
    drawn = [pair for pair in zip(plan.points, plan.page, strict=True) if pair[1]["bodies"] is not None]
    for point, page in drawn[:3]:
        assert point.found is not None
        pair = placed_pair(point.found)
        for body, seen in zip(pair.bodies, page["seen"], strict=True):
            edge, outline = 1e3 * body.edge, line(seen["outline"])
            assert far(edge, outline) < MICROMETRE
            flanks = [line(each) for each in seen["flanks"] if each]
            for flank in body.flanks:
                if point.found.shortened > 0:
                    assert min(far(1e3 * flank, each) for each in flanks) < MICROMETRE


def test_what_is_told_has_its_meaning(plan: Plan) -> None:
    trial = plan.trial
    assert all(shown.meaning for shown in trial.shown)
    told = {step.name for step in trial.steps} | {*trial.inputs, *trial.given}
    assert told >= {shown.name for shown in trial.shown}
    assert not trial.regions or {region.kind for region in trial.regions} >= {"strict", "tolerated"}
