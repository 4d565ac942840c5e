"""Linkage and machine stages of every ready spec against numbers from elsewhere: closure, Newton-Euler, scipy, hand."""

from __future__ import annotations

import cmath
import math
from dataclasses import replace

import numpy as np
import pytest
from ready import SPECS

import tmmcalc
from tmmcalc.core.plan import plan

from .independent import TURN, braked_angle, project, turned

# a torque diagram has no links to solve beside the package: machine/stages/test_reduced_inertia.py
RUNNING = {name: plan(spec).running for name, spec in SPECS.items() if spec.torque is None}


QUICK = {"four-bar", "class-three", "shaper", "press", "piston-pump", "four-stroke-engine"}  # the others are long


def having(stage: str) -> list[str]:
    return [name for name, stages in RUNNING.items() if stage in stages]


def each(stage: str, *without: str) -> pytest.MarkDecorator:
    """Every ready spec that has this stage."""
    names = [name for name in having(stage) if name not in without]
    return pytest.mark.parametrize(
        "name", [pytest.param(name, marks=[] if name in QUICK else [pytest.mark.slow]) for name in names]
    )


def test_the_ready_specs_show_every_stage_of_linkage_and_machine() -> None:
    assert set(having("structure")) == set(having("kinematics"))
    for stage in ("forces", "reduction", "power", "flywheel", "motion"):
        assert len(having(stage)) >= 5
    assert having("transient") == ["course-project", "elastic-drive", "geared-press"]
    assert set(having("balance")) - set(having("forces")) == {"in-line-engine", "rotor"}


@each("structure")
def test_mobility(name: str) -> None:
    """Chebyshev: W = 3 n - 2 p, and 3 n' = 2 p' in every group."""
    found, structure = project(name), project(name).run.results["structure"]
    links, joints = len(found.spec.mechanism.links), len(found.spec.mechanism.joints)
    assert structure.mobility == 3 * links - 2 * joints == 1
    assert sum(len(group.links) for group in structure.groups) == links - (structure.driven is None)
    for group in structure.groups:
        assert 3 * len(group.links) == 2 * (len(group.inner) + len(group.outer)) + bool(group.drive)


@each("structure")
def test_velocities_and_accelerations(name: str) -> None:
    found = project(name)
    trace, reference = found.run.results["kinematics"].trace, found.positions.reference
    for k, link in enumerate(trace.link_ids):
        motion = reference.angles[link]
        assert trace.dangle[k] == pytest.approx(motion.first, abs=1e-12 * (1 + np.abs(motion.first).max()))
        assert trace.ddangle[k] == pytest.approx(motion.second, abs=1e-11 * (1 + np.abs(motion.second).max()))
    for k, joint in enumerate(trace.joint_names):
        motion = reference.slides[joint]
        assert trace.dds[k] == pytest.approx(motion.second, abs=1e-11 * (1 + np.abs(motion.second).max()))


@each("forces")
def test_drive_and_largest_reaction(name: str) -> None:
    found = project(name)
    forces, statics, smooth = found.run.results["forces"], found.statics, found.smooth
    assert np.count_nonzero(smooth) >= 0.8 * len(smooth)
    drive = np.abs(statics.drive).max()
    assert np.abs(forces.drive - statics.drive)[smooth].max() < 1e-12 * drive
    reaction = np.abs(statics.reaction).max()
    assert np.abs(forces.reaction - statics.reaction)[:, smooth].max() < 1e-12 * reaction


@each("reduction")
def test_reduced_inertia_and_moment(name: str) -> None:
    """J from the velocities of all bodies; the moment is what the drive has to give, less the power of inertia."""
    found = project(name)
    reduction, forces = found.run.results["reduction"], found.run.results["forces"]
    rows = [forces.labels.index(label) for label in reduction.labels]
    inertia = found.inertia(found.rows)[rows]
    assert np.abs(reduction.inertia - inertia).max() < 1e-13 * inertia.max()
    moment = -(found.statics.drive + found.power_of_inertia(found.rows) / found.rows.speed)[rows]
    off = np.abs(reduction.total - moment)[found.smooth[rows]]
    assert off.max() < 1e-12 * np.abs(found.statics.drive).max()


@each("power")
def test_work_of_the_cycle(name: str) -> None:
    """The drive's mean over 720 positions of the statics; loads that jump cost it half a step of the jump."""
    found = project(name)
    grid = replace(found.mechanism.grid, positions=720, extremes=False)
    mechanism = replace(found.mechanism, grid=grid)
    forces, power = tmmcalc.solve_forces(mechanism, found.loading), found.run.results["power"]
    work = float(np.trapezoid(forces.drive, forces.theta)) * np.sign(forces.speed)
    assert power.mean_moment * forces.theta[-1] == pytest.approx(work, rel=3e-3, abs=1e-9 * np.abs(forces.drive).max())
    total = sum(part.work for part in power.parts)
    assert total == pytest.approx(-work, rel=3e-3, abs=1e-9 * np.abs(forces.drive).max())


