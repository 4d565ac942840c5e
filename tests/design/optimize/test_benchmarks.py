"""Designs whose best is known: by a closed form, by a stage that finds it in its own way, by all that there are.

Each is as good as that to 1e-6, and what its limits cost is what closed forms say, or others with these moved.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.optimize import minimize, minimize_scalar

from tmmcalc.design.optimize.scene import Optimum, optimize
from tmmcalc.gears.split import best_split
from tmmcalc.naming.language import parse
from tmmcalc.naming.scene import Scene
from tmmcalc.naming.told import one
from tmmcalc.pipeline.runner import run
from tmmcalc.project import load_spec

Values = NDArray[Any]

CONFIGS = Path(__file__).parents[3] / "configs"
EXACT = 1e-6
SPEED = 1500 * np.pi / 30  # rad/s, and what follows in m and kg: of configs/best-counterweights.toml
CRANK, ROD, CRANK_MASS, PISTON = 0.05, 0.2, 4.0, 0.9
ROD_MASS, ROD_CENTER = 1.2, 0.06
ANGLES = np.linspace(0, 2 * np.pi, 20_000, endpoint=False)
TURNING = np.exp(1j * ANGLES)


def changed(folder: Path, name: str, *changes: tuple[str, str], more: str = "") -> Path:
    """A ready spec with texts changed, and more at its end."""
    text = (CONFIGS / f"{name}.toml").read_text(encoding="utf-8")
    for old, new in changes:
        assert old in text
        text = text.replace(old, new, 1)
    file = folder / f"{name}.toml"
    file.write_text(text + more, encoding="utf-8")
    return file


def best(found: Optimum) -> float:
    return found.designs[0].objectives[0]


def told(file: Path, name: str) -> float:
    """A result of a spec by its name, of the ordinary stages."""
    asked, spec = parse(name), load_spec(file)
    results = run(spec, target=(asked.stage,)).results
    return one(asked, results, Scene(spec, results)).value


def piston_acceleration(crank: float, rod: float, offset: float, angles: Values) -> Values:
    """Of x = r cos phi + sqrt(l^2 - (e - r sin phi)^2), by differentiating it twice, in omega^2."""
    height = offset - crank * np.sin(angles)
    root = np.sqrt(rod**2 - height**2)
    slope = height * crank * np.cos(angles)
    bend = -height * crank * np.sin(angles) - (crank * np.cos(angles)) ** 2
    return np.asarray(-crank * np.cos(angles) + bend / root - slope**2 / root**3)


def unbalanced(rod: float, center: float) -> Values:
    """Shaking force of rod and piston in the crank frame [N]: the force of a rod is that of two masses at its ends."""
    share = ROD_MASS * center / rod
    turning = (ROD_MASS - share) * CRANK * TURNING
    return np.asarray((turning - (PISTON + share) * piston_acceleration(CRANK, rod, 0.0, ANGLES)) * SPEED**2 / TURNING)


def left(center: float) -> Values:
    """Size (n,) of the force that is left with the crank's centre at ``center`` [m]."""
    return np.asarray(np.abs(unbalanced(ROD, ROD_CENTER) + CRANK_MASS * center * SPEED**2))


@pytest.mark.slow
def test_the_counterweight_of_a_crank_for_the_least_mean_square(tmp_path: Path) -> None:
    """It takes away the mean of the hodograph in the crank frame, Kinytskyi (3.74)."""
    found = optimize(changed(tmp_path, "best-counterweights", ("R_max", "R_rms"), ("= 2500", "= 100")))
    center = -unbalanced(ROD, ROD_CENTER).mean().real / (CRANK_MASS * SPEED**2)
    assert best(found) == pytest.approx(np.sqrt(np.mean(left(center) ** 2)), rel=EXACT)
    assert found.designs[0].values == pytest.approx([center, 0.0], abs=1e-7)


@pytest.mark.slow
def test_the_counterweight_of_a_long_rod_is_half_of_what_goes_to_and_fro(tmp_path: Path) -> None:
    """m r omega^2 cos phi along a line: half of m on the crank leaves half of the force, whatever the angle."""
    rod = 'center = ["60 mm", 0]', "center = [0, 0]"  # all of its mass turns
    asked = ("R_max", "R_rms"), ("= 2500", "= 100"), ('"200 mm"', '"200 m"')
    found = optimize(changed(tmp_path, "best-counterweights", rod, *asked))
    assert best(found) == pytest.approx(PISTON * CRANK * SPEED**2 / 2, rel=EXACT)
    center = -(PISTON / 2 + ROD_MASS) * CRANK / CRANK_MASS
    assert found.designs[0].values == pytest.approx([center, 0.0], abs=1e-7)


