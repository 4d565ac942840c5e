"""A wheel without a mate: against the wheels of pairs, worked cases, its own outline, formulas of ISO 21771."""

from dataclasses import replace
from math import acos, atan, cos, pi, radians, tan

import numpy as np
import pytest
from mpmath import mp
from scipy.optimize import brentq, minimize_scalar

import tmmcalc
from gears.involute.cases import case
from gears.meshing.pairs import MM
from tmmcalc.core.errors import NoSolutionError
from tmmcalc.gears.involute.internal.ring import Cutter
from tmmcalc.gears.meshing.members import members
from tmmcalc.gears.meshing.outlines import track
from tmmcalc.gears.meshing.task import WheelMeasuring
from tmmcalc.gears.single.errors import single_error
from tmmcalc.gears.single.member import SingleMember
from tmmcalc.gears.single.results import SingleWheel
from tmmcalc.gears.single.solve import solve_single
from tmmcalc.gears.single.task import WheelTask
from tmmcalc.project import templates

SIZES = (
    *("reference", "tip", "root", "base", "form", "thickness", "tip_thickness", "arc", "tip_arc", "half_angle"),
    *("least_shift", "least_teeth", "limit", "pointing"),
)


def wheel(z: int, m: float = 5.0, *, body: str = "balls", ball: float | None = None, **more) -> SingleWheel:
    """Lengths in mm, the helix angle in degrees."""
    asked = WheelMeasuring("1", m * MM, ball=None if ball is None else ball * MM, body=body)
    helix = radians(more.pop("helix", 0.0))
    for key in ("tip", "face_width"):
        if key in more:
            more[key] *= MM
    return solve_single(WheelTask(z, m * MM, asked, helix=helix, **more))


@pytest.mark.parametrize("name", ["pair", "pair-helical", "pair-spur", "pair-internal"])
def test_every_number_is_that_of_the_wheel_in_a_pair(name: str) -> None:
    """With the tip circles of the pair; only what the mate touches differs."""
    found = tmmcalc.solve_pairs(tmmcalc.load_spec(templates.folder() / f"{name}.toml"))
    for number, (size, measured, member) in enumerate(
        zip(found.pairs[0].sizes, found.pairs[0].measures, members(found), strict=True), 1
    ):
        of_pair = found.pairs[0].task
        alone = solve_single(
            WheelTask(
                size.teeth,
                of_pair.module,
                of_pair.measuring_of(number),
                kind="internal" if size.kind == "ring" else "external",
                shift=size.shift,
                helix=of_pair.helix,
                rack=of_pair.rack,
                tip=size.tip,
                cutter=of_pair.cutter if size.kind == "ring" else None,
                face_width=of_pair.face_width,
            )
        )
        for key in SIZES:
            ours, theirs = getattr(alone, key), getattr(size, key)
            assert (ours is None and theirs is None) or ours == pytest.approx(theirs, rel=1e-12), (number, key)
        own = alone.measures
        assert own.balls.size == pytest.approx(measured.balls.size, rel=1e-14)
        assert own.constant_chord == pytest.approx(measured.constant_chord, rel=1e-14)
        lengths = {row.teeth: row.length for row in own.spans}
        assert all(lengths[row.teeth] == row.length for row in measured.spans if row.valid)
        assert [row.name for row in own.chords] == ["reference", "tip"]
        ours, theirs = track(SingleMember(alone.task), 1e-7), track(member, 1e-7)
        assert np.abs(ours.polygon - theirs.polygon).max() < 1e-12


