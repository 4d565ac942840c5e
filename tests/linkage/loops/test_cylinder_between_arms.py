"""A cylinder between two moving arms: closed forms, the bars solved by scipy, forces by virtual power, dead points."""

from __future__ import annotations

from math import asin, cos, hypot, radians, sin, sqrt
from pathlib import Path

import numpy as np
import pytest
from scipy.optimize import fsolve

import tmmcalc
from tmmcalc.core.errors import TmmError
from tmmcalc.project import Spec, templates

FILE = templates.folder() / "scissor-lift.toml"
ARM, AHEAD = 1.6, 1.1  # length of an arm; how far F stands ahead of E along the parallel arms 3 and 4
SPEED, LOAD, G = 0.03, 4000.0, 9.81
BENT = (  # a lift whose arms are neither straight nor alike
    'mechanism.links[id=2].points={ A = [0, 0], M = ["810 mm", "25 mm"], C = ["1580 mm", 0] }',
    'mechanism.links[id=3].points={ O = [0, 0], E = ["220 mm", "-60 mm"], M = ["790 mm", 0], D = ["1600 mm", 0] }',
    'mechanism.links[id=4].points={ C = [0, 0], N = ["820 mm", 0], F = ["1290 mm", "70 mm"], K = ["1620 mm", 0] }',
    'mechanism.links[id=5].points={ D = [0, 0], N = ["780 mm", "15 mm"], H = ["1600 mm", 0] }',
)


def lift(*overrides: str) -> Spec:
    return tmmcalc.load_spec(FILE, overrides)


def slope_of(s: float) -> tuple[float, float]:
    """Angle of the arms by the length of the cylinder, EF^2 = d^2 + L (L + 2 d) sin^2, and its derivative."""
    angle = asin(sqrt((s * s - AHEAD**2) / (ARM * (ARM + 2 * AHEAD))))
    return angle, s / (ARM * (ARM + 2 * AHEAD) * sin(angle) * cos(angle))


def test_structure() -> None:
    """Neither link of the drive is at the frame; all that it closes is one group."""
    found = tmmcalc.solve_structure(lift())
    assert found.formula == "V D(1,2,3,4,5,8,9) -> II RPR(6,7)"
    assert found.mobility == 3 * 9 - 2 * 13 == 1
    driven = found.driven
    assert driven is not None
    assert (driven.drive, driven.outer) == ("Z", ("A0", "O"))
    assert 3 * len(driven.links) == 2 * (len(driven.inner) + len(driven.outer)) + 1


def test_closed_form_of_straight_arms() -> None:
    found = tmmcalc.solve_kinematics(lift())
    moved = found.trace
    arm, p = moved.link_ids.index(3), moved.point_names.index("P")
    for k, s in enumerate(found.x):
        angle, rate = slope_of(float(s))
        assert moved.angle[arm, k] == pytest.approx(angle, abs=1e-13)
        assert moved.dangle[arm, k] == pytest.approx(rate, rel=1e-12)
        assert moved.r[p, k] == pytest.approx(complex(1.7, 2 * ARM * sin(angle) + 0.08), abs=1e-13)
        assert moved.dr[p, k] == pytest.approx(complex(0, 2 * ARM * cos(angle) * rate), abs=1e-12)
    low, high = found.domain.intervals[0].low, found.domain.intervals[0].high
    assert (low, high) == pytest.approx((AHEAD, ARM + AHEAD), abs=1e-12)


def test_force_of_a_light_lift() -> None:
    """F ds = W dy of the load alone: without weights it is 2 W s/((L + 2 d) sin)."""
    weightless = [f"mechanism.links[id={k}].{key}=0" for k in range(1, 10) for key in ("mass",)]
    still = [f"mechanism.links[id={k}].inertia=0" for k in (2, 3, 4, 5, 6, 8, 9)]
    found = tmmcalc.solve_forces(lift(*weightless, *still))
    for phi, force in zip(found.phi, found.drive, strict=True):
        s = 1.18 + float(phi)
        assert force == pytest.approx(2 * LOAD * s / ((ARM + 2 * AHEAD) * sin(slope_of(s)[0])), rel=1e-10)


