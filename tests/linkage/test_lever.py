"""Zhukovsky's lever and the equations of every link: worked cases, closed forms, random mechanisms under any loads."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from loaded import DEG, anything, press, ready, statics
from random_mechanisms import KINDS
from ready import LINKAGES
from sparing import sparing

import tmmcalc
from linkage.forces.loadings import random_loading
from linkage.forces.worked import CASES
from linkage.test_properties import regular_scenes
from tmmcalc.linkage.facts.bodies import bodies_document
from tmmcalc.linkage.facts.lever import lever_document
from tmmcalc.linkage.forces.kinetostatics import Statics, compile_statics
from tmmcalc.linkage.forces.solve import solve_forces
from tmmcalc.linkage.freebody import FreeBody, Solved, link_bodies
from tmmcalc.linkage.kinematics import solve_kinematics
from tmmcalc.linkage.lever import REACH, Lever, levers, velocity_scale
from tmmcalc.linkage.loading import GearDrive, Load, Loading
from tmmcalc.linkage.loadlaws.constant import Constant
from tmmcalc.linkage.loads.scene import compile_scene
from tmmcalc.linkage.moments import LinkEquilibrium, equilibria
from tmmcalc.linkage.results import Kinematics

FRICTION = CASES["dyn-press-friction"]["expected"]


def lever(scene: Statics, kinematics: Kinematics, theta: float, side: float, mu: float) -> Lever:
    """That of one position."""
    return levers(scene, kinematics, np.array([theta]), np.array([side]), mu)[0]


def links_at(scene: Statics, theta: float) -> tuple[LinkEquilibrium, ...]:
    return equilibria(scene, np.array([theta]), np.array([1.0]))[0]


def balanced(found: Lever, kinematics: Kinematics) -> bool:
    """Whether the drives agree to rounding of what the moments are made from."""
    size = sum(abs(force.moment) for force in found.forces) * found.mu / abs(kinematics.speed)
    return abs(found.difference) <= 1e-9 * max(size, abs(found.kinetostatic))


@pytest.mark.parametrize("i", [1, 2, 4, 5, 7, 8, 10, 11])
def test_the_press_with_friction(i: int) -> None:
    """dyn-press-friction: the balancing moment of the textbook, without any ideal reaction."""
    mechanism, loading, kinematics = press()
    found = lever(statics(mechanism, loading), kinematics, i * 30 * DEG, 1.0, 0.002)
    assert found.drive == pytest.approx(FRICTION["M_bal"][i], rel=1e-5)
    assert sum(force.moment for force in found.forces) == pytest.approx(found.moment)
    assert found.drive == pytest.approx(-found.moment * 0.002 / kinematics.speed)


def test_both_limits_where_friction_jumps() -> None:
    mechanism, loading, kinematics = press()
    before, after = (lever(statics(mechanism, loading), kinematics, 270 * DEG, side, 0.002) for side in (-1.0, 1.0))
    assert before.drive == pytest.approx(FRICTION["M_bal"][9], rel=1e-5)
    assert after.drive != pytest.approx(before.drive, rel=1e-4)
    assert balanced(before, kinematics)
    assert balanced(after, kinematics)


def test_a_force_on_a_slider_has_the_velocity_as_its_arm() -> None:
    """A massless crank-slider under Q: one force on the lever, its arm the slider's velocity in mm of the plan."""
    mechanism, _, kinematics = press(friction=False)
    found = lever(
        statics(mechanism, Loading(loads=(Load("Q", 3, "force", Constant(-200.0)),))), kinematics, 1.0, 1.0, 0.01
    )
    (force,) = found.forces
    phi2 = np.arcsin(-0.0375 * np.sin(1.0) / 0.168)
    velocity = -0.0375 * 5.0 * np.sin(1.0 - phi2) / np.cos(phi2)
    assert (force.name, force.force, force.direction) == ("Q", 200.0, 180.0)
    assert force.arm == pytest.approx(-velocity / 0.01)
    assert complex(force.x, force.y) == pytest.approx(-1j * velocity / 0.01)
    assert found.drive == pytest.approx(200.0 * velocity / 5.0)


def test_a_couple_is_a_pair_of_forces_on_two_vertices() -> None:
    mechanism = ready("four-bar")
    kinematics = solve_kinematics(mechanism)
    found = lever(
        statics(mechanism, Loading(loads=(Load("T", 3, "moment", Constant(-40.0)),))), kinematics, 0.7, 1.0, 0.1
    )
    one, other = found.forces
    assert {one.point, other.point} == {"B", "C"}
    assert one.force == pytest.approx(other.force)
    assert abs(one.direction - other.direction) == pytest.approx(180)
    omega = statics(mechanism, Loading()).scene.place(np.array([0.7])).configuration.motions[3].omega[0]
    assert found.drive == pytest.approx(40.0 * omega)


def test_a_gear_on_the_crank() -> None:
    mechanism, loading, kinematics = press(friction=False)
    geared = replace(loading, drive=GearDrive(0.12, 20 * DEG, -90 * DEG))
    found = lever(statics(mechanism, geared), kinematics, 300 * DEG, 1.0, 0.002)
    assert found.drive == pytest.approx(CASES["dyn-press-ideal"]["expected"]["M_bal"][10], rel=1e-4)
    assert balanced(found, kinematics)


