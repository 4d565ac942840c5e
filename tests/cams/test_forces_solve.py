"""The stage of the forces: worked case of a whole turn, equilibrium at rows, work, jamming, loss of contact."""

import json
from dataclasses import replace
from math import atan, degrees, pi, radians
from pathlib import Path

import numpy as np
import pytest
from sparing import sparing

from cams.turns import overshooting, task_of
from tmmcalc.cams.facts.cam_forces import document as forces_document
from tmmcalc.cams.follower import Follower, contact_path
from tmmcalc.cams.forces.columns import force_columns
from tmmcalc.cams.forces.results import CamForces
from tmmcalc.cams.forces.solve import solve_forces
from tmmcalc.cams.forces.turn import crossings, smooth_panels
from tmmcalc.cams.laws.catalogue import LAWS
from tmmcalc.cams.program import Phase, Program
from tmmcalc.cams.task import AngleLimits, Asked, CamTask, Force, Guide, Loads, Spring
from tmmcalc.core.conversion import from_record, to_record
from tmmcalc.core.errors import NoSolutionError, SingularityError, UsageError

CASES = {case["id"]: case for case in json.loads((Path(__file__).parents[1] / "cases/cams.json").read_text())}


def program(stroke, rise_law="cosine", back_law="shun", angles=(80, 20, 90)):
    rise, high, back = map(radians, angles)
    phases = (
        Phase("rise", rise, 0.0, stroke, LAWS[rise_law]),
        Phase("high dwell", high, stroke, stroke),
        Phase("return", back, stroke, 0.0, LAWS[back_law]),
        Phase("low dwell", 2 * pi - rise - high - back, 0.0, 0.0),
    )
    return Program(tuple(phase for phase in phases if phase.angle > 1e-12))


FOLLOWER = Follower("translating", 0.05, 0.005, 0.008)
ROCKER = Follower("oscillating", radians(30), roller=0.01, centres=0.1, rocker=0.09, assembly=-1, sense=-1)


def task(kind="translating", *, laws=("cosine", "shun"), stroke=0.02, closure="force", guide=None, step=5.0, **loads):
    given = {"speed": 100.0, "mass": 0.2, "friction": 0.1, "spring": Spring(safety=1.5), **loads}
    return CamTask(
        program(stroke, *laws),
        Asked(kind, closure=closure),
        AngleLimits(1.0, None),
        step=radians(step),
        loads=Loads(**given),
        guide=Guide(top=0.125) if guide is None else guide,
    )


def rocker_task(**loads):
    given = {"mass": 1e-4, "friction": 0.0, "pivot_friction": 0.15, "pivot_radius": 0.006, **loads}
    return task("oscillating", laws=("sine", "poly5"), stroke=radians(30), **given)


def flat_task(**loads):
    return task("flat", laws=("sine", "sine"), stroke=0.012, guide=Guide(length=0.03), **loads)


def test_whole_turn_of_the_worked_case():
    expected = CASES["cams-s20"]["expected"]
    found = solve_forces(task(), FOLLOWER)
    rows = [
        int(np.flatnonzero(np.abs(np.degrees(found.positions.phi) - phi) < 1e-9)[-1]) for phi in expected["phi_deg"]
    ]
    close = {"rel": 1e-4, "abs": 1e-6}
    assert np.degrees(found.theta[rows]) == pytest.approx(expected["theta_deg"], **close)
    assert found.load[rows] == pytest.approx(expected["P_c_N"], **close)
    assert found.contact[rows] == pytest.approx(expected["R_N"], **close)
    assert np.abs(found.lower[rows]) == pytest.approx(expected["N1_N"], **close)
    assert -1e3 * found.torque[rows] == pytest.approx(expected["T_driving_Nmm"], **close)
    assert found.guide.length == pytest.approx(1e-3 * expected["l_mm"])
    assert found.extreme("R").largest == pytest.approx(expected["R_max_N"], **close)
    assert found.extreme("N1").size == pytest.approx(expected["N1_max_N"], **close)
    assert found.spring.stiffness == pytest.approx(1e3 * expected["c_N_per_mm"])
    assert (found.verdict, found.lost, found.notes) == ("ok", (), ())


