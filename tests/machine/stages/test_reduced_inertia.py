"""A reduced inertia by a table: a linkage's own reduction, left as CSV and read back, moves as the linkage does.

Beside it the equation of motion by scipy: DOP853 along scipy's own spline through the same points.
"""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.interpolate import CubicSpline, PchipInterpolator
from sparing import sparing
from written import PINS, link, slide

import tmmcalc
from tmmcalc.core.errors import UsageError
from tmmcalc.pipeline.outcome import RunResult
from tmmcalc.project import load_spec, parse_spec, templates

TURN = 2 * math.pi
LINKS = (
    link(1, 'O = [0, 0], A = ["90 mm", 0]', "mass = 6", "inertia = 0.03", 'center = ["20 mm", 0]')
    + link(2, 'A = [0, 0], B = ["310 mm", 0]', "mass = 5", "inertia = 0.05", 'center = ["100 mm", 0]')
    + link(3, "B = [0, 0]", "mass = 14", "center = [0, 0]")
)
JOINTS = PINS + slide("guide", 3, 0, 'through = [0, "25 mm"], angle = "0 deg"')
LINKAGE = """
[mechanism.grid]
positions = {positions}
[mechanism.input]
joint = "O"
speed = "{speed}"
start = "20 deg"
[[mechanism.outputs]]
point = "B"
direction = "0 deg"
[mechanism.fixed]
O = [0, 0]
{links}{joints}[[loads]]
name = "Q"
link = 3
point = "B"
direction = "0 deg"
force = "300 N"
role = "neutral"
[[loads]]
name = "M"
link = 1
moment = "-20 N*m"
"""
MACHINE = """
[motor]
power = "1.5 kW"
speed = "1410 rpm"
synchronous_speed = "1500 rpm"
overload = 2.4
inertia = 0.004
characteristic = "kloss"
[transmission]
ratio = 4.9
efficiency = 1
inertia = 0
[flywheel]
delta = 0.02
[[transients]]
name = "start"
duration = "0.8 s"
"""
TABLES = """
[torque]
speed = "300 rpm"
table = { file = "FILE", columns = "phi,M_red", interpolation = "spline" }
reduced_inertia = { file = "FILE", columns = "phi,J_red" }
"""


def both(folder: Path, positions: int) -> tuple[RunResult, RunResult]:
    """The linkage with its machine, and the machine of the tables that it leaves in its output folder."""
    text = LINKAGE.format(links=LINKS, joints=JOINTS, positions=positions, speed="300 rpm")
    linkage = tmmcalc.run(parse_spec(text + MACHINE), out=folder / f"{positions}")
    (folder / "tables.toml").write_text(TABLES.replace("FILE", f"{positions}/reduction.csv") + MACHINE)
    return linkage, tmmcalc.run(load_spec(folder / "tables.toml"))


def figures(run: RunResult) -> np.ndarray:
    """Flywheel, extreme speeds of the motion, speed that a start reaches."""
    found = run.results
    regime, (start,) = found["motion"].regime, found["transient"].motions
    return np.array([found["flywheel"].addition, regime.omega_min, regime.omega_max, start.omega[0, -1]])


@pytest.mark.slow
def test_the_tables_of_a_linkage_move_as_the_linkage(tmp_path: Path) -> None:
    """To the error of the spline, of fourth order in the step."""
    off = []
    for positions in (18, 36, 72):
        linkage, tables = both(tmp_path, positions)
        off.append(np.abs(figures(tables) / figures(linkage) - 1))
    assert np.all(off[2] < 2e-6)
    assert np.all(off[2] < off[1] / 10)
    assert np.all(off[1] < off[0] / 10)


def test_the_inertia_of_a_clockwise_crank_counts_along_its_motion(tmp_path: Path) -> None:
    linkage = tmmcalc.run(
        parse_spec(LINKAGE.format(links=LINKS, joints=JOINTS, positions=24, speed="-300 rpm")), out=tmp_path
    )
    (tmp_path / "tables.toml").write_text(TABLES.replace("FILE", "reduction.csv"))
    read = tmmcalc.run(load_spec(tmp_path / "tables.toml")).results["reduction"]
    assert np.all(np.diff(linkage.results["reduction"].phi) < 0)
    assert read.inertia == pytest.approx(linkage.results["reduction"].inertia, rel=1e-14)


def test_the_table_at_its_points_is_what_it_was_made_of(tmp_path: Path) -> None:
    linkage, tables = both(tmp_path, 72)
    own, read = linkage.results["reduction"], tables.results["reduction"]
    assert read.inertia[[0, 6, 12]] == pytest.approx(own.inertia[[0, 18, 36]], rel=1e-14)
    assert read.slope[[0, 6, 12]] == pytest.approx(own.slope[[0, 18, 36]], abs=2e-5 * np.max(np.abs(own.slope)))
    assert read.inertia_range[1].value == pytest.approx(own.inertia_range[1].value, rel=1e-5)


