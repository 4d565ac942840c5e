"""What the errors of extreme scenes name, derived without the program: numbers in their words, what is refused."""

from __future__ import annotations

import math
import re
import tomllib
from typing import Any

import mpmath
import numpy as np
import pytest
from mpmath import mpf
from sparing import sparing

from tmmcalc.stress.expected import Expected, expected

from .scenes import FOLDER, NAMES, solved
from .truth import TURN, Induction, Pressed, Slider, passes

KNOWN: dict[str, Any] = {name: getattr(mpmath, name) for name in dir(mpmath) if not name.startswith("_")}
NUMBER = re.compile(r"(?<![\w.])-?\d+(?:\.\d+)?(?:e[-+]\d+)?(?!\w)")  # not in a name such as l_3


def wanted(name: str) -> Expected:
    return expected((FOLDER / f"{name}.toml").read_text(encoding="utf-8"))


GIVEN = "given "  # before the place of a number that the error repeats from the spec
ELSEWHERE = {"stall-peak", "contour-empty"}  # proved below: by an integrator, by a scan of all shifts


def derived(name: str) -> list[str]:
    """The formulas that prove something."""
    return [formula for formula in wanted(name).formulas if not formula.startswith(GIVEN)]


PROVED = [name for name in NAMES if derived(name)]


def test_numbers_in_errors_have_their_formulas() -> None:
    """And no formula is but the number itself."""
    numbered = {name for name in NAMES if NUMBER.search(wanted(name).words)}
    assert len(PROVED) >= 10
    assert numbered - set(PROVED) == ELSEWHERE
    bare = re.compile(r"-?(?:mpf\()?'?[-\d.e+]*'?\)?")
    assert not [(name, formula) for name in NAMES for formula in wanted(name).formulas if bare.fullmatch(formula)]


@pytest.mark.parametrize("name", sorted({*PROVED, "contour-empty"}))
def test_numbers_in_errors_are_those_of_their_formulas(name: str) -> None:
    """To the last digit that is printed."""
    told = wanted(name)
    printed = NUMBER.findall(told.words)
    assert len(printed) == len(told.formulas)
    with mpmath.workdps(30):
        for number, formula in zip(printed, told.formulas, strict=True):
            digits = len(number.partition(".")[2])
            value = given(name, formula) if formula.startswith(GIVEN) else eval(formula, dict(KNOWN))
            assert abs(value - mpf(number)) <= mpf(10) ** -digits / 2 * (1 + mpf("1e-9"))


def given(name: str, formula: str) -> mpf:
    """A number of the spec in the unit that it is written in, by its place."""
    here: Any = tomllib.loads((FOLDER / f"{name}.toml").read_text(encoding="utf-8"))
    for key in formula.removeprefix(GIVEN).split("."):
        here = here[int(key)] if isinstance(here, list) else here[key]
    return mpf(str(here).partition(" ")[0])


def test_no_shifts_of_five_teeth_reach_the_contact_ratio() -> None:
    """Contact ratios of all shifts without undercut up to 3 modules, their tips as high as the clearance allows."""
    z, alpha = 5, math.radians(20)
    least = 1 - z * math.sin(alpha) ** 2 / 2
    x1, x2 = np.meshgrid(*2 * [np.linspace(least, 3.0, 240)])
    target = math.tan(alpha) - alpha + 2 * (x1 + x2) * math.tan(alpha) / (2 * z)
    angle = np.full_like(target, 1.0)
    for _ in range(60):  # Newton from above, where tan(a) - a is convex
        angle -= (np.tan(angle) - angle - target) / np.tan(angle) ** 2
    apart = z * math.cos(alpha) / np.cos(angle)  # modules
    shortened = x1 + x2 - (apart - z)
    ratio = np.zeros_like(angle)
    for x in (x1, x2):
        tip = z / 2 + 1 + x - shortened
        ratio += z * (np.sqrt((tip / (z / 2 * math.cos(alpha))) ** 2 - 1) - np.tan(angle)) / TURN
    assert np.max(ratio) < 1.9


