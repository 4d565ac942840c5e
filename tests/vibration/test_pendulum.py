"""The pendulum-rotor: the four limits, classical beams, textbook finite elements, critical speeds, torsion."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from math import sqrt

import numpy as np
import pytest
from scipy.linalg import eig, eigh
from scipy.optimize import brentq
from scipy.special import jn_zeros
from sparing import sparing

import tmmcalc
from tmmcalc.core.errors import NoSolutionError, SingularityError, UsageError
from tmmcalc.vibration.pendulum.basis import Basis, gauss, sample
from tmmcalc.vibration.pendulum.energies import matrices
from tmmcalc.vibration.pendulum.solve import solve_pendulum
from tmmcalc.vibration.pendulum.task import Disc, Mesh, PendulumTask, Rod, Speeds
from tmmcalc.vibration.pendulum.whirl import lowest, unbalance_curve, whirl

from .scenes import case, centrifuge

CHAIN = PendulumTask(Rod(1.3, 0.7, (1e-18, 1e-18), (0.0, 0.0)))
CANTILEVER = PendulumTask(Rod(1.0, 1.0, (1.0, 1.0), (0.0, 0.0)), pivot=None, gravity=0.0)


def first(task: PendulumTask, name: str = "both planes") -> np.ndarray:
    return next(modes.frequency for modes in solve_pendulum(task).modes if modes.name == name)


def spec_of(inputs: dict[str, float | bool], tolerance: str = "") -> tmmcalc.Spec:
    """A spec with the numbers of a worked case."""
    disc = f"[pendulum.disc]\nmass = {inputs['m']}\n"
    if "r_d2" in inputs:
        disc += f'gyration = "{sqrt(inputs["r_d2"])} m"\n'
    joint = '"clamped"' if inputs.get("clamped") else float(inputs.get("k", 0.0))
    return tmmcalc.parse_spec(
        f"[pendulum]\ngravity = {inputs['g']}\nspin = {inputs['Omega']}\nstiffness = {joint}\n"
        f'[pendulum.rod]\nlength = "{inputs["l"]} m"\nmass = "{inputs["rho"] * inputs["l"]} kg"\n'
        f"bending_stiffness = {inputs['EI']}\n{disc}"
    )


@pytest.mark.slow
def test_the_worked_cases_through_the_spec() -> None:
    inputs, expected = case("c2008-pendulum-01")
    chain, cantilever, gyro = (tmmcalc.solve_pendulum(spec_of(each)) for each in inputs["cases"])
    assert chain.modes[0].frequency[:3] == pytest.approx(expected["chain_omega"], rel=2e-7)
    assert cantilever.modes[0].frequency[:3] == pytest.approx(expected["cantilever_omega"], rel=2e-7)
    forward, backward = (modes.frequency[0] for modes in gyro.modes)
    assert forward == pytest.approx(expected["rigid_forward"], rel=2e-6)
    assert backward == pytest.approx(expected["rigid_backward"], rel=2e-6)
    for found in (chain, cantilever, gyro):
        assert found.error["frequencies"] < 1e-11


@pytest.mark.slow
def test_heavy_chain() -> None:
    """w = (j_0/2) sqrt(g/l), the zeros of the Bessel function."""
    exact = jn_zeros(0, 4) / 2 * sqrt(9.81 / 1.3)
    assert first(CHAIN) == pytest.approx(exact, rel=3e-12)


def test_cantilever() -> None:
    roots = [brentq(lambda b: np.cos(b) + 1 / np.cosh(b), k * np.pi, (k + 1) * np.pi, xtol=1e-15) for k in range(4)]
    assert first(CANTILEVER) == pytest.approx(np.array(roots) ** 2, rel=1e-12)


def test_rigid_pendulum_and_gyroscope() -> None:
    """A rod of 1e12 N*m^2: the formula of the rigid body to rounding, with spin and without."""
    rod = Rod(0.9, 2.0, (1e12, 1e12), (0.01, 0.01))
    still = PendulumTask(rod, Disc(3.0))
    line = 2.0 * 0.9
    inertia = line * 0.81 / 3 + line * 1e-4 + 3 * 0.81
    weight = (line / 2 + 3) * 0.9 * 9.81
    assert first(still)[0] == pytest.approx(sqrt(weight / inertia), rel=1e-11)
    spun = replace(still, disc=Disc(3.0, (0.15, 0.15), 0.3), pivot=20.0, spin=100.0)
    whole, polar = inertia + 0.15, 0.3 + 2 * line * 1e-4
    roots = np.roots([whole, -polar * 100, -(weight + 20)])
    assert first(spun, "forward")[0] == pytest.approx(max(roots), rel=1e-10)
    assert first(spun, "backward")[0] == pytest.approx(-min(roots), rel=1e-10)
    rigid = solve_pendulum(spun).rigid
    assert rigid == (pytest.approx(max(roots), rel=1e-13), pytest.approx(-min(roots), rel=1e-13))
    turned = solve_pendulum(replace(spun, spin=-100.0)).rigid
    assert turned == (pytest.approx(-min(roots), rel=1e-13), pytest.approx(max(roots), rel=1e-13))


def test_cantilever_with_a_disc() -> None:
    """Clamped rod, mass and rotary inertia at its end: the determinant of the four conditions."""
    m, j = 0.7, 0.02
    task = replace(CANTILEVER, disc=Disc(m, (j, j), 2 * j))

    def determinant(b: float) -> float:
        c, s, ch, sh = np.cos(b), np.sin(b), np.cosh(b), np.sinh(b)
        # z = A (cos - cosh) + B (sin - sinh); moment -> J w^2 slope, shear -> -m w^2 displacement
        moment = [-c - ch - j * b**3 * (-s - sh), -s - sh - j * b**3 * (c - ch)]
        shear = [s - sh + m * b * (c - ch), -c - ch + m * b * (s - sh)]
        return float(moment[0] * shear[1] - moment[1] * shear[0])

    grid = np.linspace(0.3, 9.0, 400)
    values = [determinant(b) for b in grid]
    k = [i for i in range(399) if values[i] * values[i + 1] < 0][:4]
    exact = [brentq(determinant, grid[i], grid[i + 1], xtol=1e-14) ** 2 for i in k]
    assert first(task)[: len(exact)] == pytest.approx(exact, rel=1e-11)


def hermite_elements(task: PendulumTask, many: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """K, M, G of the textbook's finite elements: nodes with displacement and slope, four-point quadrature."""
    rod, disc, h = task.rod, task.disc, task.rod.length / many
    k, m, g = (np.zeros((2 * many + 2, 2 * many + 2)) for _ in range(3))
    x, w = np.polynomial.legendre.leggauss(5)
    for e in range(many):
        for t, weight in zip((x + 1) / 2, w * h / 2, strict=True):
            n = np.array([1 - 3 * t**2 + 2 * t**3, h * (t - 2 * t**2 + t**3), 3 * t**2 - 2 * t**3, h * (t**3 - t**2)])
            d = np.array([(6 * t**2 - 6 * t) / h, 1 - 4 * t + 3 * t**2, (6 * t - 6 * t**2) / h, 3 * t**2 - 2 * t])
            c = np.array([(12 * t - 6) / h**2, (6 * t - 4) / h, (6 - 12 * t) / h**2, (6 * t - 2) / h])
            tension = task.gravity * (rod.density * (task.rod.length - (e + t) * h) + disc.mass)
            at = slice(2 * e, 2 * e + 4)
            i2 = rod.density * rod.radius[0] ** 2
            k[at, at] += weight * (rod.bending[0] * np.outer(c, c) + tension * np.outer(d, d))
            m[at, at] += weight * (rod.density * np.outer(n, n) + i2 * np.outer(d, d))
            g[at, at] += weight * 2 * i2 * np.outer(d, d)
    k[1, 1] += task.pivot or 0.0
    m[-2, -2] += disc.mass
    m[-1, -1] += disc.diametral[0]
    g[-1, -1] += disc.polar
    return k[1:, 1:], m[1:, 1:], g[1:, 1:]


