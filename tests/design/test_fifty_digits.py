"""Sensitivities against differences in fifty digits of what theory says in closed form, or but for one root."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import mpmath as mp
import pytest

from tmmcalc.design.sensitivity import sensitivity
from tmmcalc.design.sensitivity_document import sensitivity_document

HERE = Path(__file__).parent
CONFIGS = HERE.parents[1] / "configs"

Function = Callable[..., Any]


def slopes(f: Function, at: list[float | str]) -> list[float]:
    """Derivatives by central differences in fifty digits, right to some thirty of them."""
    with mp.workdps(50):
        h, place = mp.mpf(10) ** -15, [mp.mpf(value) for value in at]

        def moved(k: int, step: Any) -> Any:
            return f(*(value + step * (i == k) for i, value in enumerate(place)))

        return [float((moved(k, h) - moved(k, -h)) / (2 * h)) for k in range(len(place))]


def check(config: Path, name: str, keys: list[str], expected: list[float], sets: tuple[str, ...] = ()) -> None:
    """The derivatives agree to the aim, and within what the program says of its errors."""
    found = sensitivity(config, [name], keys, sets)
    assert len(found.partials) == len(keys)
    for each, truth in zip(found.partials, expected, strict=True):
        assert each.slope.side == "both", each.key
        assert each.slope.value == pytest.approx(truth, rel=1e-9, abs=1e-12), each.key
        assert abs(each.slope.value - truth) <= 3 * each.slope.error + 1e-14 * abs(truth), each.key


def centre_distance(x_1: Any, x_2: Any, module: Any) -> Any:
    """Of a pair of 17 and 40 teeth: inv alpha_w = inv alpha + 2 tan alpha (x_1 + x_2) / (z_1 + z_2)."""
    alpha, z = mp.radians(20), 57
    involute = mp.tan(alpha) - alpha + 2 * mp.tan(alpha) * (x_1 + x_2) / z
    alpha_w = mp.findroot(lambda a: mp.tan(a) - a - involute, mp.mpf("0.4"))
    return module * z * mp.cos(alpha) / (2 * mp.cos(alpha_w))


def test_the_centre_distance_of_a_gear_pair() -> None:
    sets = ("pair.x1=0.31", "pair.x2=0.22", 'pair.strategy="given"')
    expected = slopes(lambda a, b, m: centre_distance(a, b, m / 1000), ["0.31", "0.22", "4"])
    check(CONFIGS / "pair.toml", "pair.a_w", ["pair.x1", "pair.x2", "pair.module"], expected, sets)


def needed(stroke: Any, rise: Any, limit: Any) -> Any:
    """Least radius of a cam with a central follower: the largest of s' / tan theta - s, of the cosine law [m]."""
    whole, tangent = mp.radians(rise), mp.tan(mp.radians(limit))
    p = mp.atan(mp.pi / (whole * tangent))  # where s'' / tan theta = s'
    return stroke / 2 * (mp.pi / whole * mp.sin(p) / tangent - (1 - mp.cos(p)))


@pytest.mark.slow
def test_the_least_radius_of_a_cam() -> None:
    expected = slopes(lambda h, rise, limit: needed(h / 1000, rise, limit), [30, 90, 30])
    keys = ["cam.stroke", "cam.rise", "cam.limits.pressure_angle"]
    sets = ("cam.offset=0", "cam.limits.pressure_angle_return=false")
    check(CONFIGS / "cam-synthesis.toml", "cam_synthesis.R0", keys, expected, sets)


def inertia(speed: Any, second: Any, third: Any, delta: Any) -> Any:
    """Of a flywheel: the range of the work of -second sin 2 t + third cos 3 t, over delta omega^2."""

    def work(t: Any) -> Any:
        return second / 2 * mp.cos(2 * t) * -1 + third / 3 * mp.sin(3 * t)

    def moment(t: Any) -> Any:
        return second * mp.sin(2 * t) + third * mp.cos(3 * t)

    rows = [mp.pi * k / 180 for k in range(360)]
    high, low = (mp.findroot(moment, best(rows, key=work)) for best in (max, min))
    return (work(high) - work(low)) / (delta * (speed * mp.pi / 30) ** 2)


@pytest.mark.slow
def test_the_flywheel_of_a_torque_diagram() -> None:
    keys = ["torque.speed", "torque.harmonics.terms[0].sin", "torque.harmonics.terms[1].cos", "flywheel.delta"]
    check(HERE / "torque.toml", "flywheel.J_F", keys, slopes(inertia, [100, -90, 40, "0.05"]))


def folded(crank: Any, coupler: Any) -> Any:
    """Least transmission angle of a four-bar with the frame 700 mm and the rocker 300 mm [deg], the crank inside."""
    apart = 700 - crank
    return mp.degrees(mp.acos((coupler**2 + 300**2 - apart**2) / (2 * coupler * 300)))


def test_near_a_dead_point_the_derivative_is_right_and_it_is_said_how_far_it_holds() -> None:
    """The links are 0.1 mm from folding, where the angle goes as a root: no step of a tenth of a per cent is left."""
    keys = ["mechanism.links[id=1].points.A[0]", "mechanism.links[id=2].points.B[0]"]
    name, sets = "kinematics.transmission_min_RRR(2,3)[deg]", [f'{keys[1]}="899.9 mm"']
    found = sensitivity(CONFIGS / "four-bar.toml", [name], keys, sets)
    for each, truth in zip(found.partials, slopes(folded, [100, "899.9"]), strict=True):
        assert each.way == "exact"
        assert each.slope.value == pytest.approx(truth, rel=1e-9)
        assert abs(each.slope.value - truth) <= 3 * each.slope.error
        assert each.slope.side == "none"
    assert {each.key.partition("[mm]")[0] for each in found.reaches} == {*keys}
    told = sensitivity_document(found, "four-bar").parts[0].notes
    assert all("holds for the least of changes alone" in note for note in told)