@sparing(
    ("given", "follower"),
    [
        (task(), FOLLOWER),
        (task(spring=Spring("given", stiffness=3e3, preload=60.0), force=Force(-40.0, -15.0)), FOLLOWER),
        (task(closure="groove", spring=Spring("none")), FOLLOWER),
        (rocker_task(), ROCKER),
        (rocker_task(force=Force(-0.4, 0.1)), ROCKER),
        (flat_task(), Follower("flat", 0.05)),
        (task(force=Force(phi=np.radians([0, 40, 100, 200]), values=np.array([0.0, -30.0, -30.0, 0.0]))), FOLLOWER),
    ],
    every=3,
)
def test_work_of_a_turn(given, follower):
    """Inertia, spring and weight give nothing in a turn, so the balance closes; against a dense sum as well."""
    found = solve_forces(given, follower)
    work = found.work
    assert work.error < 1e-12
    assert work.friction > 0
    assert work.driving + work.force == pytest.approx(work.friction, rel=1e-9)
    assert work.mean == pytest.approx(work.driving / (2 * pi))
    fine = solve_forces(replace(given, step=radians(0.01)), follower)
    dense = np.trapezoid(fine.driving, fine.positions.phi)
    assert dense == pytest.approx(work.driving, abs=2e-6 * np.max(np.abs(fine.driving)))
    for each in found.extremes:
        column = next(c for h, c in force_columns(fine).items() if h.partition("[")[0] == each.name)
        scale = 1e-5 * each.size
        assert each.least == pytest.approx(column.min(), abs=scale)
        assert each.largest == pytest.approx(column.max(), abs=scale)
        assert each.least <= column.min() + 1e-9 * each.size
        assert each.largest >= column.max() - 1e-9 * each.size


def test_mirrored_cam_turns_the_reactions_over():
    """The other sense of rotation is the mirror image: same sizes, edges on the other side."""
    one, other = (solve_forces(task(), replace(FOLLOWER, sense=sense)) for sense in (1, -1))
    assert np.array_equal(one.contact, other.contact)
    assert np.array_equal(one.lower, -other.lower)
    rock, back = (solve_forces(rocker_task(), replace(ROCKER, sense=sense)) for sense in (1, -1))
    assert np.array_equal(rock.pivot[0], back.pivot[0])
    assert np.array_equal(rock.pivot[1], -back.pivot[1])


@pytest.mark.parametrize("assembly", [1, -1])
@pytest.mark.parametrize("sense", [1, -1])
def test_rocker_is_in_equilibrium(assembly, sense):
    """Pivot force and contact along the profile's normal, moments about the pivot with the friction of its pin."""
    follower = replace(ROCKER, assembly=assembly, sense=sense)
    given = rocker_task()
    found = solve_forces(given, follower)
    motion = given.program.at(found.positions.phi, found.positions.piece)
    path = contact_path(follower, found.positions.phi, motion)
    turn = np.exp(-1j * found.positions.phi)
    centre, normal = path[0] * turn, -1j * path[1] / np.abs(path[1]) * turn  # in the frame of the machine
    centre, normal = follower.placed(centre), follower.placed(normal)
    force = found.contact * normal
    assert force + found.pivot[0] + 1j * found.pivot[1] == pytest.approx(np.zeros(len(force)), abs=1e-10)
    lever = centre - follower.centres
    about = (np.conj(lever) * force).imag * assembly * sense * -1  # positive as psi grows
    sign = np.sign(motion[1])
    rubbed = 0.15 * 0.006 * np.abs(found.contact) * sign
    moving = sign != 0
    assert (found.load + about - rubbed)[moving] == pytest.approx(np.zeros(moving.sum()), abs=1e-12)


def test_offset_guide_and_weight():
    """Weight along the lift is part of the resultant; the spring is sized with it."""
    found = solve_forces(task(gravity=-9.81), FOLLOWER)
    assert found.force == pytest.approx(np.full(len(found.force), -0.2 * 9.81))
    total = found.inertia + found.elastic + found.force
    assert found.load == pytest.approx(total, rel=1e-12)