@sparing("name", LINKAGES, every=6)
def test_ready_mechanisms(name: str) -> None:
    """Higher groups, driven sliders and driven lengths too, with friction, springs, dampers, moments."""
    mechanism = ready(name)
    scene, kinematics = statics(mechanism, anything(mechanism)), solve_kinematics(mechanism)
    for theta in np.array([0.0, 0.31, 0.77]) * scene.scene.travel.period:
        assert balanced(lever(scene, kinematics, float(theta), 1.0, 0.1), kinematics)
        in_equilibrium(scene, float(theta))


def in_equilibrium(scene: Statics, theta: float) -> None:
    found = links_at(scene, theta)
    assert [each.link for each in found] == [link.id for link in scene.scene.chain.mechanism.links]
    for each in found:
        forces = max((term.force or 0.0 for term in each.terms), default=0.0)
        moments = sum(abs(term.moment) for term in each.terms) + forces
        assert each.force_left < 1e-10 * forces + 1e-12
        assert abs(each.moment_left) < 1e-10 * moments + 1e-12


@pytest.mark.parametrize("kind", KINDS)
def test_random_mechanisms_under_random_loads(kind: str) -> None:
    compared = 0
    for seed, mechanism, kinematics in regular_scenes((kind, "RRP"), range(5)):
        loading = random_loading(np.random.default_rng(seed), mechanism, 0.1 * (seed % 2))
        scene = compile_statics(compile_scene(mechanism, loading, kinematics))
        try:
            one = lever(scene, kinematics, 0.4 * scene.scene.travel.period, 1.0, 0.1)
        except tmmcalc.NoSolutionError:
            continue
        if np.isfinite(one.drive):
            assert balanced(one, kinematics), seed
            compared += 1
    assert compared >= 2


def test_a_fault_of_the_forces_unbalances_the_lever(monkeypatch: pytest.MonkeyPatch) -> None:
    """Inertia of the rod left out on the lever alone: the drives differ by its part."""
    mechanism, loading, kinematics = press(friction=False)
    scene = statics(mechanism, loading)
    whole = lever(scene, kinematics, 1.0, 1.0, 0.002)

    def without(found: Solved, row: int) -> tuple[FreeBody, ...]:
        return tuple(
            replace(body, forces=tuple(f for f in body.forces if f"{f.letter}{f.index}" != "P2"))
            for body in link_bodies(found, row)
        )

    monkeypatch.setattr("tmmcalc.linkage.lever.link_bodies", without)
    broken = lever(scene, kinematics, 1.0, 1.0, 0.002)
    (left_out,) = [force for force in whole.forces if force.name == "P2"]
    assert broken.difference == pytest.approx(left_out.moment * 0.002 / kinematics.speed)
    assert not balanced(broken, kinematics)


def test_the_moment_equation_of_the_rod_gives_the_tangential_part() -> None:
    """dyn-press-friction: about B the reaction in A has the moment -R21T l2, and the terms are those of (D.3.5)."""
    mechanism, loading, _ = press()
    rod = links_at(statics(mechanism, loading), 60 * DEG)[1]
    terms = {term.name: term.moment for term in rod.terms}
    assert rod.about == "B"
    assert terms["R21"] == pytest.approx(-FRICTION["R21T"][2] * 0.168, rel=1e-5)
    assert terms["M21"] == pytest.approx(FRICTION["M21"][2], rel=1e-5)
    assert terms["M23"] == pytest.approx(FRICTION["M23"][2], rel=1e-5)
    assert terms["R23"] == pytest.approx(0, abs=1e-12)


def test_documents_tell_every_position_that_is_asked_for() -> None:
    mechanism, loading, kinematics = press()
    scene, result = statics(mechanism, loading), solve_forces(mechanism, loading, kinematics)
    rows = [result.labels.index(label) for label in ("9-", "9", "12")]
    told = lever_document(scene, kinematics, result, "", rows)
    assert told.table is not None
    assert dict.fromkeys(told.table.columns[0]) == dict.fromkeys(("9-", "9", "12"))
    balances = [fact.values for fact in told.facts if fact.label.startswith("balance")]
    for label, row, values in zip(("9-", "9", "12"), rows, balances, strict=True):
        found = values[f"balance_in_{label}"]
        assert found["M_drive[N*m]"] == pytest.approx(result.drive[row])
        assert found["M_drive_lever[N*m]"] == pytest.approx(result.drive[row])
    mu = told.facts[1].values["mu_v[m/s/mm]"]
    assert mu == velocity_scale(scene, kinematics, result.theta[rows])
    reach = max(np.hypot(x, y) for x, y in zip(told.table.columns[7], told.table.columns[8], strict=True))
    assert REACH / 5 < reach <= REACH * 1.01  # the loads of the press act at its pins, or between them
    links = bodies_document(scene, result, "", rows[:1])
    assert [fact.label for fact in links.facts] == [
        f"link {k} about {at}, 9-" for k, at in ((1, "O"), (2, "B"), (3, "B"))
    ]
