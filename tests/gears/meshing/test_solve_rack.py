"""A pinion and its rack from the task to every size."""

from dataclasses import replace
from math import cos, hypot, pi, radians, sin, sqrt

import numpy as np
import pytest

from gears.meshing.pairs import MM, M, lengths, plain_everywhere
from tmmcalc.core.conversion import from_record, to_record
from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.gears.involute.quality.verdicts import QualityLimits
from tmmcalc.gears.involute.rack import RACKS
from tmmcalc.gears.meshing.results import MeshPair
from tmmcalc.gears.meshing.solve import solve_pair
from tmmcalc.gears.meshing.task import PairTask


def on_rack(z: int, x: float | None = None, beta_deg: float = 0.0, **more) -> PairTask:
    strategy = "zero" if x is None else "given"
    usual = {"module": M, "kind": "rack", "helix": radians(beta_deg), "strategy": strategy, "shifts": (x, None)}
    return PairTask((z, 0), **(usual | more))


def test_by_hand():
    found = solve_pair(on_rack(25, 0.2))
    assert found.shifts == (0.2, 0.0)
    assert found.distance == pytest.approx(12.7 * M)
    assert found.reference_distance == pytest.approx(12.5 * M)
    assert found.angle_w == found.angle_t == pytest.approx(radians(20))
    assert (found.stretch, found.modification, found.shortening) == (1.0, 0.2, 0.0)
    assert found.clearances == pytest.approx((0.25 * M, 0.25 * M))
    wheel, line = found.sizes[0], found.line
    assert len(found.sizes) == len(found.measures) == 1
    assert wheel.tip == pytest.approx(13.7 * M)
    assert wheel.operating == wheel.reference
    assert line.pitch == pytest.approx(12.5 * M * sin(radians(20)))
    assert line.start == pytest.approx(line.pitch - 0.8 * M / sin(radians(20)))
    assert line.end == pytest.approx(sqrt(wheel.tip**2 - wheel.base**2))
    assert found.contact_ratio == pytest.approx((line.end - line.start) / (pi * M * cos(radians(20))))
    assert found.peaks.theta1 == pytest.approx(1 - line.pitch / line.begins)
    assert found.peaks.pressure_start == pytest.approx(M / line.begins)
    assert wheel.active == pytest.approx(hypot(wheel.base, line.begins))
    table = found.sliding
    assert np.array_equal(table.active, (table.rho1 >= line.begins) & (table.rho1 <= line.ends))
    assert table.theta1 == pytest.approx(1 - line.pitch / table.rho1)


@pytest.mark.parametrize(("z", "x", "beta"), [(20, 0.3, 0), (30, 0.0, 20), (100, -0.4, 10)])
def test_limit_of_a_large_wheel(z, x, beta):
    found = solve_pair(on_rack(z, x, beta))
    large = solve_pair(PairTask((z, 20_000), M, strategy="given", shifts=(x, 0.0), helix=radians(beta), refuse=False))
    assert found.contact_ratio == pytest.approx(large.contact_ratio, abs=2e-3)
    assert found.peaks.theta1 == pytest.approx(large.peaks.theta1, rel=1e-2)
    assert found.measures[0].spans == large.measures[0].spans
    same = {"pressure angle", "contact ratio", "undercut", "tip thickness", "sliding"}
    for check in found.checks:
        if check.name in same and check.wheel < 2:
            mate = next(c for c in large.checks if (c.name, c.wheel) == (check.name, check.wheel))
            assert check.value == pytest.approx(mate.value, abs=5e-3)
            assert check.verdict == mate.verdict


def test_strategies():
    balanced = solve_pair(on_rack(12, strategy="balanced", shifts=(None, None)))
    least = 1 - 6 * sin(radians(20)) ** 2
    assert balanced.shifts[0] == pytest.approx(least)
    assert "least shift without undercut" in balanced.note
    assert next(c for c in balanced.checks if c.name == "undercut").verdict == "ok"
    assert solve_pair(on_rack(30, strategy="balanced", shifts=(None, None))).shifts == (0.0, 0.0)
    placed = solve_pair(on_rack(30, strategy="given_aw", shifts=(None, None), distance=0.0765))
    assert placed.shifts[0] == pytest.approx(0.3)
    assert placed.distance == 0.0765
    with pytest.raises(UsageError, match="two wheels"):
        solve_pair(on_rack(30, strategy="equal_sliding"))
    with pytest.raises(UsageError, match="distance is missing"):
        solve_pair(on_rack(30, strategy="given_aw"))


def test_undercut_shortens_but_does_not_collide():
    found = solve_pair(on_rack(14))
    assert found.verdict == "warn"
    assert found.shortened < found.contact_ratio
    assert found.line.begins > found.line.start
    assert next(c for c in found.checks if c.name == "interference").verdict == "warn"
    with pytest.raises(NoSolutionError, match=r"(?s)undercut.*nearest admissible shift is x1 = 0.1812, the datum line"):
        solve_pair(on_rack(14, limits=QualityLimits(undercut=False)))


def test_rack_with_longer_teeth_than_its_tool():
    with pytest.raises(NoSolutionError, match=r"(?s)tip of the rack cuts into the fillet.*tips by the rule"):
        solve_pair(on_rack(20, tips=(None, 1.1 * M)))
    shorter = solve_pair(on_rack(20, tips=(None, 0.9 * M)))
    assert shorter.clearances[0] == pytest.approx(0.35 * M)
    assert shorter.contact_ratio < solve_pair(on_rack(20)).contact_ratio


@pytest.mark.parametrize("name", RACKS)
def test_presets(name):
    found = solve_pair(on_rack(40, rack=RACKS[name]))
    assert all(c.margin >= -1e-12 for c in found.checks if c.name in ("interference", "clearance"))


def test_refusals():
    with pytest.raises(NoSolutionError, match=r"pair z = 10/rack: .*tip thickness of gear 1.*\n.*nearest admissible"):
        solve_pair(on_rack(10, 1.2))
    with pytest.raises(NoSolutionError, match=r"60 mm in diameter, lies within its base circle, 93.9693 mm"):
        solve_pair(on_rack(20, tips=(0.03, None), refuse=False))


@pytest.mark.parametrize("task", [on_rack(20), on_rack(14, 0.3, 20, face_width=0.05), on_rack(8, refuse=False)])
def test_plain_and_scaled(task):
    found = solve_pair(task)
    plain_everywhere(found)
    assert repr(from_record(MeshPair, to_record(found))) == repr(found)
    assert lengths(solve_pair(replace(task, module=2 * M))) == pytest.approx(
        {key: 2 * value for key, value in lengths(replace_width(task)).items()}, rel=1e-11, abs=1e-9 * MM
    )


def replace_width(task: PairTask) -> MeshPair:
    """The pair with half the face width, which is the same in modules of twice the size."""
    return solve_pair(replace(task, face_width=None if task.face_width is None else task.face_width / 2))