def test_ig_s12_thickness_chords_balls() -> None:
    given, expected = case("IG-S12")["inputs"], case("IG-S12")["expected"]
    rows = expected["at_radius"]
    found = wheel(
        27, helix=15, shift=0.31, tip=given["r_a"], ball=8.5, face_width=40, circles=tuple(r["r_y"] * MM for r in rows)
    )
    assert found.thickness / MM == pytest.approx(expected["s_n"], abs=1e-6)
    assert found.arc / MM == pytest.approx(expected["s_t"], abs=1e-6)
    asked = [row for row in found.measures.chords if row.name == "asked"]
    for row, wanted in zip(asked, rows, strict=True):
        told = (row.transverse, row.arc, row.chord, row.height)
        keys = ("s_ty", "s_ny", "chord_s_y", "height_h_ay")
        assert [length / MM for length in told] == pytest.approx([wanted[key] for key in keys], abs=2e-6)
    assert found.measures.balls.size / MM == pytest.approx(expected["balls_D_8_5"]["M"], abs=1e-6)
    assert found.measures.constant_chord / MM == pytest.approx(expected["constant_chord"], abs=1e-6)
    span = expected["span"]
    assert found.measures.span.length / MM == pytest.approx(span["W"], abs=1e-6)
    assert found.measures.span_teeth == span["z_w_max"]
    assert found.measures.span_tip / MM == pytest.approx(span["W_star"], abs=1e-5)


def test_ig_s08_undercut() -> None:
    given, expected = case("IG-S08")["inputs"], case("IG-S08")["expected"]
    found = wheel(given["z"], tip=given["r_a"])
    assert found.form / MM == pytest.approx(expected["r_F"], abs=1e-5)
    assert found.least_shift == pytest.approx(expected["x_min"], abs=1e-6)
    assert found.limit / MM == pytest.approx(expected["LN"], abs=1e-6)
    assert [check.verdict for check in found.checks if check.name == "undercut"] == ["warn"]
    assert found.profile.undercut
    assert wheel(10, undercut=False).verdict == "fail"


def involute_of(angle: float) -> float:
    return tan(angle) - angle


@pytest.mark.parametrize(("z", "helix"), [(9, 0.0), (27, 15.0), (120, 30.0)])
def test_limits_of_the_shift(z: int, helix: float) -> None:
    """The shift that makes whole teeth pointed, and that with tips of a quarter of the module, by ISO 21771."""
    beta, alpha = radians(helix), radians(20)
    alpha_t, r = atan(tan(alpha) / cos(beta)), z / (2 * cos(beta))

    def tip_arc(x: float) -> float:
        tip = r + 1 + x
        angle = acos(r * cos(alpha_t) / tip)
        half = (pi / 2 + 2 * x * tan(alpha)) / z + involute_of(alpha_t) - involute_of(angle)
        return 2 * tip * half * cos(atan(tan(beta) * tip / r))

    found = wheel(z, helix=helix)
    assert found.pointed_shift == pytest.approx(brentq(tip_arc, -0.5, 9, xtol=1e-14), rel=1e-10)
    assert found.thin_shift == pytest.approx(brentq(lambda x: tip_arc(x) - 0.25, -0.5, 9, xtol=1e-14), rel=1e-10)
    pointed = wheel(z, helix=helix, shift=found.pointed_shift)
    assert pointed.tip_thickness == pytest.approx(0, abs=1e-12)
    assert pointed.pointing == pytest.approx(pointed.tip, rel=1e-10)


@pytest.mark.parametrize("kind", ["external", "internal"])
def test_thickness_and_size_over_pins_of_the_drawn_outline(kind: str) -> None:
    """The tooth of the outline cut by a circle; a pin pushed between two teeth of the outline until it touches."""
    z, m, ring = 40, 3.0, kind == "internal"
    cutter = Cutter(22, rounding=0.1) if ring else None
    found = wheel(z, m, kind=kind, shift=0.2, cutter=cutter, body="pins", ball=5.2, circles=(60.5 * MM,))
    points = track(SingleMember(found.task), 1e-9).polygon
    row = next(row for row in found.measures.chords if row.name == "asked")
    upright = points[np.abs(np.angle(points / 1j)) < pi / z]
    tooth = np.angle(upright / 1j), np.abs(upright)
    left = tooth[0] > 0
    order = np.argsort(tooth[1][left])
    half = np.interp(row.radius, tooth[1][left][order], tooth[0][left][order])
    assert 2 * row.radius * half == pytest.approx(row.transverse, abs=1e-8)

    def clearance(radius: float) -> float:
        centre = radius * 1j * np.exp(1j * pi / z)
        run = np.roll(points, -1) - points
        along = np.clip(((centre - points) * run.conj()).real / np.abs(run) ** 2, 0, 1)
        return float(np.abs(points + along * run - centre).min()) - 2.6 * MM

    side = -1.0 if ring else 1.0
    ends = (found.reference, found.tip + side * 3 * MM)
    radius = brentq(clearance, *ends, xtol=1e-12)
    assert 2 * radius + side * 5.2 * MM == pytest.approx(found.measures.balls.size, abs=1e-8)