def test_without_friction_and_guide():
    found = solve_forces(task(friction=0.0, guide=Guide()), FOLLOWER)
    assert found.guide is None
    assert found.lower is None
    assert found.contact == pytest.approx(-found.load / np.cos(found.theta), rel=1e-12)
    assert found.driving == pytest.approx(-found.torque, abs=1e-12)
    assert found.work.friction == 0
    assert abs(found.work.driving) < 1e-12


def test_loss_of_contact_is_located():
    """Weak spring: P_c = 0 where Q0 + c dS = P, in closed form for the cosine law."""
    spring = Spring("given", stiffness=2000.0, preload=20.0)
    given = task(laws=("cosine", "cosine"), spring=spring)
    found = solve_forces(given, FOLLOWER)
    assert found.verdict == "loss_of_contact"
    assert len(found.lost) == 2
    top = 0.2 * 100**2 * 0.02 * (pi**2 / 2) / radians(80) ** 2
    # 20 + 20 (1 - cos(pi k)) = -top cos(pi k)
    k = np.arccos(-40.0 / (top - 20.0)) / pi
    assert found.lost[0] == pytest.approx((k * radians(80), radians(80)), abs=1e-11)
    assert found.lost[1][0] == pytest.approx(radians(100), abs=1e-12)
    assert found.spring.reached < 1
    assert found.notes[0].startswith("warning: nothing presses")
    held = solve_forces(replace(given, asked=replace(given.asked, closure="groove")), FOLLOWER)
    assert held.verdict == "ok"
    assert held.reversals == pytest.approx(
        (k * radians(80), radians(80), radians(100), radians(100 + 90 * (1 - k2(90))))
    )


def k2(angle):
    """Part of the return, counted back, where the same spring balances the inertia."""
    top = 0.2 * 100**2 * 0.02 * (pi**2 / 2) / radians(angle) ** 2
    return float(np.arccos(-40.0 / (top - 20.0)) / pi)


def test_groove_changes_walls_where_the_resultant_is_zero():
    found = solve_forces(task(closure="groove", spring=Spring("none"), laws=("cosine", "sine")), FOLLOWER)
    assert np.degrees(found.reversals) == pytest.approx([40.0, 145.0], abs=1e-9)
    assert found.extreme("R").least < 0 < found.extreme("R").largest
    assert found.lost == ()


def test_force_closure_without_a_spring_is_lost_in_the_dwells():
    found = solve_forces(task(spring=Spring("none")), FOLLOWER)
    # rise: pressed until P turns at half; then open over the dwell and until half of the return
    assert np.degrees(found.lost) == pytest.approx(np.array([[40.0, 145.0], [190.0, 360.0]]), abs=1e-9)


@pytest.mark.slow
def test_jamming_is_refused_with_its_place():
    follower, guide = Follower("translating", 0.01, 0.0, 0.005), Guide(length=0.008, gap=0.01)
    given = task(friction=0.25, guide=guide)
    with pytest.raises(SingularityError, match="jams for phi from") as caught:
        solve_forces(given, follower)
    assert caught.value.value < 0
    # the ends: tan(theta) = 1/(f (1 + 2 q/l)) by a scan
    phi = np.linspace(0, radians(80), 800_001)
    y, y1, *_ = given.program.at(phi)
    q = 0.02 + 0.005 + 0.01 - y
    stuck = phi[y1 / (0.01 + y) >= 1 / (0.25 * (1 + 2 * q / 0.008))]
    for end in (stuck[0], stuck[-1]):
        assert f"{degrees(end):.3f}" in str(caught.value) or f"{degrees(end):.2f}" in str(caught.value)
    free = solve_forces(task(friction=0.02, guide=guide), follower)
    assert 0 < free.reserve.eaten < 1
    q = float(0.035 - given.program.at(np.array([free.reserve.phi]))[0, 0])
    assert free.reserve.critical == pytest.approx(atan(1 / (0.02 * (1 + 2 * q / 0.008))), rel=1e-9)