@pytest.mark.slow
def test_spinning_rotor_against_finite_elements() -> None:
    """The same elements by hand, the quadratic problem in first-order form by a general solver."""
    task = centrifuge(mesh=Mesh(12, 3))
    k, m, g = hermite_elements(task, 12)
    n = len(k)
    zero, one = np.zeros((n, n)), np.eye(n)
    roots = eig(np.block([[zero, one], [k, task.spin * g]]), np.block([[one, zero], [zero, m]]), right=False)
    assert np.abs(roots.imag).max() < 1e-6 * np.abs(roots).max()
    found = solve_pendulum(task)
    assert [modes.name for modes in found.modes] == ["forward", "backward"]
    assert found.modes[0].frequency == pytest.approx(np.sort(roots.real[roots.real > 0])[:4], rel=1e-7)
    assert found.modes[1].frequency == pytest.approx(np.sort(-roots.real[roots.real < 0])[:4], rel=1e-7)
    fine = solve_pendulum(centrifuge())
    for coarse, better in zip(found.modes, fine.modes, strict=True):
        assert coarse.frequency == pytest.approx(better.frequency, rel=1e-4)
        assert np.all(coarse.frequency >= better.frequency * (1 - 1e-9)) or coarse.name == "backward"


@pytest.mark.slow
def test_hermite_cubics_converge_with_the_fourth_order() -> None:
    exact = first(CANTILEVER)[2]
    errors = [first(replace(CANTILEVER, mesh=Mesh(many, 3)))[2] / exact - 1 for many in (4, 8, 16)]
    for coarse, fine in pairwise(errors):
        assert np.log2(coarse / fine) == pytest.approx(4.0, abs=0.35)
    told = solve_pendulum(replace(CANTILEVER, mesh=Mesh(8, 3), modes=3)).error["frequencies"]
    assert told == pytest.approx(errors[1], rel=0.15)


