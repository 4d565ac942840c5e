"""The formulas that a page computes when shifts are moved by hand: the program's values at a hundred points."""

from __future__ import annotations

import json
import math
import shutil
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tmmcalc.core.errors import TmmError
from tmmcalc.gears.meshing.blocking import solve_blocking
from tmmcalc.gears.meshing.results import MeshPair, Pairs
from tmmcalc.gears.meshing.solve import solve_pair
from tmmcalc.gears.meshing.task import PairTask
from tmmcalc.gears.notes.pairs.lexicon import told_of
from tmmcalc.gears.views.blocking import texts, trial_of
from tmmcalc.page.document import WEB
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.formula.tree import Call, Name, value

PAIRS = {
    "spur": PairTask((14, 27), 0.005, strategy="given", shifts=(0.5, 0.4)),
    "helical": PairTask((17, 31), 0.003, helix=math.radians(15), face_width=0.04, strategy="given", shifts=(0.3, 0.2)),
    "unshifted": PairTask((20, 40), 0.002, strategy="given", shifts=(0.0, 0.0)),
}
EXACT = 1e-9
SCRIPT = """
import {{ chained }} from "{module}";
let text = "";
process.stdin.on("data", (part) => (text += part));
process.stdin.on("end", () => {{
  const {{ steps, points }} = JSON.parse(text);
  const compute = chained(steps);
  process.stdout.write(JSON.stringify(points.map(compute)));
}});
"""


def node() -> str | None:
    """Node where there is one: beside the interpreter, as developers have it, or installed."""
    own = Path(sys.executable).parent / "node"
    return str(own) if own.exists() else shutil.which("node")


def shifted(task: PairTask, shifts: tuple[float, float]) -> MeshPair | None:
    """The pair with other shifts; None: they give no mesh, or an undercut takes from the flanks."""
    try:
        found = solve_pair(replace(task, strategy="given", shifts=shifts, refuse=False))
    except TmmError:
        return None
    sound = all(size.limit is not None and size.limit > 0 for size in found.sizes)
    return found if sound and min(found.line.start, found.line.length - found.line.end) > 0 else None


@pytest.fixture(scope="module", params=PAIRS)
def tried(request: pytest.FixtureRequest) -> tuple[Any, list[tuple[MeshPair, dict[str, float]]]]:
    """A trial, and a hundred points of it as the program solves them, with what the formulas need."""
    task = PAIRS[request.param]
    found = solve_pair(task)
    contour = solve_blocking(Pairs((found,), "", ())).pairs[0]
    trial = trial_of(found, contour, "trial")
    random = np.random.default_rng(7)
    points: list[tuple[MeshPair, dict[str, float]]] = []
    while len(points) < 100:
        x1, x2 = random.uniform(-0.2, 1.2, 2).tolist()
        other = shifted(task, (x1, x2))
        if other is not None:
            points.append((other, {**trial.given, "x_1": x1, "x_2": x2}))
    return trial, points


def inner(given: Given) -> float:
    assert isinstance(given.value, float | int)
    return math.radians(given.value) if given.unit == "deg" else float(given.value)


def wrong(names: list[str], ours: dict[str, float], found: MeshPair) -> list[str]:
    """Those whose values are not the program's, to 1e-9 of them, of small ones of 1 (mm, rad)."""
    lexicon = told_of(found).lexicon
    true = {name: inner(lexicon[name]) for name in names}
    return [name for name, each in true.items() if not abs(ours[name] - each) <= EXACT * max(abs(each), 1.0)]


def test_formulas_give_what_the_program_finds(tried: tuple[Any, list[tuple[MeshPair, dict[str, float]]]]) -> None:
    """In Python, by the trees: also what no function of one name on the left side tells."""
    trial, points = tried
    formulas = [read(text) for text in texts(told_of(points[0][0]))]
    for found, given in points[:20]:
        values = dict(given)
        for formula in formulas:
            left, right = formula.sides
            if isinstance(left, Call):
                name = left.arguments[0]
                assert isinstance(name, Name)
                assert value(right, values) == pytest.approx(math.tan(found.angle_w) - found.angle_w, rel=EXACT)
                values[name.key] = found.angle_w
            else:
                assert isinstance(left, Name)
                values[left.key] = value(right, values)
        assert wrong([shown.name for shown in trial.shown], values, found) == []


@pytest.mark.skipif(node() is None, reason="there is no node to run the page's formulas by themselves")
def test_the_page_computes_the_same(tried: tuple[Any, list[tuple[MeshPair, dict[str, float]]]]) -> None:
    trial, points = tried
    program = node()
    assert program is not None
    script = SCRIPT.format(module=(WEB / "formulas.js").as_uri())
    said = json.dumps({"steps": trial.steps, "points": [given for _, given in points]})
    run = subprocess.run(
        [program, "--input-type=module", "-e", script], input=said, capture_output=True, text=True, check=True
    )
    names = [shown.name for shown in trial.shown]
    for (found, _), values in zip(points, json.loads(run.stdout), strict=True):
        assert wrong(names, values, found) == []


def test_what_is_told_has_its_meaning(tried: tuple[Any, Any]) -> None:
    trial, _ = tried
    assert all(shown.meaning for shown in trial.shown)
    assert {step.name for step in trial.steps} >= {shown.name for shown in trial.shown} - {"x_1", "x_2"}
    assert {region.kind for region in trial.regions} >= {"strict", "tolerated"}
