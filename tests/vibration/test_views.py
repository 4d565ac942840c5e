"""What a page moves of vibrations: enlarged displacements are those of the stages, between round factors."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tmmcalc.pipeline.picturing import order_of
from tmmcalc.pipeline.runner import run
from tmmcalc.project import load_spec
from tmmcalc.report.moving import Body, View
from tmmcalc.vibration.pictures.vibrator import ASLANT
from tmmcalc.vibration.views import pendulum, vibrator
from tmmcalc.vibration.views.enlarged import SHARE, factor_of

CONFIGS = Path(__file__).parents[2] / "configs"


def shown(name: str, stage: str, module: Any) -> tuple[View, Any, dict[str, Body]]:
    spec = load_spec(CONFIGS / f"{name}.toml")
    found = run(spec, target=[stage]).results
    (view,) = module.views(order_of(spec, found))
    return view, found[stage], {body.name: body for body in view.bodies}


def at(body: Body) -> Any:
    return body.x.values + 1j * body.y.values


@pytest.mark.parametrize("largest", [1e-7, 3e-4, 0.02, 0.9])
def test_factors_are_round(largest: float) -> None:
    factor = factor_of(1.0, largest)
    assert f"{factor:e}"[0] in "125"
    assert factor == 1 or factor * largest <= SHARE * (1 + 1e-12) < 2.5 * factor * largest * (1 + 1e-12)


@pytest.mark.slow
def test_points_of_the_device_go_along_their_ellipses() -> None:
    view, result, bodies = shown("vibratory-device", "vibrator", vibrator)
    factor = float(view.note.rpartition(",")[2].partition(":")[0])
    for path in result.paths:
        expected = (path.at + factor * path.path) @ ASLANT
        np.testing.assert_allclose(at(bodies[f"part {path.name}"]), expected, atol=1e-9)
    for body in view.bodies:
        x = np.gradient(body.x.values, view.values)
        np.testing.assert_allclose(body.x.rates[1:-1], x[1:-1], atol=2e-3 * np.max(np.abs(x)) + 1e-12)


@pytest.mark.slow
def test_the_ring_keeps_in_its_plane_and_its_shape() -> None:
    """Opposite points of the ring move by x, y and a small turn: their middle is that of the ring."""
    view, _, bodies = shown("vibratory-device", "vibrator", vibrator)
    half = vibrator.RIM // 2
    middles = [at(bodies[f"ring {k}"]) + at(bodies[f"ring {k + half}"]) for k in range(half)]
    assert max(np.abs(each - middles[0]).max() for each in middles) < 1e-12
    assert view.whole


def test_the_pendulum_hangs_from_its_carrier_with_its_slope() -> None:
    view, result, bodies = shown("pendulum-rotor", "pendulum", pendulum)
    swing, length = result.swing, float(np.max(result.place))
    factor = float(view.note.rpartition(",")[2].partition(":")[0])
    tip = swing.carrier_x + factor * swing.v
    across = swing.carrier_y + factor * swing.w
    np.testing.assert_allclose(at(bodies["end"]), tip + across * pendulum.DEPTH - 1j * length, atol=1e-12)
    one = pendulum._Pendulum(swing, length)
    np.testing.assert_allclose(one.across(0.0), 0, atol=1e-15)
    step = 1e-6
    slope = (one.across(1.0) - one.across(1 - step)) / (step * length)
    np.testing.assert_allclose(slope, swing.slope_v + 1j * swing.slope_w, atol=1e-4 * np.abs(one.slope).max())