@sparing("bending", [1e-3, 1e-5, 1e-7], every=3)
def test_soft_clamped_rods_with_their_layers(bending: float) -> None:
    """Against many textbook elements, graded by hand towards the joint and the lower end."""
    task = PendulumTask(Rod(1.0, 1.0, (bending, bending), (0.0, 0.0)), Disc(0.2), pivot=None, modes=3)
    found = solve_pendulum(task)
    layer = sqrt(bending / (9.81 * 1.2))
    steps = np.cumsum(np.minimum(layer / 8 * 1.12 ** np.arange(400), 1 / 80))
    edges = np.concatenate(([0.0], steps[steps < 0.995], [1.0]))
    assert found.modes[0].frequency == pytest.approx(reference_frequencies(task, edges)[:3], rel=3e-7)
    assert found.error["frequencies"] < 1e-9


def reference_frequencies(task: PendulumTask, edges: np.ndarray) -> np.ndarray:
    """Clamped rod, Hermite elements of any sizes, scipy."""
    n = len(edges)
    k, m = np.zeros((2 * n, 2 * n)), np.zeros((2 * n, 2 * n))
    x, w = np.polynomial.legendre.leggauss(5)
    for e, h in enumerate(np.diff(edges)):
        for t, weight in zip((x + 1) / 2, w * h / 2, strict=True):
            shape = np.array(
                [1 - 3 * t**2 + 2 * t**3, h * (t - 2 * t**2 + t**3), 3 * t**2 - 2 * t**3, h * (t**3 - t**2)]
            )
            d = np.array([(6 * t**2 - 6 * t) / h, 1 - 4 * t + 3 * t**2, (6 * t - 6 * t**2) / h, 3 * t**2 - 2 * t])
            c = np.array([(12 * t - 6) / h**2, (6 * t - 4) / h, (6 - 12 * t) / h**2, (6 * t - 2) / h])
            tension = task.gravity * (1 - edges[e] - t * h + task.disc.mass)
            at = slice(2 * e, 2 * e + 4)
            k[at, at] += weight * (task.rod.bending[0] * np.outer(c, c) + tension * np.outer(d, d))
            m[at, at] += weight * np.outer(shape, shape)
    m[-2, -2] += task.disc.mass
    inverse = eigh(m[2:, 2:], k[2:, 2:], eigvals_only=True)  # the other way round the low modes keep their digits
    return 1 / np.sqrt(inverse[::-1][:5])