@pytest.mark.slow
def test_the_critical_speed_is_that_of_the_differential_equation() -> None:
    """Forward whirl at the speed of the spin: E I z'''' - (N z')' - W (mu z + mu i^2 z'') = 0 as a power series.

    N is the weight below, W = Omega^2; at the pivot z = 0 and E I z'' = k z', at the disc its inertia and tilting.
    """
    with mpmath.workdps(40):
        root = mpmath.findroot(boundary, (mpf("4.25"), mpf("4.26")), solver="secant")
        assert abs(root - mpf("4.25602870649083856")) < mpf("1e-17")
        spin = re.search(r'spin = "(.+) rad/s"', (FOLDER / "pendulum-critical.toml").read_text(encoding="utf-8"))
        assert spin is not None
        assert abs(mpf(spin[1]) - root) < mpf("1e-14")
    assert wanted("pendulum-critical").words.startswith("is a critical speed")


def boundary(spin: mpf) -> mpf:
    """Determinant of the two conditions at the disc, for the two motions that the pivot allows."""
    length, mass, gyration, pivot = mpf("0.8"), mpf(4), mpf("0.055"), mpf(15)
    section, square = mpmath.pi * mpf("0.012") ** 2 / 4, spin**2
    bending, line = mpf("206e9") * mpmath.pi * mpf("0.012") ** 4 / 64, 7850 * section
    turning = line * mpf("0.012") ** 2 / 16  # mu i^2
    hung = mpf("9.81") * line

    def at_disc(slope: mpf, third: mpf) -> tuple[mpf, mpf]:
        c = [mpf(0), slope, pivot * slope / bending / 2, third / 6]
        pull = hung * length + mpf("9.81") * mass + turning * square
        for n in range(120):
            falling = pull * (n + 2) * (n + 1) * c[n + 2] - hung * (n + 1) * c[n + 1] * (1 + n)
            c.append((falling + square * line * c[n]) / (bending * (n + 4) * (n + 3) * (n + 2) * (n + 1)))
        z, z1, z2, z3 = (
            mpmath.fsum(c[n] * mpmath.ff(n, k) * length ** (n - k) for n in range(k, len(c))) for k in range(4)
        )
        tilting = bending * z2 + mass * gyration**2 * square * z1
        return tilting, -bending * z3 + (mpf("9.81") * mass + turning * square) * z1 - mass * square * z

    one, other = at_disc(mpf(1), mpf(0)), at_disc(mpf(0), mpf(1))
    return one[0] * other[1] - one[1] * other[0]


def test_where_the_machine_stalls() -> None:
    """Both motions reach the synchronous speed before the load, and then lose their energy over the angle."""
    load, driven = (
        Pressed(Slider(), 8000, math.radians(60), math.radians(120)),
        Induction(550, 1410 / 20 * TURN / 60, 2.5 * math.pi),
    )
    stopped = passes(load, driven, 0.2)
    assert stopped is not None
    told = [value for value in wanted("no-start").values if value.name == "transient.towards the load.end_angle[deg]"]
    assert math.degrees(stopped) == pytest.approx(told[0].value, rel=told[0].tolerance)
    assert wanted("stall-peak").words == f"the machine stalls at {math.degrees(stopped):.6g} deg of cycle 1"


@sparing("beyond", [1e-3, 1e-4, 1e-5], every=3)
def test_an_undercut_crosses_itself_once_a_cusp(beyond: float) -> None:
    """About the sharpest place 1 - kappa r is a parabola with zeros -a and a: the curve meets at +-sqrt(3) a."""
    profile = undercut(beyond)
    assert len(profile.working.loops) == len(profile.working.crossings) == 2
    for (begin, end), crossing in zip(sorted(profile.working.loops), profile.working.crossings, strict=True):
        between = (crossing.second - crossing.first) / (end - begin)
        assert between == pytest.approx(math.sqrt(3), rel=3 * math.sqrt(beyond))


@sparing("beyond", [1e-6, 1e-7, 1e-9, 3e-11], every=4)
def test_an_undercut_too_small_to_cross_is_told_by_its_angles(beyond: float) -> None:
    """Their width goes as the root of what is beyond; the loop itself is below rounding."""
    profile = undercut(beyond)
    assert not profile.working.crossings
    wide = undercut(1e-5).working.loops[0]
    for begin, end in profile.working.loops:
        assert end - begin == pytest.approx((wide[1] - wide[0]) * math.sqrt(beyond / 1e-5), rel=1e-2 + 1e-13 / beyond)


def undercut(beyond: float) -> Any:
    radius = 0.023987551478063914 * (1 + beyond)
    return solved("cusp-near", f"cam.roller_radius={radius!r}", "cam.refuse=false", target="cam_profile").results[
        "cam_profile"
    ]