POINTS = np.array([0.6, 0.9, 1.9, 1.2, 0.7, 1.5, 2.0, 0.8])
SPEC = """
[torque]
speed = "12 rad/s"
formula = "{moment}"
inertia = 0.5
reduced_inertia = {{ inertia = {points}, interpolation = "{kind}" }}
[[transients]]
name = "alone"
motor = "off"
start_speed = "12 rad/s"
start_angle = "50 deg"
duration = "3 s"
tolerance = 1e-10
"""


def curve(kind: str) -> tuple[Any, Any]:
    at, closed = np.arange(9) * TURN / 8, np.append(POINTS, POINTS[0])
    if kind == "spline":
        through = CubicSpline(at, closed, bc_type="periodic")
        return through, through.derivative()
    if kind == "pchip":
        wide = PchipInterpolator(np.arange(-8, 17) * TURN / 8, np.append(np.tile(POINTS, 3), POINTS[0]))
        return wide, wide.derivative()
    rise = np.diff(closed) / np.diff(at)
    return lambda x: np.interp(x, at, closed), lambda x: rise[min(int(x / (TURN / 8)), 7)]


@sparing("kind", ["spline", "pchip", "linear"], every=3)
def test_a_motion_in_time_against_dop853(kind: str) -> None:
    """J w' + w^2 J'/2 = M, with J' that of the same curve."""
    text = SPEC.format(moment="-3 + 8*sin(theta)", points=POINTS.tolist(), kind=kind)
    (found,) = tmmcalc.run(parse_spec(text)).results["transient"].motions
    inertia, slope = curve(kind)

    def rates(t: float, y: np.ndarray) -> list[float]:
        theta = float(y[0] % TURN)
        moment = -3 + 8 * math.sin(theta)
        return [y[1], (moment - y[1] ** 2 / 2 * float(slope(theta))) / (float(inertia(theta)) + 0.5)]

    step = 1e-3 if kind == "linear" else math.inf
    exact = solve_ivp(rates, (0, 3), [math.radians(50), 12.0], "DOP853", rtol=3e-14, atol=3e-14, max_step=step)
    near = 1e-4 if kind == "linear" else found.error  # the steps of the reference do not end at kinks
    assert found.error < 1e-6
    assert found.omega[0, -1] == pytest.approx(exact.y[1, -1], rel=near)
    assert found.theta[0, -1] == pytest.approx(exact.y[0, -1], rel=near)


def test_without_a_moment_the_energy_is_kept() -> None:
    (found,) = (
        tmmcalc.run(parse_spec(SPEC.format(moment="0", points=POINTS.tolist(), kind="spline")))
        .results["transient"]
        .motions
    )
    energy = (curve("spline")[0](found.theta[0] % TURN) + 0.5) * found.omega[0] ** 2
    assert energy == pytest.approx(energy[0], rel=1e-8)
    assert np.ptp(found.omega[0]) > 3


def test_equal_diagrams_bring_their_inertia_each() -> None:
    """Two engines half a turn apart: J(phi) + J(phi - 180 deg) + the shaft's own, once."""
    text = SPEC.format(moment="sin(theta)", points=POINTS.tolist(), kind="spline").replace("[[tr", "count = 2\n[[tr")
    found = tmmcalc.run(parse_spec(text)).results["reduction"]
    inertia = curve("spline")[0]
    exact = inertia(found.phi % TURN) + inertia((found.phi + math.pi) % TURN) + 0.5
    assert found.inertia == pytest.approx(exact, rel=1e-13)


def test_an_inertia_of_one_turn_in_a_cycle_of_two() -> None:
    text = SPEC.format(moment="sin(theta/2)", points=POINTS.tolist(), kind="spline")
    text = text.replace('speed = "12 rad/s"\nformula', 'speed = "12 rad/s"\nperiod = "720 deg"\nformula')
    text = text.replace('"spline" }', '"spline", period = "360 deg" }')
    found = tmmcalc.run(parse_spec(text)).results["reduction"]
    assert found.cycle.period == pytest.approx(2 * TURN)
    assert found.inertia == pytest.approx(curve("spline")[0](found.phi % TURN) + 0.5, rel=1e-13)


def test_a_spline_that_falls_below_zero_is_refused() -> None:
    text = SPEC.format(moment="1", points=[3.0, 0.0, 0.0, 3.0, 0.0, 3.0], kind="spline")
    with pytest.raises(UsageError, match=r"reduced inertia falls to -0\.\d+ kg\*m\^2 at .* deg, between"):
        tmmcalc.run(parse_spec(text))


@pytest.mark.slow
def test_the_ready_spec_moves_as_the_compressor_that_its_tables_are_of() -> None:
    """Straight lines every 5 degrees: to some tenths of a percent."""
    tables, linkage = (
        tmmcalc.run(load_spec(templates.folder() / f"{name}.toml")).results
        for name in ("reduced-machine", "piston-compressor")
    )
    assert tables["flywheel"].addition == pytest.approx(linkage["flywheel"].addition, rel=5e-3)
    assert tables["motion"].regime.omega_max == pytest.approx(linkage["motion"].regime.omega_max, rel=1e-4)
