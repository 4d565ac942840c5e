"""The moment and inertia read at one angle: exact, over many turns, with jumps where they stand."""

from __future__ import annotations

import math

import numpy as np
import pytest

from machine.transient.scenes import PERIOD, Shape, cycle, travel, upsetter
from tmmcalc.core.errors import UsageError
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.transient.pointwise import reader, slopes, stretches, tabulated
from tmmcalc.machine.transient.profile import Profile, profile

RNG = np.random.default_rng(7)
ANGLES = RNG.uniform(-40.0, 40.0, 300)


def read(shape: Profile, factor: float, angle: float, speed: float = 0.0, forward: bool = True) -> tuple[float, ...]:
    k, base = shape.place(angle, forward)
    return reader(stretches(shape, factor)[k], base)(angle, speed)


def jumpy(p: np.ndarray) -> np.ndarray:
    x = p % PERIOD
    return 40 * np.sin(x) - np.where((x > 1.0) & (x < 2.5), 300 + 50 * np.cos(3 * x), 0.0)


def inertia(p: np.ndarray) -> np.ndarray:
    return 0.7 + 0.3 * np.cos(2 * p) + 0.1 * np.sin(3 * p)


def slope(p: np.ndarray) -> np.ndarray:
    return -0.6 * np.sin(2 * p) + 0.3 * np.cos(3 * p)


def test_values_at_any_angle() -> None:
    shape = profile(cycle(jumpy, inertia, (1.0, 2.5)))
    values = np.array([read(shape, 1.0, angle) for angle in ANGLES])
    np.testing.assert_allclose(values[:, 0], inertia(ANGLES), atol=1e-13)
    np.testing.assert_allclose(values[:, 1], slope(ANGLES), atol=1e-11)
    np.testing.assert_allclose(values[:, 2], jumpy(ANGLES), atol=350 * 1e-12)


def test_a_smooth_cycle_has_no_breaks_and_wraps() -> None:
    shape = profile(cycle(lambda p: np.exp(np.sin(p)), inertia))
    assert shape.wraps
    assert len(shape.starts) == 2
    values = np.array([read(shape, 2.0, angle) for angle in ANGLES])
    np.testing.assert_allclose(values[:, 2], 2 * np.exp(np.sin(ANGLES)), atol=1e-12)


def test_the_slope_belongs_to_the_very_inertia() -> None:
    """The integral of the slope over a piece is the difference of the inertia to rounding, whatever the panels."""
    shape = profile(cycle(0.0, lambda p: 1 / (1.2 + np.cos(p)), (1.0,)))
    edges = np.linspace(0.3, 0.35, 2)
    node, weight = np.polynomial.legendre.leggauss(12)
    at = edges[0] + (node + 1) / 2 * (edges[1] - edges[0])
    gained = sum(w * read(shape, 1.0, x)[1] for w, x in zip(weight, at, strict=True)) * (edges[1] - edges[0]) / 2
    assert gained == pytest.approx(read(shape, 1.0, edges[1])[0] - read(shape, 1.0, edges[0])[0], abs=3e-16)


KINKS = [
    ("jump", lambda x: np.where(x < 2.0, 1.0, 2.0), True),
    ("small jump", lambda x: np.where(x < 2.0, 1.0, 1.0 + 1e-8), True),
    ("kink", lambda x: np.abs(x - 2.0), True),
    ("curvature", lambda x: np.where(x < 2.0, 1.0, 1.0 + (x - 2.0) ** 2), True),
    ("smooth", lambda x: np.cos(x - 2.0), False),
]


@pytest.mark.parametrize(("name", "moment", "broken"), KINKS, ids=[k[0] for k in KINKS])
def test_breaks_stand_at_jumps_and_kinks_alone(name: str, moment: Shape, broken: bool) -> None:
    shape = profile(cycle(lambda p: np.sin(p) ** 4 * moment(p), 0.0, (1.0, 2.0)))
    angles = [float(shape.edges[s]) % PERIOD for s in shape.starts[:-1]]
    assert angles == ([2.0] if broken else [0.0])


def test_both_sides_of_a_jump() -> None:
    shape = profile(cycle(jumpy, inertia, (1.0, 2.5)))
    for turns in (-3, 0, 5):
        edge = 1.0 + turns * PERIOD
        assert read(shape, 1.0, edge, forward=False)[2] == pytest.approx(40 * math.sin(1), abs=1e-10)
        after = 40 * math.sin(1) - 300 - 50 * math.cos(3)
        assert read(shape, 1.0, edge, forward=True)[2] == pytest.approx(after, abs=1e-10)