def test_critical_speeds_are_where_whirl_meets_the_spin() -> None:
    task = centrifuge(speeds=Speeds(0.0, 400.0, 21))
    found = solve_pendulum(task)
    assert len(found.forward_critical) >= 2
    for speed in found.forward_critical[:3]:
        both = solve_pendulum(replace(task, spin=float(speed), speeds=None, disc=replace(task.disc, eccentricity=0.0)))
        assert np.min(np.abs(both.modes[0].frequency / speed - 1)) < 1e-9
    for speed in found.backward_critical[:3]:
        both = solve_pendulum(replace(task, spin=float(speed), speeds=None, disc=replace(task.disc, eccentricity=0.0)))
        assert np.min(np.abs(both.modes[1].frequency / speed - 1)) < 1e-9


def test_campbell_diagram() -> None:
    """At the spin it has the modes of the stage; forward rises, backward falls; without spin they are one."""
    task = centrifuge(speeds=Speeds(0.0, 314.0, 3))
    found = solve_pendulum(task)
    campbell = found.campbell
    assert campbell.forward[:, 1] == pytest.approx(found.modes[0].frequency, rel=1e-9)
    assert campbell.backward[:, 1] == pytest.approx(found.modes[1].frequency, rel=1e-9)
    assert campbell.forward[:, 0] == pytest.approx(campbell.backward[:, 0], rel=1e-11)
    assert np.all(np.diff(campbell.forward) > 0)
    assert np.all(np.diff(campbell.backward) < 0)


def test_whirl_of_the_unbalance() -> None:
    """Static and dynamic: far beyond the critical speeds of a rigid pendulum the disc turns about its own centre."""
    task = centrifuge()
    found = solve_pendulum(task)
    basis = Basis((0.0, 1.0), 14, True)
    parts = matrices(task, basis, 0)
    left = parts.stiffness - task.spin**2 * (parts.mass - parts.spin)
    shape = np.linalg.solve(left, parts.tip) * 4.0 * 2e-4 * task.spin**2
    assert found.deflection == pytest.approx(float(parts.tip @ shape), rel=1e-9)
    assert found.deflection < 0
    curve = unbalance_curve(parts, 8e-4, np.array([0.0, task.spin]))
    assert curve == pytest.approx([0.0, found.deflection], rel=1e-9)
    critical = float(solve_pendulum(centrifuge(spin=1.0)).forward_critical[0])
    with pytest.raises(SingularityError, match="critical speed"):
        solve_pendulum(centrifuge(spin=critical))


def test_torsion() -> None:
    """Bare rod in closed form; with a disc the transcendental roots; a massless rod a single one."""
    rod = Rod(0.8, 0.9, (200.0, 200.0), (0.003, 0.004), 160.0)
    section = 0.9 * (0.003**2 + 0.004**2)
    bare = solve_pendulum(PendulumTask(rod)).torsion
    assert bare == pytest.approx((np.arange(4) + 0.5) * np.pi / 0.8 * sqrt(160 / section), rel=1e-13)
    with_disc = solve_pendulum(PendulumTask(rod, Disc(2.0, (0.01, 0.01), 3e-5))).torsion
    b = with_disc * 0.8 / sqrt(160 / section)
    assert b * np.tan(b) == pytest.approx(np.full(4, section * 0.8 / 3e-5), rel=1e-9)
    assert np.array_equal(np.floor(b / (np.pi / 2)), [0, 2, 4, 6])
    light = replace(rod, radius=(0.0, 0.0))
    single = solve_pendulum(PendulumTask(light, Disc(2.0, (0.01, 0.01), 0.02))).torsion
    assert single == pytest.approx([sqrt(160 / (0.8 * 0.02))], rel=1e-13)


def test_two_planes() -> None:
    """A flat rod without spin: each plane is that of a rod with its stiffness alone; with spin it is refused."""
    flat = PendulumTask(Rod(1.0, 0.8, (200.0, 30.0), (0.004, 0.002)), Disc(1.0, (0.01, 0.03), 0.04), 5.0)
    found = solve_pendulum(flat)
    assert [modes.name for modes in found.modes] == ["plane xz", "plane yz"]
    for k, modes in enumerate(found.modes):
        bending, radius, diametral = (pair[k] for pair in (flat.rod.bending, flat.rod.radius, flat.disc.diametral))
        alone = replace(
            flat,
            rod=replace(flat.rod, bending=(bending, bending), radius=(radius, radius)),
            disc=replace(flat.disc, diametral=(diametral, diametral)),
        )
        assert modes.frequency == pytest.approx(first(alone), rel=1e-11)
    with pytest.raises(UsageError, match="two planes"):
        solve_pendulum(replace(flat, spin=10.0))


