"""What is told by choice of laws and sizes: against integration, dense sampling and brute force over the size."""

from __future__ import annotations

import csv
import io
import json
from math import hypot, pi, radians, tan
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.interpolate import CubicSpline
from typer.testing import CliRunner

from tmmcalc.cams.laws.catalogue import LAWS
from tmmcalc.cams.laws.details import RockerPhase, StemPhase, phase_laws
from tmmcalc.cams.program import Phase, Program
from tmmcalc.cams.synthesis.candidates import candidates
from tmmcalc.cams.synthesis.solve import solve_synthesis
from tmmcalc.cams.task import AngleLimits, Asked, CamTask
from tmmcalc.cli.app import app
from tmmcalc.core.errors import UsageError

CONFIGS = Path(__file__).parents[2] / "configs"


def program(stroke: float, rise: float, back: float, laws: tuple[str, str]) -> Program:
    """Rise, 40 deg of high dwell, return, the rest low."""
    first, second = radians(rise), radians(back)
    return Program(
        (
            Phase("rise", first, 0.0, stroke, LAWS[laws[0]]),
            Phase("high dwell", radians(40), stroke, stroke),
            Phase("return", second, stroke, 0.0, LAWS[laws[1]]),
            Phase("low dwell", 2 * pi - first - second - radians(40), 0.0, 0.0),
        )
    )


@pytest.mark.parametrize("name", ["modified_trapezoid", "modified_sine", "poly5", "cosine", "parab2"])
def test_the_coefficients_integrate_to_the_lift(name: str) -> None:
    """s'' made of the coefficients alone, integrated twice by quadrature, lifts by 1 and comes to rest."""
    law, _ = phase_laws(program(0.03, 80, 100, (name, name)), False, None)["rise"]

    def bend(k: float) -> float:
        i = min(int(np.searchsorted(law.breaks[1:-1], k, side="right")), len(law.amplitude) - 1)
        t = k - law.breaks[i]
        found = sum(j * (j - 1) * c * t ** (j - 2) for j, c in enumerate(law.coefficients[i]) if j > 1)
        return float(found - law.amplitude[i] * law.frequency[i] ** 2 * np.sin(law.frequency[i] * t + law.lead[i]))

    inner = list(law.breaks[1:-1]) or None
    assert quad(bend, 0, 1, points=inner, epsabs=1e-12)[0] == pytest.approx(0, abs=1e-10)
    assert quad(lambda k: (1 - k) * bend(k), 0, 1, points=inner, epsabs=1e-12)[0] == pytest.approx(1, abs=1e-10)
    k = np.linspace(0, 1, 20001)
    assert law.rising == pytest.approx(max(map(bend, k)), rel=1e-6)


@pytest.mark.parametrize("turns", [False, True])
def test_peaks_of_phases_by_dense_differences(turns: bool) -> None:
    speed, stroke = 20.0, 0.3
    of = program(stroke, 70, 110, ("shun", "sine"))
    found = phase_laws(of, turns, speed)
    for kind, low, high in (("rise", 0.0, radians(70)), ("return", radians(110), radians(220))):
        motion = found[kind][1]
        assert isinstance(motion, RockerPhase if turns else StemPhase)
        phi = np.linspace(low, high, 5001)
        y = CubicSpline(phi, of.at(phi)[0])
        slope, bend = y(phi, 1), y(phi, 2)
        k = int(np.argmax(np.abs(slope)))
        assert (motion.slope, motion.slope_at) == pytest.approx((slope[k], phi[k]), rel=1e-4)
        inner = slice(20, -20)
        assert (motion.most, motion.least) == pytest.approx((bend[inner].max(), bend[inner].min()), rel=1e-6)
        assert motion.most_at == pytest.approx(phi[inner][bend[inner].argmax()], abs=3e-3)
        assert motion.velocity == pytest.approx(speed * motion.slope)
        assert motion.slowing == pytest.approx(speed**2 * motion.least)
        assert motion.m2 == pytest.approx(stroke / (high - low) ** 2)


def stem_task(**asked: Any) -> CamTask:
    limits = AngleLimits(radians(32), radians(38), convex=0.004, shaft=0.012)
    return CamTask(program(0.03, 70, 85, ("cosine", "sine")), Asked("translating", **asked), limits)


@pytest.mark.slow
def test_sizes_of_a_stem_by_brute_force() -> None:
    """The pressure angle by its own formula on many angles, the curvature by splines through the pitch curve."""
    task = stem_task(offset=0.004, roller=0.02)
    result = solve_synthesis(task)
    found, e = candidates(task, result), result.follower.offset
    for name, low, high, limit in (
        ("pressure_rise", 0.0, radians(70), radians(32)),
        ("pressure_return", radians(110), radians(195), radians(38)),
    ):
        phi = np.linspace(low, high, 100_001)
        y, y1 = task.program.at(phi)[:2]
        needed = float(np.max(np.abs(y1 + e) / tan(limit) - y))
        assert found[name].start == pytest.approx(needed, rel=1e-7)
        assert found[name].base == pytest.approx(hypot(needed, e), rel=1e-7)
    sizes = np.linspace(0.005, 0.06, 1101)
    kept = [_sharpest(task, size, e) >= 0.024 for size in sizes]
    last = max(k for k, good in enumerate(kept) if not good)
    start = found["curvature"].start
    assert start is not None
    assert sizes[last] <= start + 1e-5
    assert start <= sizes[last + 1] + 1e-5
    assert found["shaft"].base == pytest.approx(0.032, rel=1e-9)
    assert found["roller"].base == pytest.approx(0.05, rel=1e-9)
    assert [name for name, each in found.items() if each.binds] == ["pressure_rise"]


