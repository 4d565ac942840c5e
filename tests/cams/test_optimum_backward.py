"""Laws that turn back: in the optimum friction has the sense of the motion, up to the angle where it turns."""

from dataclasses import replace
from math import radians

import numpy as np
import pytest

from cams.optimum_scene import roller_task
from cams.turns import overshooting
from tmmcalc.cams.follower import Follower
from tmmcalc.cams.forces.solve import solve_forces
from tmmcalc.cams.optimum.extremes import extremes
from tmmcalc.cams.optimum.scene import scene_of
from tmmcalc.cams.task import AngleLimits, Spring

TASK = replace(
    roller_task(0.25, spring=Spring("given", stiffness=9500.0, preload=200.0)),
    program=overshooting(0.02),
    limits=AngleLimits(radians(30), None, convex=0.003),
)
START, ROLLER, TOP = 0.06, 0.008, 0.15


def by_hand(task, offset, phi):
    """R and |N1| at many angles, with the sign of S' as the sense of the friction."""
    loads, spring = task.loads, task.loads.spring
    y, slope, second = task.program.at(phi)[:3]
    pressed = loads.mass * loads.speed**2 * second + spring.preload + spring.stiffness * y
    top = START + task.program.highest + ROLLER
    length, across = TOP - top, slope + offset
    overhang = top - START - y
    speed = np.hypot(START + y, across)
    rubbed = loads.friction * np.abs(across) * (1 + 2 * overhang / length)
    contact = pressed * speed / (START + y - np.where(slope == 0, 0.0, np.sign(slope)) * rubbed)
    return contact, np.abs(contact * across / speed * (1 + overhang / length))


@pytest.mark.parametrize("offset", [0.0, 0.006, -0.006])
def test_extremes_take_the_sense_of_the_motion(offset):
    scene = scene_of(TASK, Follower("translating", START, offset))
    rows = np.flatnonzero(np.abs(scene.motion[1]) > 1e-9)
    assert np.array_equal(scene.sense[rows], np.sign(scene.motion[1][rows]))
    each = scene.by_panel(scene.sense)
    assert np.array_equal(each.min(axis=1), each.max(axis=1))  # the friction turns between panels
    found = extremes(scene, np.array([START]), np.array([ROLLER]), np.array([TOP]))
    edges = np.concatenate((TASK.program.edges, [part.begin for part in TASK.backward]))
    edges = np.concatenate((edges, [part.end for part in TASK.backward]))
    phi = np.concatenate((np.linspace(0, 2 * np.pi, 200001), edges + 1e-9, edges - 1e-9))
    contact, edge = by_hand(TASK, offset, phi[(phi > 0) & (phi < 2 * np.pi)])
    assert found.works[0]
    assert found.contact[0] == pytest.approx(contact.max(), rel=1e-7)
    assert found.edge[0] == pytest.approx(edge.max(), rel=1e-7)
    task = replace(TASK, guide=replace(TASK.guide, top=TOP))
    forces = solve_forces(task, Follower("translating", START, offset, roller=ROLLER))
    largest = {each.name: each.largest for each in forces.extremes}
    assert found.contact[0] == pytest.approx(largest["R"], rel=1e-9)