def test_span_of_the_drawn_outline() -> None:
    """Parallel plates closed on k teeth of the outline: the least width over all directions near the middle."""
    found = wheel(27, shift=0.31)
    points = track(SingleMember(found.task), 1e-7).polygon
    teeth, pitch = found.measures.span_teeth, 2 * pi / 27
    away = np.angle(points * np.exp(-1j * (pi / 2 + (teeth - 1) * pitch / 2)))
    spanned = points[np.abs(away) < teeth * pitch / 2] * np.exp(-1j * (teeth - 1) * pitch / 2)
    wide = minimize_scalar(
        lambda turn: np.ptp((spanned * np.exp(1j * turn)).real), bounds=(-0.5 * pitch, 0.5 * pitch), method="bounded"
    )
    assert wide.fun == pytest.approx(found.measures.span.length, abs=2e-7)


def test_rings_and_their_cutters() -> None:
    found = wheel(57, kind="internal", shift=-0.3)
    assert found.task.tip_radius == pytest.approx(57 / 2 - 1 + 0.3)
    assert 2 * found.pointed_shift == pytest.approx(57 - 2 - 57 * cos(radians(20)))
    assert wheel(57, kind="internal", shift=found.pointed_shift + 1e-6).verdict == "fail"
    assert wheel(57, kind="internal", shift=found.pointed_shift - 1e-6).verdict != "fail"
    small = wheel(57, kind="internal", cutter=Cutter(50))
    assert [check.name for check in small.checks if check.verdict != "ok"] == ["cutter interference", "cutter feed"]


def test_wheels_that_cannot_be() -> None:
    with pytest.raises(NoSolutionError, match="there are no teeth"):
        wheel(20, tip=40)
    with pytest.raises(NoSolutionError, match="no hole"):
        wheel(3, kind="internal", shift=1)
    with pytest.raises(NoSolutionError, match="nothing is left"):
        wheel(4, shift=-2)
    narrow = wheel(9, shift=1.2)
    assert narrow.verdict == "fail"
    assert narrow.remarks == (f"wheel 1 is pointed at the radius {narrow.pointing / MM:.6g} mm, below its tip circle",)
    assert wheel(12, shift=-3).profile is None


def test_errors_are_of_the_size_of_rounding() -> None:
    found = wheel(27, helix=15, shift=0.31, face_width=40)
    assert found.error.span < 1e-15
    assert found.error.balls < 1e-15
    off = replace(found, thickness=found.thickness * (1 + 1e-9))
    assert 5e-10 < single_error(off).thickness < 5e-9


@pytest.mark.parametrize("seed", range(6))
def test_errors_are_bounds_against_forty_digits(seed: int) -> None:
    """W of a span and the thickness by their formulas with 40 digits, of the numbers that the program was given."""
    rng = np.random.default_rng(seed)
    z, module = int(rng.integers(14, 90)), float(rng.choice([1.25, 2.0, 5.0])) * MM
    shift, helix = float(rng.uniform(-0.2, 0.6)), float(rng.uniform(0, 0.5))
    asked = WheelMeasuring("1", module, ball=None, body="balls")
    found = solve_single(WheelTask(z, module, asked, helix=helix, shift=shift))
    with mp.workdps(40):
        m, x, beta, alpha = (mp.mpf(v) for v in (module, found.task.shift, helix, found.task.rack.angle))
        alpha_t = mp.atan(mp.tan(alpha) / mp.cos(beta))
        inv = mp.tan(alpha_t) - alpha_t
        thickness = m * (mp.pi / 2 + 2 * x * mp.tan(alpha))
        assert abs(found.thickness / thickness - 1) <= found.error.thickness
        span = found.measures.span
        assert span is not None
        exact = m * mp.cos(alpha) * (mp.pi * (span.teeth - mp.mpf("0.5")) + z * inv) + 2 * x * m * mp.sin(alpha)
        assert found.error.span is not None
        assert abs(span.length / exact - 1) <= found.error.span