class Bars:
    """The lift as bars: angles of the four arms and the place of the foot from the length of the cylinder."""

    def __init__(self, spec: Spec) -> None:
        self.links = {link.id: link for link in spec.mechanism.links}
        self.at: dict[int, dict[str, complex]] = {
            k: {name: complex(*point) for name, point in link.points.items()} for k, link in self.links.items()
        }
        self.guess = np.array([1.575, np.pi - 0.174, 0.174, 0.174, np.pi - 0.174])

    def places(self, q: np.ndarray) -> dict[str, tuple[complex, complex]]:
        """Origin and direction of every link; 8 and 9 along the cylinder."""
        foot, *angles = q
        turn = dict(zip((2, 3, 4, 5), np.exp(1j * np.asarray(angles)), strict=True))
        found = {"1": (complex(foot), 1 + 0j), "2": (complex(foot), turn[2]), "3": (0j, turn[3])}
        found["4"] = (foot + turn[2] * self.at[2]["C"], turn[4])
        found["5"] = (turn[3] * self.at[3]["D"], turn[5])
        low, high = turn[3] * self.at[3]["E"], found["4"][0] + turn[4] * self.at[4]["F"]
        along = (high - low) / abs(high - low)
        found |= {"8": (high, along), "9": (low, along)}
        top = found["5"][0] + turn[5] * self.at[5]["H"]
        roller = found["4"][0] + turn[4] * self.at[4]["K"]
        found["6"] = (top, (roller - top) / abs(roller - top))
        return found | {"7": (roller, found["6"][1])}

    def gaps(self, q: np.ndarray, s: float) -> np.ndarray:
        at, places = self.at, self.places(q)

        def on(link: int, name: str) -> complex:
            origin, turn = places[str(link)]
            return origin + turn * at[link][name]

        pins = on(2, "M") - on(3, "M"), on(4, "N") - on(5, "N")
        return np.array([pins[0].real, pins[0].imag, pins[1].real, pins[1].imag, abs(on(4, "F") - on(3, "E")) - s])

    def solve(self, s: float) -> dict[str, tuple[complex, complex]]:
        q, _, done, _ = fsolve(self.gaps, self.guess, (s,), full_output=True, xtol=1e-14)
        assert done == 1 or np.abs(self.gaps(q, s)).max() < 1e-12
        self.guess = q
        return self.places(q)

    def state(self, s: float) -> np.ndarray:
        """Centres of mass and angles of all links, (9, 3)."""
        places = self.solve(s)
        rows = []
        for k in range(1, 10):
            origin, turn = places[str(k)]
            centre = origin + turn * complex(*self.links[k].center)
            rows.append((centre.real, centre.imag, float(np.angle(turn))))
        return np.array(rows)


@pytest.mark.slow
def test_bent_arms_against_scipy() -> None:
    """Positions by fsolve, the reduced mass, weight and force of the drive from differences of these positions."""
    spec = lift(*BENT)
    moved = tmmcalc.solve_kinematics(spec)
    forces, reduction = tmmcalc.solve_forces(spec), tmmcalc.solve_reduction(spec)
    bars, step = Bars(spec), 1e-3
    mass = np.array([bars.links[k].mass for k in range(1, 10)])
    inertia = np.array([bars.links[k].inertia or 0.0 for k in range(1, 10)])
    p = moved.trace.point_names.index("P")

    def turned(a: np.ndarray, b: np.ndarray) -> np.ndarray:
        change = a - b
        change[:, 2] = np.angle(np.exp(1j * change[:, 2]))
        return change

    def tip(s: float) -> complex:
        origin, turn = bars.solve(s)["6"]
        return origin + turn * bars.at[6]["P"]

    def slope(s: float) -> np.ndarray:
        near, far = (turned(bars.state(s + h), bars.state(s - h)) / (2 * h) for h in (step, 2 * step))
        return (4 * near - far) / 3

    def reduced(s: float) -> float:
        rate = slope(s)
        return float(mass @ (rate[:, 0] ** 2 + rate[:, 1] ** 2) + inertia @ rate[:, 2] ** 2)

    for k, s in list(enumerate(map(float, moved.x)))[::3]:
        assert moved.trace.r[p, k] == pytest.approx(tip(s), abs=1e-10)
        rise = [(tip(s + h) - tip(s - h)).imag / (2 * h) for h in (step, 2 * step)]
        load = LOAD * (4 * rise[0] - rise[1]) / 3
        weight = G * float(mass @ slope(s)[:, 1])
        change = (reduced(s + step) - reduced(s - step)) / (2 * step)
        assert reduction.inertia[k] == pytest.approx(reduced(s), rel=2e-7)
        assert reduction.total[k] == pytest.approx(-(load + weight), rel=2e-7)
        assert forces.drive[k] == pytest.approx(load + weight + change * SPEED**2 / 2, rel=2e-7)
    assert np.abs(forces.virtual).max() < 1e-12