@pytest.mark.slow
def test_the_counterweight_of_a_crank_for_the_least_peak(tmp_path: Path) -> None:
    """The smallest circle about the hodograph, whose centre is on its axis: sought there, and by the balance stage."""
    found = optimize(changed(tmp_path, "best-counterweights"))
    least = minimize_scalar(lambda center: left(center).max(), bounds=(-0.06, 0.0), options={"xatol": 1e-13})
    assert best(found) <= least.fun * (1 + EXACT)
    scheme = changed(tmp_path, "best-counterweights", ("schemes = []", 'schemes = ["minimax"]'))
    assert best(found) == pytest.approx(told(scheme, "balance.D_minimax_max"), rel=EXACT)


@pytest.mark.slow
def test_counterweights_on_crank_and_rod_leave_nothing(tmp_path: Path) -> None:
    """m2 c2 = -m3 l brings the mass of rod and piston to the crank pin, m1 c1 = -(m2 + m3) r all of it to the pivot."""
    more = '[[optimize.variables]]\nof = "mechanism.links[id=2].center[0]"\nat_least = "-200 mm"\nat_most = "200 mm"\n'
    found = optimize(changed(tmp_path, "best-counterweights", ("= 2500", "= 1500"), more=more))
    assert best(found) < EXACT * found.nominal[0]
    wanted = [-(ROD_MASS + PISTON) * CRANK / CRANK_MASS, 0.0, -PISTON * ROD / ROD_MASS * 1e3]
    assert found.designs[0].values == pytest.approx(wanted, rel=1e-5, abs=1e-7)


@pytest.mark.slow
def test_masses_of_a_four_bar_that_leave_no_force(tmp_path: Path) -> None:
    """R. S. Berkof, G. G. Lowen 1969: m1 r1 = m2 r2' a1/a2 and m3 r3 = m2 r2 a3/a2, each opposite."""
    found = optimize(changed(tmp_path, "best-four-bar"))
    assert best(found) < EXACT * found.nominal[0]
    coupler, crank, rocker, length = complex(80, 15), 50.0, 75.0, 150.0  # mm
    one = -0.6 * crank / 1.5 * (1 - coupler / length)
    three = -0.6 * rocker / 2.0 * coupler / length
    assert in_mm(found) == pytest.approx([one.real, one.imag, three.real, three.imag], abs=1e-4)


def in_mm(found: Optimum) -> list[float]:
    return [
        value * (1.0 if variable.unit == "mm" else 1e3)
        for variable, value in zip(found.variables, found.designs[0].values, strict=True)
    ]


STROKE = """
[[constraints]]
name = "stroke"
value = "kinematics.stroke_B"
at_least = "200 mm"

[optimize]
least = "kinematics.size(aS_B)"
evaluations = 600

[[optimize.variables]]
of = "mechanism.links[id=1].points.A[0]"
at_least = "80 mm"
at_most = "120 mm"

[[optimize.variables]]
of = "mechanism.links[id=2].points.B[0]"
at_least = "250 mm"
at_most = "400 mm"
"""


@pytest.mark.slow
def test_the_least_peak_acceleration_at_a_stroke_is_that_of_the_longest_rod(tmp_path: Path) -> None:
    """r omega^2 (1 + r/l) with 2 r = h, and what rod and stroke cost of it."""
    line = ('"extreme"', '"0 deg"'), ('[0, "-40 mm"]', "[0, 0]")
    found = optimize(changed(tmp_path, "crank-slider", *line, more=STROKE))
    crank, rod = 0.1, 0.4
    assert best(found) == pytest.approx(crank * (1 + crank / rod), rel=EXACT)
    costs = {each.name: each.cost for each in found.binding}
    assert costs == {
        "stroke": pytest.approx((1 + 2 * crank / rod) / 2, rel=1e-5),
        "mechanism.links[id=2].points.B[0]": pytest.approx(-((crank / rod) ** 2) / 1e3, rel=1e-5),
    }


