"""The liner against the equation of the shell solved numerically, its limits, and the source's formulas."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import mpmath as mp
import numpy as np
import pytest
from bounding import assert_bounds
from scipy.integrate import solve_bvp

import tmmcalc
from tmmcalc.core.numerics.simpson import simpson
from tmmcalc.extras.liner import Clamp, Liner, LinerTask, solve_liner
from tmmcalc.extras.tables.tasks.liner import to_liner
from tmmcalc.project import templates

TASK = LinerTask(0.069, 0.0065, 0.08, 0.01, 1.1e11, 0.25, load=4e4, moment=1500.0, pressure=2e6, length=0.2)


def numbers(task: LinerTask) -> tuple[float, float, float, float]:
    """D, alpha, and what a unit of radial load and of moment does to the ring."""
    r, h = task.radius, task.thickness
    bending = task.young * h**3 / (12 * (1 - task.poisson**2))
    area = task.width * r * math.log(task.outer / r)
    ring = r**2 / (task.young * area)
    return bending, (task.young * h / (4 * r**2 * bending)) ** 0.25, ring, 12 * ring / task.width**2


def by_differential_equation(task: LinerTask, x: Any, length: float) -> Any:
    """w, dw/dx, M, Q (4, n) by collocation of D w'''' + E h w/r^2 = p with the ring at one end, the other one free."""
    bending, alpha, radial, turning = numbers(task)
    unit = task.radius / 1e5  # of w; x in 1/alpha
    sizes = unit * np.array([1, alpha, bending * alpha**2, bending * alpha**3])
    stiffness = task.young * task.thickness / task.radius**2

    def slopes(_: Any, y: Any) -> Any:
        return np.array([y[1], y[2], y[3], (task.pressure / unit - stiffness * y[0]) / (bending * alpha**4)])

    def ends(near: Any, far: Any) -> Any:
        w, psi, bend, shear = near * sizes
        turn = (task.moment + bend - shear * task.width / 2) * turning
        edge = task.width / 2 * turn if task.continuity == "edge" else 0.0
        return [(w - (task.load - shear) * radial - edge) / unit, (psi - turn) / (unit * alpha), far[2], far[3]]

    grid = np.linspace(0, alpha * length, 80)
    found = solve_bvp(slopes, ends, grid, np.zeros((4, 80)), tol=1e-8, max_nodes=20_000)
    assert found.success
    return found.sol(alpha * x) * sizes[:, None]


@pytest.mark.parametrize(
    "task",
    [
        TASK,
        replace(TASK, length=None, continuity="centre"),
        replace(TASK, length=0.03, pressure=0.0),
        replace(TASK, length=None, width=0.002, moment=-800.0, poisson=0.4),
    ],
)
def test_the_shell_equation_solved_numerically(task: LinerTask) -> None:
    found = solve_liner(task)
    length = task.length or 25 / found.alpha
    for one, other in zip(
        (found.w, found.slope, found.bend, found.shear), by_differential_equation(task, found.x, length), strict=True
    ):
        assert one == pytest.approx(other, abs=1e-9 * float(np.max(np.abs(other))))


@pytest.mark.parametrize("continuity", ["edge", "centre"])
def test_a_long_liner_by_the_formulas_of_the_source(continuity: Any) -> None:
    task = replace(TASK, length=None, pressure=0.0, continuity=continuity)
    found, (bending, alpha, radial, turning) = solve_liner(task), numbers(task)
    q0, m0, wave = found.force, found.couple, np.exp(-alpha * found.x)
    cos, sin = np.cos(alpha * found.x), np.sin(alpha * found.x)
    w = wave / (2 * alpha**3 * bending) * (q0 * cos - alpha * m0 * (cos - sin))
    assert found.w == pytest.approx(w, rel=1e-12, abs=1e-18)
    assert found.bend == pytest.approx(wave / alpha * (q0 * sin - alpha * m0 * (cos + sin)), rel=1e-9, abs=1e-9)
    assert found.end == pytest.approx((q0 - alpha * m0) / (2 * alpha**3 * bending))
    assert found.turn == pytest.approx(-(q0 - 2 * alpha * m0) / (2 * alpha**2 * bending))
    assert found.turn == pytest.approx((task.moment - m0 - q0 * task.width / 2) * turning)
    assert found.centre == pytest.approx((task.load - q0) * radial)
    edge = found.turn * task.width / 2 if continuity == "edge" else 0.0
    assert found.end == pytest.approx(found.centre + edge)
    other = solve_liner(replace(task, continuity="centre" if continuity == "edge" else "edge"))
    assert (found.other_force, found.other_couple) == pytest.approx((other.force, other.couple))


def test_forces_of_a_liner_found_by_hand() -> None:
    """alpha = 10/m, D = 1 kN*m; with r2 = e r1 the ring has F' = r1 b, and both equations are short."""
    h = math.sqrt(3 * 0.91) / 10  # r1 h = sqrt(3 (1 - mu^2))/alpha^2, with r1 = 0.1
    task = LinerTask(0.1, h, 0.1 * math.e, 0.1, 12 * 0.91e3 / h**3, 0.3, moment=100.0, continuity="centre")
    found = solve_liner(task)
    assert (found.alpha, found.stiffness) == pytest.approx((10.0, 1e3))
    radial, turning = 1 / task.young, 1200 / task.young
    # Q0 (1/2e6 + radial) - M0/2e5 = 0,  M0 (1/1e4 + turning) + Q0 (0.05 turning - 1/2e5) = 100 turning
    by_hand = np.linalg.solve([[5e-7 + radial, -5e-6], [0.05 * turning - 5e-6, 1e-4 + turning]], [0.0, 100 * turning])
    assert (found.force, found.couple) == pytest.approx(tuple(by_hand))


def test_a_ring_that_gives_way_hands_its_loads_on() -> None:
    found = solve_liner(replace(TASK, width=1e-7, pressure=0.0))
    assert (found.force, found.couple) == pytest.approx((TASK.load, TASK.moment), rel=1e-3)


@pytest.mark.parametrize("length", [None, 0.4])
def test_a_ring_that_does_not_give_way_clamps_the_end(length: float | None) -> None:
    """Timoshenko: a clamped end under pressure has M0 = p/(2 alpha^2), Q0 = -p/alpha."""
    found = solve_liner(replace(TASK, outer=1e5, width=1e3, load=0.0, moment=0.0, length=length, continuity="centre"))
    p = TASK.pressure
    assert abs(found.couple) == pytest.approx(p / (2 * found.alpha**2), rel=1e-4)
    assert abs(found.force) == pytest.approx(p / found.alpha, rel=1e-4)
    assert found.bending.stress == pytest.approx(3 * p / (found.alpha * TASK.thickness) ** 2, rel=1e-4)


def test_pressure_alone_stretches_a_tube_with_a_ring_of_its_own_section() -> None:
    """q that stretches the ring as much as the pressure the shell: nothing acts between them."""
    area = TASK.width * TASK.radius * math.log(TASK.outer / TASK.radius)
    task = replace(TASK, load=TASK.pressure * area / TASK.thickness, moment=0.0)
    found = solve_liner(task)
    tube = task.pressure * task.radius / task.thickness
    assert found.hoop == pytest.approx(np.full_like(found.hoop, tube))
    assert found.ring_stress == pytest.approx(tube)
    assert abs(found.couple) < 1e-9
    assert found.largest.stress == pytest.approx(tube)


def test_a_short_shell_is_one_ring_with_its_collar() -> None:
    """The forces by the load on both: q over the hoop stiffness of collar and shell, of a shell that hardly bends."""
    task = replace(TASK, length=0.004, pressure=0.0, moment=0.0)
    found = solve_liner(task)
    assert found.force == pytest.approx(task.young * task.thickness / task.radius**2 * 0.004 * found.w.mean(), rel=1e-3)
    assert any("free end is felt" in note for note in found.notes)


def test_energy_that_the_loads_put_in_is_that_of_ring_and_shell() -> None:
    """Clapeyron: it holds with the edge of the ring, not with its centre, whose compliance is not symmetric."""
    task = replace(TASK, pressure=0.0, rows=4000)
    balance = {}
    for each in (replace(task, continuity="edge"), replace(task, continuity="centre")):
        found, (bending, _, radial, turning) = solve_liner(each), numbers(each)
        density = found.bend**2 / bending + task.young * task.thickness * (found.w / task.radius) ** 2
        shell = simpson(found.x, density)
        assert shell is not None
        ring = found.centre**2 / radial + found.turn**2 / turning
        balance[each.continuity] = (shell + ring) / (task.load * found.centre + task.moment * found.turn)
    assert balance["edge"] == pytest.approx(1, abs=1e-10)
    assert abs(balance["centre"] - 1) > 1e-2


def test_the_largest_stress_is_that_of_a_dense_table() -> None:
    for task in (TASK, replace(TASK, moment=0.0, load=1.5e5, pressure=8e6), replace(TASK, moment=-900.0)):
        found, dense = solve_liner(task), solve_liner(replace(task, rows=50_000))
        surfaces = np.array([dense.inner, dense.outer])
        assert found.largest.stress == pytest.approx(float(surfaces.max()), rel=1e-7)
        assert found.largest.x == pytest.approx(float(dense.x[surfaces.max(axis=0).argmax()]), abs=1e-5)
        assert found.bending.stress == pytest.approx(float(np.abs(dense.axial).max()), rel=1e-7)


def test_the_clamp_gives_the_moment() -> None:
    clamp = Clamp(8e6, 0.13, 0.003)
    force = 1.8 * 8e6 * math.pi / 4 * 0.13**2
    found = solve_liner(replace(TASK, clamp=clamp))
    assert found.moment == pytest.approx(force * 0.003 / (2 * math.pi * TASK.radius))


def test_a_thick_wall_and_an_allowed_stress_are_told() -> None:
    found = solve_liner(replace(TASK, thickness=0.02, allowed=1e6))
    assert [note.split(":")[0] for note in found.notes] == ["warning", "warning"]


def test_through_a_spec() -> None:
    text = """
[liner]
radius = "69 mm"
thickness = "6.5 mm"
ring_outer = "80 mm"
ring_width = "10 mm"
young = "110000 MPa"
load = "40 N/mm"
moment = "1.5 kN"
pressure = "2 MPa"
length = "200 mm"
"""
    found: Liner = tmmcalc.solve_liner(tmmcalc.parse_spec(text))
    straight = tmmcalc.solve_liner(TASK)
    assert (found.force, found.couple) == pytest.approx((straight.force, straight.couple), rel=1e-13)


def exact(task: LinerTask) -> tuple[Any, Any]:
    """Q0 and M0 in the precision of mpmath by one system of six equations: four waves, Q0 and M0."""
    r, h, b, e = (mp.mpf(each) for each in (task.radius, task.thickness, task.width, task.young))
    bulk = 1 - mp.mpf(task.poisson) ** 2
    bending = e * h**3 / (12 * bulk)
    alpha = (e * h / (4 * r**2 * bending)) ** mp.mpf("0.25")
    assert task.length is not None
    length = mp.mpf(task.length)
    roots = [alpha * mp.mpc(one, other) for one in (-1, 1) for other in (1, -1)]
    area = b * r * mp.log(mp.mpf(task.outer) / r)
    radial = r**2 / (e * area)
    turning = 12 * radial / b**2
    led = b / 2 if task.continuity == "edge" else mp.mpf(0)
    rows = [[bending * k**3 for k in roots] + [-1, 0], [bending * k**2 for k in roots] + [0, 1]]
    rows += [[k**n * mp.exp(k * length) for k in roots] + [0, 0] for n in (2, 3)]
    rows += [[1 - led * k for k in roots] + [radial, 0], [*roots, b / 2 * turning, turning]]
    uniform = task.pressure * r**2 / (e * h)
    right = [0, 0, 0, 0, radial * mp.mpf(task.load) - uniform, turning * mp.mpf(task.moment)]
    found = mp.lu_solve(mp.matrix(rows), mp.matrix(right))
    return mp.re(found[4]), mp.re(found[5])


def test_the_ready_spec_by_six_equations_in_60_digits() -> None:
    spec = tmmcalc.load_spec(templates.path("extra-liner"))
    found, task = tmmcalc.solve_liner(spec), to_liner(spec)
    with mp.workdps(60):
        truth = exact(replace(task, moment=found.moment))
    assert (found.force, found.couple) == pytest.approx(tuple(map(float, truth)), rel=1e-13)
    assert (found.force, found.couple) == pytest.approx((45885.16, 1016.439), rel=1e-6)


@pytest.mark.slow
def test_estimates_bound_their_errors() -> None:
    rng = np.random.default_rng(7)
    pairs = []
    with mp.workdps(60):
        for _ in range(200):
            r = float(rng.uniform(0.03, 0.2))
            h = r * float(rng.uniform(0.01, 0.15))
            task = LinerTask(
                r, h, r * float(rng.uniform(1.02, 1.5)), h * float(rng.uniform(0.3, 4)), 1.1e11,
                float(rng.uniform(0, 0.4)), load=float(rng.uniform(-1e5, 1e5)),
                moment=float(rng.uniform(-4e3, 4e3)), length=float(math.sqrt(r * h) * rng.uniform(0.3, 8)),
                continuity="edge" if rng.random() < 0.5 else "centre",
            )  # fmt: skip
            found = solve_liner(task)
            assert found.error is not None
            told = (found.force, found.couple)
            missed = max(abs(float((one - other) / other)) for one, other in zip(told, exact(task), strict=True))
            pairs.append((found.error.forces, missed))
    assert_bounds(pairs, "forces")