def test_a_groove_jams_on_the_return_under_the_outer_wall():
    """R < 0 on the return lifts against the motion: friction enters with the other sign."""
    guide = Guide(length=0.02, gap=0.0)
    held = task(closure="groove", spring=Spring("none"), friction=0.3, guide=guide, laws=("cosine", "cosine"))
    found = solve_forces(held, FOLLOWER)
    phi = np.degrees(found.positions.phi)
    row = int(np.flatnonzero(np.abs(phi - 120) < 1e-9)[0])
    assert found.contact[row] < 0
    theta, mu = found.theta[row], found.ratio[row]
    assert found.contact[row] == pytest.approx(-found.load[row] / (np.cos(theta) - mu), rel=1e-12)


def test_near_jamming_is_warned_of():
    found = solve_forces(task(friction=0.4, guide=Guide(length=0.016)), FOLLOWER)
    assert 0.5 < found.reserve.eaten < 1
    assert any("useful component" in note for note in found.notes)


def test_faults_say_what_to_change():
    with pytest.raises(UsageError, match="needs its length"):
        solve_forces(task(guide=Guide()), FOLLOWER)
    with pytest.raises(NoSolutionError, match="no length"):
        solve_forces(task(guide=Guide(top=0.07)), FOLLOWER)
    with pytest.raises(UsageError, match="speed"):
        solve_forces(replace(task(), loads=None), FOLLOWER)


@pytest.mark.parametrize(
    ("given", "follower"), [(task(), FOLLOWER), (rocker_task(), ROCKER), (flat_task(), Follower("flat", 0.05))]
)
def test_stored_and_restored(given, follower):
    found = solve_forces(given, follower)
    again = from_record(CamForces, to_record(found))
    assert to_record(again).scalars == to_record(found).scalars
    for name, array in to_record(found).arrays.items():
        assert np.array_equal(to_record(again).arrays[name], array), name
    assert again.extreme("R") == found.extreme("R")


@pytest.mark.parametrize("scale", [1e-6, 1.0, 50.0])
def test_sizes_scale_the_forces(scale):
    """Lengths and spring in proportion: forces grow with the length, angles stay."""
    one = solve_forces(task(), FOLLOWER)
    follower = replace(FOLLOWER, start=0.05 * scale, offset=0.005 * scale, roller=0.008 * scale)
    other = solve_forces(task(stroke=0.02 * scale, guide=Guide(top=0.125 * scale)), follower)
    assert other.contact == pytest.approx(scale * one.contact, rel=1e-9)
    assert other.theta == pytest.approx(one.theta, abs=1e-12)
    assert other.spring.stiffness == pytest.approx(one.spring.stiffness, rel=1e-9)


def test_a_short_phase_and_high_speed():
    given = replace(task(speed=2000.0), program=program(0.001, "const", "modified_sine", (5, 0, 7)))
    found = solve_forces(given, Follower("translating", 0.04, 0.0, 0.004))
    assert found.verdict == "ok"
    assert found.work.error < 1e-12


def test_nothing_acts():
    """No mass, no spring, no force: no reactions, and nothing that could not be stored."""
    found = solve_forces(task(mass=0.0, spring=Spring("none")), FOLLOWER)
    assert not found.contact.any()
    assert found.lost == ((0.0, pytest.approx(2 * pi)),)
    assert found.work.error == 0
    to_record(found)


def test_friction_grows_with_the_exact_factor_over_the_whole_turn():
    """R (cos(theta) - mu) = -P_c on the rise, with a plus on the return, none in dwells; f -> 0 is smooth."""
    frictionless = solve_forces(task(friction=0.0), FOLLOWER)
    gaps = []
    for f in (1e-2, 1e-4, 1e-6):
        found = solve_forces(task(friction=f), FOLLOWER)
        gaps.append(np.max(np.abs(found.contact - frictionless.contact)) / f)
    assert gaps[1] == pytest.approx(gaps[2], rel=1e-3)
    dwell = np.flatnonzero(found.positions.phi > radians(195))
    assert np.array_equal(found.contact[dwell], frictionless.contact[dwell])


def test_crossings_are_those_of_the_function():
    on = smooth_panels(task(), task().loads)
    values = np.sin(3 * on.x + 0.4)
    expected = (np.arange(1, 7) * pi - 0.4) / 3
    assert np.sort(crossings(on, values)) == pytest.approx(expected, abs=1e-12)