def test_nothing_holds_the_rod() -> None:
    with pytest.raises(NoSolutionError, match="neither gravity nor"):
        solve_pendulum(replace(CANTILEVER, pivot=0.0))


@pytest.mark.slow
def test_mode_shapes_are_orthogonal_and_counted() -> None:
    found = solve_pendulum(replace(CHAIN, modes=6))
    modes = found.modes[0]
    assert modes.nodes == (0, 1, 2, 3, 4, 5)
    from scipy.special import j0

    for k, zero in enumerate(jn_zeros(0, 6)):
        exact = j0(zero * np.sqrt(1 - found.place / 1.3))
        assert modes.shapes[k] == pytest.approx(exact / exact[-1], abs=1e-8)


@pytest.mark.parametrize("nodal", [False, True])
def test_the_functions_of_the_basis(nodal: bool) -> None:
    """Slopes and curvatures are derivatives; cubics and a quintic lie in the space; both bases are the same space."""
    basis = Basis((0.0, 0.3, 1.0), 5, True, nodal)
    s = np.array([0.11, 0.29, 0.5, 0.97])
    h = 1e-6
    at, above, below = (sample(basis, s + d) for d in (0.0, h, -h))
    assert (above.value - below.value) / (2 * h) == pytest.approx(at.slope, abs=1e-8)
    assert (above.slope - below.slope) / (2 * h) == pytest.approx(at.curvature, abs=1e-7)
    points, weights = gauss(basis)
    assert weights.sum() == pytest.approx(1.0, abs=1e-14)
    rows = sample(basis, points).value
    for power in (1, 3, 5):
        best, *_ = np.linalg.lstsq(rows.T, points**power, rcond=None)
        assert best @ sample(basis, s).value == pytest.approx(s**power, abs=1e-11)
    parts = matrices(centrifuge(), basis, 0)
    other = matrices(centrifuge(), Basis((0.0, 0.3, 1.0), 5, True, not nodal), 0)
    spin = np.array(157.0)
    for a, b in zip(lowest(whirl(parts, spin), 4), lowest(whirl(other, spin), 4), strict=True):
        assert a == pytest.approx(b, rel=1e-9)


def turning(axis: np.ndarray) -> np.ndarray:
    """The rotation about an axis by its length (Rodrigues)."""
    size = float(np.linalg.norm(axis))
    x, y, z = axis
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    if size == 0:
        return np.eye(3)
    return np.eye(3) + np.sin(size) / size * cross + (1 - np.cos(size)) / size**2 * cross @ cross


def test_gyroscopic_moment_from_the_kinetic_energy_of_a_spinning_body() -> None:
    """T of a disc from its rotation matrix: what mixes slopes and their rates is Omega J_p, for a spin from x to y."""
    diametral, polar, omega, h = 0.03, 0.07, 11.0, 1e-4

    def energy(v: float, w: float, dv: float, dw: float) -> float:
        def rotation(t: float) -> np.ndarray:
            slope = np.array([v + dv * t, w + dw * t])
            return turning(np.array([0.0, -slope[1], slope[0]])) @ turning(np.array([omega * t, 0.0, 0.0]))

        rate = rotation(0.0).T @ (rotation(h) - rotation(-h)) / (2 * h)
        body = np.array([rate[2, 1], rate[0, 2], rate[1, 0]])
        return float(polar * body[0] ** 2 + diametral * (body[1] ** 2 + body[2] ** 2)) / 2

    def mixed(first: int, second: int) -> float:
        d = 1e-2
        total = 0.0
        for a in (1, -1):
            for b in (1, -1):
                at = np.zeros(4)
                at[first] += a * d
                at[second] += b * d
                total += a * b * energy(*at)
        return total / (4 * d * d)

    # d/dt (dT/dv') - dT/dv holds w' times this; in M z'' - i Omega G z' its real part is + Omega G w'
    gyroscopic = mixed(1, 2) - mixed(0, 3)
    assert gyroscopic == pytest.approx(omega * polar, rel=1e-3)
