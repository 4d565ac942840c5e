"""Checks of a force analysis: equilibrium of every link, and the drive by virtual power (textbook 3.2.8)."""

from __future__ import annotations

import numpy as np

from tmmcalc.core.plane import Real, cross, square
from tmmcalc.linkage.forces.kinetostatics import ForceState, Statics
from tmmcalc.linkage.forces.wrench import NOTHING, Slideway, Wrench, seat_of, sliding
from tmmcalc.linkage.loading import GearDrive
from tmmcalc.linkage.loads.sources import Place
from tmmcalc.linkage.model import FRAME


def residuals(statics: Statics, state: ForceState, place: Place) -> tuple[Real, Real]:
    """Largest residual of force and moment of a link (n,), each against the largest of its kind."""
    n = len(place.theta)
    total = dict(state.given.loads)
    forces, moments = np.zeros(n), np.zeros(n)
    for joint in statics.joints:
        low, high = sorted(joint.links)
        reaction = state.reactions[joint.name]
        wrench = reaction.wrench.about(state.pole - reaction.seat.r)
        np.maximum(forces, square(wrench.force), out=forces)
        np.maximum(moments, np.abs(wrench.moment), out=moments)
        total[high] = total[high].plus(wrench)
        if low != FRAME:
            total[low] = total[low].minus(wrench)
    for k, wrench in _drive_wrenches(statics, state, place):
        total[k] = total[k].plus(wrench)
    force, moment = np.zeros(n), np.zeros(n)
    for wrench in total.values():
        np.maximum(force, square(wrench.force), out=force)
        np.maximum(moment, np.abs(wrench.moment), out=moment)
    return np.sqrt(force / (np.max(forces) or 1.0)), moment / (np.max(moments) or 1.0)


def _drive_wrenches(statics: Statics, state: ForceState, place: Place) -> list[tuple[int, Wrench]]:
    """What the drive does to links, about the pole: to the input link, or to both links of a driven length."""
    chain = statics.scene.chain
    slider, guide = chain.input_joint.links
    if chain.structure.driven is None:
        return [(chain.structure.input_link, _drive_wrench(statics, state, place))]
    seat = seat_of(chain.input_joint, place.configuration)
    assert isinstance(seat, Slideway)
    push = Wrench(state.drive * seat.e, np.zeros(())).about(state.pole - seat.r)
    return [(slider, push), (guide, push.reversed())]


def _drive_wrench(statics: Statics, state: ForceState, place: Place) -> Wrench:
    """What the drive does to the input link, about the pole."""
    chain = statics.scene.chain
    if not chain.turns:
        motion = place.configuration.motions[chain.structure.input_link]
        force = state.drive * motion.v  # unit vector along the positive coordinate
        return Wrench(force, cross(motion.r - state.pole, force))
    drive = statics.scene.loading.drive
    if isinstance(drive, GearDrive) and state.mesh is not None:
        return Wrench(state.mesh, cross(drive.radius * np.exp(1j * drive.pinion), state.mesh))
    return Wrench(NOTHING.force, state.drive)


def virtual_drive(statics: Statics, state: ForceState, place: Place) -> Real:
    """The drive (n,) from virtual power alone, without any reaction but the friction (textbook 3.31)."""
    configuration = place.configuration
    total = np.zeros(len(place.theta))
    for action, factor in state.given.actions:
        total += factor * action.power(configuration)
    for joint in statics.rubbing:
        total += state.reactions[joint.name].friction * sliding(joint, configuration)[0]
    return -total


def friction_power(statics: Statics, state: ForceState, place: Place) -> dict[str, Real]:
    """Power (n,) per unit of input speed lost in every rubbing pair: not positive along the motion."""
    return {
        joint.name: state.reactions[joint.name].friction * sliding(joint, place.configuration)[0]
        for joint in statics.rubbing
    }