def test_cylinder_takes_force_alone_between_its_pins() -> None:
    """The rod with no weight is a two-force body: the reaction of its pin is the drive, along the cylinder."""
    light = [f"mechanism.links[id={k}].{key}=0" for k in (8, 9) for key in ("mass", "inertia")]
    found = tmmcalc.solve_forces(lift(*light))
    names = [pair.joint for pair in found.pairs]
    for name in ("E", "F"):
        assert np.abs(found.reaction[names.index(name)]) == pytest.approx(found.drive, rel=1e-10)
    assert np.abs(found.normal[names.index("Z")]).max() < 1e-9 * found.drive.max()


@pytest.mark.slow
def test_retracting_is_the_same_motion_backwards() -> None:
    out = tmmcalc.solve_forces(lift())
    back = tmmcalc.solve_forces(lift('mechanism.input.speed="-30 mm/s"', 'mechanism.input.start="2.02 m"'))
    assert back.drive[::-1] == pytest.approx(out.drive, rel=1e-10)
    assert back.power[::-1] == pytest.approx(-out.power, rel=1e-10)


@pytest.mark.parametrize(
    ("override", "told"),
    [
        ('mechanism.input.start="1.05 m"', "it assembles for s_Z in [1100, 2700] mm only"),
        ('mechanism.grid.span="1.6 m"', "at s_Z = 1100 and 2700 mm: its links come to a limit position"),
    ],
)
def test_dead_points_are_named(override: str, told: str) -> None:
    """The cylinder is flat on the arms, or the arms stand upright."""
    with pytest.raises(TmmError) as error:
        tmmcalc.solve_forces(lift(override))
    assert told in str(error.value)
    assert "D(1,2,3,4,5,8,9)" in str(error.value)


def test_force_grows_without_limit_towards_the_dead_point() -> None:
    """As the arms come to lie flat the force goes as 1/sin of their angle; slowly, for the arms would be thrown up."""
    slow = 'mechanism.input.speed="1e-6 m/s"'
    near = tmmcalc.solve_forces(lift(slow, 'mechanism.input.start="1100.1 mm"', 'mechanism.grid.span="1 mm"'))
    sines = np.array([sin(slope_of(1.1001 + float(phi))[0]) for phi in near.phi])
    s = 1.1001 + near.phi
    products = near.drive * sines / s
    assert near.drive[0] > 10 * 20209
    assert np.ptp(products[4:]) < 0.01 * products[-1]


RISE = """
[unsteady]
output = "P"
from = "0.7 m"
to = "2.2 m"
speed = "30 mm/s"
acceleration = "20 mm/s^2"
"""


@pytest.mark.slow
def test_from_rest_to_rest_though_the_platform_only_translates(tmp_path: Path) -> None:
    """The platform's angle is zero but for rounding, which is no motion that has to be followed."""
    (tmp_path / "rise.toml").write_text(FILE.read_text() + RISE)
    found = tmmcalc.solve_unsteady(tmmcalc.load_spec(tmp_path / "rise.toml"))
    told = {extreme.name: extreme for extreme in found.extremes}
    assert (told["omega_6"].least, told["omega_6"].largest) == (0, 0)
    assert (told["eps_7"].least, told["eps_7"].largest) == (0, 0)
    heights = [sin(slope_of(float(s))[0]) * 2 * ARM + 0.08 for s in (found.start, found.end)]
    assert heights == pytest.approx([0.7, 2.2], abs=1e-9)
    x, v, _ = found.drive
    k = int(np.argmax(v * [slope_of(float(s))[1] for s in x]))
    assert told["omega_3"].largest == pytest.approx(float(v[k]) * slope_of(float(x[k]))[1], rel=1e-9)
    assert told["v"].largest == pytest.approx(SPEED)


def test_one_storey_by_hand() -> None:
    """E on arm 2, F on arm 3 of a single scissor: cosines of the triangle EMF give the angle of the arms."""
    single = lift(
        'mechanism.links[id=3].points={ O = [0, 0], E = ["250 mm", 0], M = ["800 mm", 0], D = ["1600 mm", 0] }'
    )
    found = tmmcalc.solve_kinematics(single)
    ahead = 1.3 - 0.25
    arm = found.trace.link_ids.index(3)
    for k, s in enumerate(found.x):
        sine = sqrt((float(s) ** 2 - ahead**2) / (ARM * (ARM + 2 * ahead)))
        assert found.trace.angle[arm, k] == pytest.approx(asin(sine), abs=1e-12)
        e = 0.25 * np.exp(1j * asin(sine))
        f = 1j * ARM * sine + 1.3 * np.exp(1j * asin(sine))
        assert hypot((f - e).real, (f - e).imag) == pytest.approx(float(s), abs=1e-12)
    assert radians(60) > found.trace.angle[arm].max() > radians(30)