def test_extremes_and_work_against_scipy():
    """R of the rise by its formula alone: its largest value by a bounded search, the torque's work by quadrature."""
    from scipy.integrate import quad
    from scipy.optimize import minimize_scalar

    found = solve_forces(task(), FOLLOWER)
    c, preload, f, length, phase = found.spring.stiffness, found.spring.preload, 0.1, 0.047, radians(80)

    def contact(phi):
        s, s1, s2 = 0.01 * (1 - np.cos(pi * phi / phase)), np.sin(pi * phi / phase), np.cos(pi * phi / phase)
        s1, s2 = 0.01 * pi / phase * s1, 0.01 * (pi / phase) ** 2 * s2
        theta = np.arctan((s1 + 0.005) / (0.05 + s))
        mu = f * abs(np.sin(theta)) * (1 + 2 * (0.078 - 0.05 - s) / length)
        force = (2000 * s2 + preload + c * s) / (np.cos(theta) - mu)
        return force, force * np.cos(theta) * s1

    best = minimize_scalar(lambda x: -contact(x)[0], bounds=(0, phase / 2), method="bounded", options={"xatol": 1e-12})
    assert found.extreme("R").largest == pytest.approx(-best.fun, rel=1e-13)
    assert found.extreme("R").largest_phi == pytest.approx(best.x, abs=1e-7)
    given, _ = quad(lambda x: contact(x)[1], 0, phase, epsabs=1e-14, epsrel=1e-13)
    assert found.work.given == pytest.approx(given, rel=1e-12)


def test_guide_and_friction_of_a_law_that_overshoots():
    """The guide clears the top of the overshoot; friction turns with the motion, so that the energy balance closes."""
    loads = Loads(10.0, 0.2, spring=Spring("given", stiffness=5e3, preload=100.0), friction=0.2)
    given = replace(task_of(overshooting(0.02), loads=loads), guide=Guide(length=0.06, gap=0.002))
    found = solve_forces(given, Follower("translating", 0.05, 0.0, 0.008))
    assert found.guide.lower == pytest.approx(0.05 + 0.02 * 1.11475 + 0.008 + 0.002, rel=1e-12)
    assert np.min(found.protrusion) > 0.002
    assert found.work.error < 1e-12
    assert found.work.friction > 0
    turned = np.degrees(found.positions.phi)
    back = (turned > 63.5) & (turned < 89.5)
    assert np.all(np.abs(found.driving[back]) < np.abs(found.torque[back]))


@pytest.mark.parametrize("closure", ["force", "groove"])
def test_a_cam_under_weight_alone(closure):
    spring = Spring("none") if closure == "groove" else Spring()
    found = solve_forces(task(closure=closure, speed=4.0, gravity=-9.81, spring=spring), FOLLOWER)
    assert (found.spring.stiffness, found.spring.lifting, found.verdict) == (0.0, None, "ok")
    assert (found.work.force, found.reversals) == (0.0, ())


def test_energies_of_rounding_are_none():
    work = solve_forces(task(friction=0.0), FOLLOWER).work
    assert (work.driving, work.friction, work.mean, work.power) == (0.0, 0.0, 0.0, 0.0)
    assert work.given > 0
    assert 0 < work.error < 1e-13 or work.error == 0


def test_a_flat_face_jams_by_its_couple():
    """1 - 2 f S'/l: S'max = 2 h/phi_r of the sine law."""
    slope = 2 * 0.012 / radians(80)
    with pytest.raises(SingularityError, match=r"2 f S'/l = 1\.1") as caught:
        solve_forces(flat_task(friction=1.1 * 0.03 / (2 * slope)), Follower("flat", 0.05))
    assert "theta" not in str(caught.value)
    found = solve_forces(flat_task(friction=0.9 * 0.03 / (2 * slope)), Follower("flat", 0.05))
    assert found.reserve.eaten == pytest.approx(0.9, rel=1e-9)
    facts = {fact.label: fact.text for fact in forces_document(found, "F").facts}
    assert "2 f S'/l = 0.9, limit 1" in facts["jamming"]