def test_a_stretch_goes_on_smoothly_beyond_its_ends() -> None:
    shape = profile(cycle(jumpy, inertia, (1.0, 2.5)))
    k, base = shape.place(2.0, True)
    look = reader(stretches(shape, 1.0)[k], base)
    for edge, out in ((1.0, -1), (2.5, 1)):
        step = 1e-3 * out
        beyond = look(edge + step, 0.0)[2]
        # the parabola leaves the function by its third derivative, about 1400
        assert beyond == pytest.approx(40 * math.sin(edge + step) - 300 - 50 * math.cos(3 * (edge + step)), abs=1e-6)
        assert look(edge + step, 0.0)[1] == pytest.approx(slope(np.array(edge + step)), abs=1e-5)


def test_the_factor_multiplies_the_technological_load_alone() -> None:
    shape = profile(upsetter(1.0), upsetter(0.0))
    for factor in (0.0, 0.3, 2.0):
        for angle in (0.4, 3.0, 4.0):
            force = factor * 3040 * (angle**2 if angle < math.pi else 0.0) - 300
            assert read(shape, factor, angle)[2] == pytest.approx(force * travel(angle), abs=1e-10)
    assert shape.unloaded == (False, True)  # the technological load begins at 0 and ends at 180 degrees
    assert [float(shape.edges[s]) for s in shape.starts] == pytest.approx([0.0, math.pi, PERIOD], abs=1e-15)


def test_an_idle_cycle_on_panels_of_its_own() -> None:
    def load(p: np.ndarray) -> np.ndarray:
        return np.where(p > 4.0, -90.0, 0.0)

    loaded, idle = cycle(lambda p: np.sin(p) + load(p), 0.5, (4.0,)), cycle(np.sin, 0.5, (2.2,))
    shape = profile(loaded, idle)
    for angle in (1.0, 3.0, 5.0):
        expected = math.sin(angle) + 0.25 * float(load(np.array(angle)))
        assert read(shape, 0.25, angle)[2] == pytest.approx(expected, abs=1e-12)


def test_moments_that_depend_on_the_speed() -> None:
    shape = profile(cycle(3.0, 0.2, (), viscous=np.sin, quadratic=np.cos))
    value = read(shape, 0.5, 1.0, 4.0)[2]
    assert value == pytest.approx(0.5 * (3 + 4 * math.sin(1) + 16 * math.cos(1)), abs=1e-13)


def test_a_four_stroke_cycle() -> None:
    shape = profile(cycle(lambda p: np.sin(p / 2), 0.0, period=2 * PERIOD))
    assert read(shape, 1.0, 9.0 + 6 * PERIOD)[2] == pytest.approx(math.sin(4.5 + 3 * PERIOD), abs=1e-12)


def test_tables_and_partial_derivatives_agree_with_the_reader() -> None:
    shape = profile(cycle(jumpy, inertia, (1.0, 2.5), viscous=np.sin, quadratic=np.cos))
    places = [shape.place(angle, True) for angle in ANGLES]
    index, base = np.array([p[0] for p in places]), np.array([p[1] for p in places])
    speed, factor = np.full(300, 1.7), np.full(300, 0.6)
    table = np.array(tabulated(shape, ANGLES, speed, factor, index, base)).T
    np.testing.assert_allclose(table, [read(shape, 0.6, a, 1.7) for a in ANGLES], rtol=1e-12, atol=1e-11)
    h = 1e-5
    for angle, (k, turn) in zip(ANGLES[:40], places[:40], strict=True):
        look, at = reader(stretches(shape, 0.6)[k], turn), slopes(shape, k, turn, 0.6, angle, 1.7)
        assert (at.inertia, at.d_inertia, at.load) == pytest.approx(look(angle, 1.7), abs=1e-11)
        rise = [(p - m) / (2 * h) for p, m in zip(look(angle + h, 1.7), look(angle - h, 1.7), strict=True)]
        assert (at.d2_inertia, at.d_angle) == pytest.approx(rise[1:], abs=1e-5)
        assert at.d_speed == pytest.approx((look(angle, 1.7 + h)[2] - look(angle, 1.7 - h)[2]) / (2 * h), abs=1e-8)


def test_no_cycle_at_all() -> None:
    shape = profile(None)
    assert read(shape, 1.0, 123.4, 5.0) == (0.0, 0.0, 0.0)


def test_cycles_of_two_mechanisms_are_refused() -> None:
    with pytest.raises(UsageError, match="period"):
        profile(cycle(1.0), cycle(1.0, period=2 * PERIOD))


def test_the_given_slope_of_a_cycle_is_not_needed() -> None:
    given = cycle(0.0, inertia)
    wrong = Cycle(given.panels, given.inertia, 0 * given.slope, given.moment, given.viscous, given.quadratic, 1.0)
    assert read(profile(wrong), 1.0, 1.3)[1] == pytest.approx(float(slope(np.array(1.3))), abs=1e-11)