@pytest.mark.slow
def test_an_offset_guide_lowers_the_peak_further(tmp_path: Path) -> None:
    """Sought a second time in closed form over the same positions, by other means."""
    line = ('"extreme"', '"0 deg"'), ("positions = 12 ", "positions = 36 ")
    offset = '[[optimize.variables]]\nof = "mechanism.joints[name=B0].guide.through[1]"\nat_least = "-90 mm"\n'
    found = optimize(changed(tmp_path, "crank-slider", *line, more=f'{STROKE}{offset}at_most = "0 mm"\n'))
    angles = np.arange(36) * np.pi / 18

    def peak(x: Values) -> float:
        return float(np.abs(piston_acceleration(x[0], x[1], x[2], angles)).max())

    def stroke(x: Values) -> float:
        return float(np.sqrt((x[1] + x[0]) ** 2 - x[2] ** 2) - np.sqrt((x[1] - x[0]) ** 2 - x[2] ** 2) - 0.2)

    box = [(0.08, 0.12), (0.25, 0.4), (-0.09, 0.0)]
    starts = np.random.default_rng(0).uniform(*np.array(box).T, size=(40, 3))
    ends = [minimize(peak, x, bounds=box, constraints=[{"type": "ineq", "fun": stroke}]) for x in starts]
    least = min(end.fun for end in ends if stroke(end.x) > -1e-9)
    assert best(found) <= least * (1 + EXACT)
    assert best(found) < 0.125
    assert peak(np.array(in_mm(found)) / 1e3) == pytest.approx(best(found), rel=EXACT)


CAM = """refuse = false
start_distance = "70 mm"
offset = "0 mm"
"""
LEAST_CAM = """
[[constraints]]
name = "lifting"
value = "cam_pressure.theta_rise_max"
at_most = "30 deg"

[[constraints]]
name = "falling"
value = "cam_pressure.theta_return_min"
at_least = "-30 deg"

[optimize]
least = "cam_synthesis.R0"
evaluations = 150

[[optimize.variables]]
of = "cam.start_distance"
at_least = "20 mm"
at_most = "120 mm"

[[optimize.variables]]
of = "cam.offset"
at_least = "-20 mm"
at_most = "20 mm"
"""


def least_base_circle(lifting: float, falling: float) -> float:
    """Apex of the region between two tangents of (S, S'), S0 = (S' - e)/tan(theta) - S over each phase [m]."""
    rise, back, stroke = np.pi / 2, np.pi / 3, 0.03
    k = np.linspace(0, 1, 200_001)
    lift, slope = stroke * (1 - np.cos(np.pi * k)) / 2, stroke * np.pi / 2 * np.sin(np.pi * k)
    up = np.max(slope / rise / np.tan(lifting) - lift)  # S0 + e/tan(theta) at least
    down = np.max(slope / back / np.tan(falling) - lift[::-1])  # S0 - e/tan(theta) at least
    matrix = np.array([[1.0, 1 / np.tan(lifting)], [1.0, -1 / np.tan(falling)]])
    return float(np.hypot(*np.linalg.solve(matrix, [up, down])))


@pytest.mark.slow
def test_the_least_cam_within_pressure_angles_is_at_the_apex_of_its_region(tmp_path: Path) -> None:
    found = optimize(changed(tmp_path, "cam-synthesis", ("[cam.limits]", f"{CAM}\n[cam.limits]"), more=LEAST_CAM))
    limit, step = np.radians(30), np.radians(1e-3)
    assert best(found) == pytest.approx(least_base_circle(limit, limit), rel=EXACT)
    assert best(found) == pytest.approx(told(CONFIGS / "cam-synthesis.toml", "cam_synthesis.R0"), rel=EXACT)
    costs = {each.name: each.cost for each in found.binding}
    up, down = (
        (least_base_circle(limit + a, limit + b) - least_base_circle(limit - a, limit - b)) / 2e-3
        for a, b in ((step, 0.0), (0.0, step))
    )
    assert costs == {"lifting": pytest.approx(up, rel=1e-4), "falling": pytest.approx(-down, rel=1e-4)}


@pytest.mark.slow
def test_the_split_of_a_ratio_is_the_lightest_of_all_trains(tmp_path: Path) -> None:
    """The train's own search finds the same teeth; the split of a continuum says about which."""
    found = optimize(changed(tmp_path, "best-split"))
    assert found.method == f"all {31 * 27} designs"
    assert found.designs[0].values == (62.0, 62.0)
    text = (CONFIGS / "best-split.toml").read_text().partition("[optimize]")[0]
    every = tmp_path / "every.toml"
    every.write_text(text.replace("teeth = [18, 72, 18, 54]", "z_min = 18\nz_pinion_max = 18"))
    assert best(found) == pytest.approx(told(every, "criteria.best_mass"), rel=1e-12)
    first = best_split(12.0, "mass", most=None).ratios[0]
    assert abs(62 / 18 / first - 1) < 0.1
