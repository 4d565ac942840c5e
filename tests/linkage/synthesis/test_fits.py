"""Fits to more points than can be met: curves of known linkages are found again, whatever else is asked."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tmmcalc.core.plane import Plane, Real
from tmmcalc.linkage.synthesis import posefit
from tmmcalc.linkage.synthesis.atlas import atlas
from tmmcalc.linkage.synthesis.curvefit import Wanted, fitted
from tmmcalc.linkage.synthesis.kinds import solve_synthesis
from tmmcalc.linkage.synthesis.planar import Bars, bars_of
from tmmcalc.linkage.synthesis.results import Synthesis
from tmmcalc.linkage.synthesis.task import MechanismName, PoseTask, SynthesisTask

pytestmark = pytest.mark.slow


def four_bar(phi: Real, a: float, b: float, c: float, d: float, p: complex) -> Plane:
    """Coupler point by intersecting circles."""
    pin = a * np.exp(1j * phi)
    reach = d - pin
    along = (b**2 - c**2 + np.abs(reach) ** 2) / (2 * np.abs(reach))
    joint = pin + reach / np.abs(reach) * (along + 1j * np.sqrt(b**2 - along**2))
    return np.asarray(pin + (joint - pin) / b * p)


def slider_crank(phi: Real, r: float, l: float, e: float, p: complex) -> Plane:
    """Coupler point by the right triangle of the rod."""
    pin = r * np.exp(1j * phi)
    rise = e - r * np.sin(phi)
    return np.asarray(pin + (np.sqrt(l**2 - rise**2) + 1j * rise) / l * p)


def solved(mechanism: MechanismName, points: Plane, timing: Real | None = None) -> Synthesis:
    task = PoseTask(mechanism, points, timing=timing)
    return solve_synthesis(SynthesisTask("path", task, solutions=1))


@pytest.mark.parametrize(
    "sizes",
    [(0.3, 0.28, 0.31, 0.1, 0.2 - 0.1j), (0.12, 0.34, 0.3, 0.3, 0.5 + 0.05j)],  # the second in the second round
)
def test_fifteen_points_of_a_known_curve_are_met_exactly(sizes: tuple[float, float, float, float, complex]) -> None:
    points = four_bar(np.linspace(0.3, 5.5, 15), *sizes)
    found = solved("four_bar", points)
    assert found.best.precision is not None
    assert np.max(found.best.precision.found) < 1e-9 * np.ptp(points.real)
    assert not found.best.defects
    assert found.residual < 1e-9


def test_many_points_with_an_error_come_as_near_as_the_error(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(posefit, "ROUNDS", 1)
    rng = np.random.default_rng(0)
    clean = four_bar(np.linspace(0.0, 5.0, 60), 0.1, 0.3, 0.25, 0.32, 0.1 + 0.1j)
    noise = 1e-3 * (rng.normal(size=60) + 1j * rng.normal(size=60))
    found = solved("four_bar", clean + noise)
    assert found.best.precision is not None
    rms = math.sqrt(np.mean(found.best.precision.found**2))
    assert rms < math.sqrt(np.mean(np.abs(noise) ** 2))  # the least squares are below those of the linkage itself
    assert any("least squares" in note for note in found.notes)


def test_timed_points_of_a_known_slider_crank_are_met_exactly() -> None:
    phi = np.linspace(0.2, 5.0, 12)
    found = solved("slider_crank", slider_crank(phi, 0.1, 0.25, 0.03, 0.1 + 0.08j), phi - phi[0])
    assert [found.best.size(s) for s in "ab"] == pytest.approx([0.1, 0.25], rel=1e-8)


def bars(pivot: complex) -> Bars:
    return bars_of([[[v]] for v in (pivot, 0.4, 1.2, pivot + 1.3, 1.0, 1 + 0j, 0.5 + 0.4j, 1.0)], False)


def test_fitted_pivots_stay_in_the_region() -> None:
    """The best linkage has its pivots outside; the fit leaves them at the border or inside, and comes nearer."""
    phi = np.linspace(0, 5, 12)[None, :]
    wanted = Wanted(bars(0j).at(phi).point[0], None, None, False, (0.1 - 0.5j, 1.0 + 0.5j))
    start = bars(0.2 + 0.1j)._replace(end=np.array([[0.9 + 0j]]))
    fits = fitted(wanted, start, phi.copy(), {}, 60)
    first = np.sum(np.abs(start.at(phi).point[0] - wanted.points) ** 2)
    assert fits.cost[0] < first / 4
    for pivot in (complex(fits.bars.pivot[0, 0]), complex(fits.bars.end[0, 0])):
        assert 0.1 <= pivot.real <= 1.0
        assert -0.5 <= pivot.imag <= 0.5


def test_the_atlas_holds_turning_cranks_and_tells_their_errors() -> None:
    phi = np.linspace(0, 5, 10)[None, :]
    wanted = Wanted(bars(0j).at(phi).point[0], None, None, False)
    found, angles, errors = atlas(wanted, np.random.default_rng(0), 3000, 50, True)
    assert np.all(found.turns())
    off = np.sqrt(np.mean(np.abs(found.at(angles).point - wanted.points) ** 2, axis=1))
    assert off == pytest.approx(errors, rel=1e-9)
    assert np.all(np.diff(errors) >= 0)


def test_no_two_solutions_are_one() -> None:
    points = slider_crank(np.linspace(0.3, 5.0, 6), 0.1, 0.25, 0.03, 0.1 + 0.08j)
    found = solve_synthesis(SynthesisTask("path", PoseTask("slider_crank", points), solutions=8))
    rows = np.array([[size.value for size in design.sizes if size.unit == "m"] for design in found.designs])
    for k, row in enumerate(rows):
        assert all(np.max(np.abs(row - other)) > 1e-5 * np.max(np.abs(row)) for other in rows[:k])