def _sharpest(task: CamTask, start: float, e: float) -> float:
    """Least radius of convex parts, piece by piece of the motion."""
    least = np.inf
    for low, high in zip(task.program.edges[:-1], task.program.edges[1:], strict=True):
        phi = np.linspace(low, high, 401)
        y = task.program.at(phi, task.program.piece(np.full(401, (low + high) / 2)))[0]
        z = (e + 1j * (start + y)) * np.exp(1j * phi)
        x, w = CubicSpline(phi, z.real), CubicSpline(phi, z.imag)
        bend = (x(phi, 1) * w(phi, 2) - w(phi, 1) * x(phi, 2)) / np.hypot(x(phi, 1), w(phi, 1)) ** 3
        least = min(least, 1 / bend.max()) if bend.max() > 0 else least
    return float(least)


@pytest.mark.slow
def test_sizes_of_a_rocker_by_brute_force() -> None:
    """The axis moved by hand: the angle between the rocker's normal and that of the pitch curve, by differences."""
    limits = AngleLimits(radians(36), radians(50), convex=0.003, shaft=0.03)
    task = CamTask(program(radians(20), 60, 70, ("linear", "sine")), Asked("oscillating", rocker=0.12), limits)
    result = solve_synthesis(task)
    found, taken = candidates(task, result), result.follower
    axis = taken.centres / 0.12 * np.exp(-1j * taken.start)

    def excess(shift: float, low: float, high: float, limit: float) -> float:
        o = axis - 1j * shift * np.exp(0.5j * task.program.stroke)
        l0, psi0 = 0.12 * abs(o), -np.angle(o)
        phi = np.linspace(low, high, 20_001)
        psi = psi0 + task.program.at(phi)[0]
        z = l0 * np.exp(1j * phi) - 0.12 * np.exp(1j * (phi - psi))
        tangent = CubicSpline(phi, z)(phi, 1)
        normal = tangent / np.abs(tangent) / 1j
        push = 1j * np.exp(1j * (phi - psi))  # along the velocity of the roller, either way
        return float(np.max(np.arccos(np.abs((normal * np.conj(push)).real)))) - limit

    for name, low, high, limit in (
        ("pressure_rise", 0.0, radians(60), radians(36)),
        ("pressure_return", radians(100), radians(170), radians(50)),
    ):
        base = found[name].base
        assert base is not None
        shifts = np.linspace(-0.6, 0.6, 1201)
        over = np.array([excess(s, low, high, limit) for s in shifts]) > 0
        last = int(np.flatnonzero(over)[-1])
        sizes = [0.12 * abs(axis - 1j * s * np.exp(0.5j * task.program.stroke) - 1) for s in shifts[last : last + 2]]
        assert sizes[0] - 1e-6 <= base <= sizes[1] + 1e-6
    assert found["pressure_rise"].binds


def test_commands_print_the_tables_of_the_program() -> None:
    """Table 5.1 and the three tables of program 2.7, each by one command and column by column."""
    spec = str(CONFIGS / "cam-oscillating.toml")
    tables = {
        ("law", "k,s,s1,s2"): ["i", "k", "s", "s1", "s2"],
        ("forces", "psi2,psi1,dpsi,psi,M_in"): ["i", "psi2", "psi1", "dpsi[deg]", "psi[deg]", "M_in[N*m]"],
        ("profile", "x_c,y_c,x_w,y_w,rho_c"): ["i", "x_c[m]", "y_c[m]", "x_w[m]", "y_w[m]", "rho_c[m]"],
        ("strength", "theta,R,kappa_red,sigma_H"): ["i", "theta[deg]", "R[N]", "kappa_red[1/m]", "sigma_H[Pa]"],
    }
    rows = {}
    for (command, columns), header in tables.items():
        asked = ["cam", command, spec, "-q", "--no-store", "--format", "csv", "--columns", columns]
        done = CliRunner().invoke(app, asked)
        assert done.exit_code == 0, done.output
        rows[command] = list(csv.DictReader(io.StringIO(done.stdout)))
        assert list(rows[command][0]) == header
    half = {command: next(row for row in each if row["i"] == "5") for command, each in rows.items()}
    assert (float(half["law"]["s"]), float(half["law"]["s1"])) == pytest.approx((0.5, 2.0))
    assert (float(half["forces"]["psi[deg]"]), float(half["forces"]["psi1"])) == pytest.approx((45.0, 1.0))
    assert float(half["profile"]["rho_c[m]"]) == pytest.approx(0.1)  # of a roller at rest about the axis of the cam
    rolled = half["strength"]
    stress = 0.418 * np.sqrt(2e11 * float(rolled["R[N]"]) / 0.007 * float(rolled["kappa_red[1/m]"]))
    assert float(rolled["sigma_H[Pa]"]) == pytest.approx(stress, rel=1e-12)


def test_flags_that_print_what_is_told_by_choice() -> None:
    runner = CliRunner()
    law = ["cam", "law", str(CONFIGS / "cam-translating.toml"), "-q", "--no-store", "--constants"]
    told = json.loads(runner.invoke(app, [*law, "--format", "json"]).stdout)
    assert told["rise"]["m1[m]"] == pytest.approx(0.02 / radians(80))
    assert told["return"]["c"] == [[0, 0, 0, 10, -15, 6]]
    refused = runner.invoke(app, [*law, "--columns", "phi"]).exception
    assert isinstance(refused, UsageError)
    assert "--columns" in str(refused)
    sizes = ["cam", "synth", str(CONFIGS / "cam-flat.toml"), "-q", "--no-store", "--candidates", "--format", "json"]
    found = json.loads(runner.invoke(app, sizes).stdout)["candidates"]
    assert found["convexity"]["binds"]