@each("flywheel")
def test_unevenness_with_the_flywheel_that_was_found(name: str) -> None:
    found = project(name)
    wheel = found.run.results["flywheel"]
    if wheel.required is not None:
        regime = wheel.required.regime
        delta, gap = turned(found, wheel.inertia, float(regime.omega_at(np.zeros(1))[0]))
        assert delta <= wheel.delta * (1 + 1e-4)
        assert delta == pytest.approx(regime.delta, rel=1e-4)
        assert abs(gap) < 1e-6
        if wheel.addition > 0:
            assert regime.delta == pytest.approx(wheel.delta, rel=1e-6)
        return
    cycle, power = found.run.results["reduction"].cycle, found.run.results["power"]
    theta = np.linspace(0, cycle.period, 7201)
    moment, inertia = cycle.panels.at(np.stack((cycle.moment, cycle.inertia)), theta)
    step = theta[1]
    surplus = np.concatenate(([0.0], np.cumsum((moment[1:] + moment[:-1]) / 2 + power.mean_moment) * step))
    high, low = (cycle.speed**2 * (1 + sign * wheel.delta / 2) ** 2 / 2 for sign in (1, -1))
    needed = (np.max(surplus - high * inertia) - np.min(surplus - low * inertia)) / (wheel.delta * cycle.speed**2)
    assert wheel.inertia == pytest.approx(needed, rel=1e-4)


@each("motion")
def test_one_cycle_of_the_steady_motion(name: str) -> None:
    found = project(name)
    motion = found.run.results["motion"]
    delta, gap = turned(found, motion.inertia.total, float(motion.omega[0]))
    assert delta == pytest.approx(motion.regime.delta, rel=1e-4)
    assert abs(gap) < 1e-6


@pytest.mark.slow
def test_way_of_the_crank_in_the_emergency_stop() -> None:
    found = project("elastic-drive")
    stop = next(m for m in found.run.results["transient"].motions if m.name == "emergency stop")
    turned_by = braked_angle(found, "emergency stop", 60.0)
    assert stop.theta[-1, -1] - stop.theta[-1, 0] == pytest.approx(turned_by, rel=1e-8)
    assert stop.brake_work[-1] == pytest.approx(-60 * turned_by, rel=1e-8)


@each("balance", "in-line-engine", "rotor", "best-counterweights", "best-four-bar")  # with weights of their own
def test_best_counterweight(name: str) -> None:
    """Minus the first harmonic of the shaking force, over omega^2, in the axes of the crank."""
    found = project(name)
    at = found.moving(np.sign(found.mechanism.input.speed) * np.arange(128) * TURN / 128)
    force = -sum(body.mass * at.point(body.link, body.center).a for body in found.loading.bodies)
    crank = next(link for link in found.mechanism.links if link.id == 1)
    turned_by = at.angle(1)[0] + cmath.phase(crank.points["A"])
    first = complex(np.mean(force * np.exp(-1j * turned_by)))
    linkage = found.run.results["balance"].linkage
    scheme = next(scheme for scheme in linkage.schemes if scheme.name == "least squares")
    (weight,) = scheme.balance.weights
    assert weight.moment == pytest.approx(-first / at.speed**2, rel=1e-10)
    left = math.sqrt(np.mean(np.abs(force) ** 2) - abs(first) ** 2)
    assert scheme.balance.after.rms == pytest.approx(left, rel=1e-9)


def test_second_order_of_four_cylinders_in_line() -> None:
    """4 m r omega^2 (L + L^3/4 + 15 L^5/128 + ...) with L = r/l: the series of the textbooks of engines."""
    engine = project("in-line-engine").run.results["balance"].engine
    ratio, speed = 43 / 145, 5500 * TURN / 60
    series = ratio + ratio**3 / 4 + 15 * ratio**5 / 128 + 35 * ratio**7 / 512
    second = next(order for order in engine.balance.orders if order.order == 2)
    assert second.largest_force == pytest.approx(4 * 0.62 * 0.043 * speed**2 * series, rel=1e-4)
    first = next(order for order in engine.balance.orders if order.order == 1)
    assert first.largest_force < 1e-12 * first.force_alone


def test_correction_masses_of_the_rotor() -> None:
    """The lever rule by hand: moments about either plane."""
    rotor = project("rotor").run.results["balance"].rotor
    unbalances = [(24e-3, 0.17, 30, 0.16), (31e-3, 0.15, 205, 0.32), (18e-3, 0.175, -80, 0.455)]
    vectors = [(cmath.rect(m * r, math.radians(angle)), z) for m, r, angle, z in unbalances]
    second = -sum(u * (z - 0.14) for u, z in vectors) / 0.34
    first = -sum(u for u, _ in vectors) - second
    for weight, moment in zip(rotor.dynamic, (first, second), strict=True):
        assert weight.mass == pytest.approx(abs(moment) / 0.18, rel=1e-12)
        assert cmath.rect(1, weight.angle) == pytest.approx(moment / abs(moment), abs=1e-12)
