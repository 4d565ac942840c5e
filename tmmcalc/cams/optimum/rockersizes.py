"""The constraints of a cam under a rocker as margins over its sizes l2, R0, r2 and l0: 0 at the limit, negative beyond.

    2  the roller rolls without slip             6  shaft: r2 <= R0 - r1*
    3  no undercut: r2 <= rho2 - r_m             9  contact stress
    4  concave parts: r2 >= r_i - rho1          10  pressure angle
    5  roller on its pin: r2 >= r2*             11  room at the pivot: |OC|_max - r2 <= l0 - r_A

A rocker has no guide: in place of 7 and 8 of table 5.5 stand the limits of its pressure angle and the pivot that the
cam has to pass. With psi of the triangle of l0, l2, R0, v the speed of the pitch curve and M = -M_c,

    v^2 = (l2 (1 - delta psi') - l0 cos psi)^2 + (l0 sin psi)^2,   R = M/(l2 cos(theta) - sense f r_A)

so that R, unlike that of a stem, does not depend on r2.
"""

from __future__ import annotations

from math import pi
from typing import NamedTuple

import numpy as np

from tmmcalc.cams.follower import Follower
from tmmcalc.cams.forces.formulas import Mask
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.optimum.checks import checks, closure
from tmmcalc.cams.optimum.extremes import SIGNS, Extremes, blocks
from tmmcalc.cams.optimum.margins import NUMBERS as OF_STEM
from tmmcalc.cams.optimum.margins import Judged, judged_by
from tmmcalc.cams.optimum.peaks import largest
from tmmcalc.cams.optimum.results import NAMES, Check, Choice
from tmmcalc.cams.optimum.scene import Phases, Scene, scene_of
from tmmcalc.cams.pivot import highest
from tmmcalc.cams.strength.formulas import BAD, rocker_rolling, unused
from tmmcalc.cams.task import CamTask
from tmmcalc.core.records import record

NUMBERS = (2, 3, 4, 5, 6, 9, 10, 11)  # of the constraints, in the order of the rows
SHARED = [OF_STEM.index(number) for number in NUMBERS[:6]]
ANGLE, PIVOT = 10, 11
COUNT = 11  # functions over the turn


@record
class RockerScene:
    """A scene with what a rocker has besides; its ``rows``, those of a stem, are not used."""

    scene: Scene
    rising: Mask  # (M,) nodes of the rise
    returning: Mask  # (M,) nodes of the return
    square: Values  # (M,) square of omega over its mean
    gaining: Values | None  # (M,) eps over the square of the mean speed; None: the cam turns evenly
    top: float  # highest dpsi of the turn [rad]
    pivot: float  # r_A [m]
    friction: float  # f r_A [m] in the pivot


class Sizes(NamedTuple):
    """Sizes (B,) [m], in the order of the rows of an array (4, B)."""

    rocker: Values  # l2
    base: Values  # R0
    roller: Values  # r2
    centres: Values  # l0


class RockerJudged(NamedTuple):
    """Margins (8, B) of the constraints NUMBERS with what is behind them."""

    margin: Values
    shared: Judged  # of the constraints that a stem has too
    theta: Values  # (2, B) largest |theta| on the rise and on the return [rad]
    reach: Values  # (B,) largest radius of the cam [m]


def rocker_scene(task: CamTask, follower: Follower, phases: Phases = "turn", denser: int = 1) -> RockerScene:
    """The scene of a task with a rocker; raises as `scene_of` does."""
    scene = scene_of(task, follower, phases, denser)
    program, nodes = task.program, scene.by_panel(scene.phi).shape[1]
    middle = np.mean(scene.by_panel(scene.phi), axis=1)
    kinds = np.array([phase.kind for phase in program.phases])[program.places[0][program.piece(middle)]]
    square, gaining = np.ones_like(scene.phi), None
    if task.turning is not None:
        omega, eps = task.turning.at(scene.phi)
        square, gaining = (omega / scene.speed) ** 2, eps / scene.speed**2
    loads = task.loads
    pivot = 0.0 if loads is None else loads.pivot_radius
    return RockerScene(
        scene=scene,
        rising=np.tile(kinds == "rise", nodes),
        returning=np.tile(kinds == "return", nodes),
        square=square,
        gaining=gaining,
        top=highest(program)[0],
        pivot=pivot,
        friction=0.0 if loads is None else loads.pivot_friction * pivot,
    )


def start_angle(sizes: Sizes) -> tuple[Values, Mask]:
    """psi0 (B,) [rad] of the triangle l0, l2, R0, and where there is one."""
    cosine = (sizes.centres**2 + sizes.rocker**2 - sizes.base**2) / (2 * sizes.centres * sizes.rocker)
    closed = np.abs(cosine) < 1
    return np.arccos(np.where(closed, cosine, 0.0)), closed


class Turn(NamedTuple):
    """What the constraints are made of at the nodes, each (B, M)."""

    theta: Values  # [rad]
    useful: Values  # M/R [m]
    kappa: Values  # of the pitch curve [1/m]
    run: Values  # A [m]
    works: Mask  # (B,) the rocker stays off the line of centres and jams nowhere


def turn_of(of: RockerScene, sizes: Sizes) -> Turn:
    """The turn with these sizes; where it does not work its values are finite, and mean nothing."""
    scene = of.scene
    l2, l0, (start, closed) = sizes.rocker[:, None], sizes.centres[:, None], start_angle(sizes)
    psi = start[:, None] + scene.motion[0]
    cosine, sine = np.cos(psi), np.sin(psi)
    d = scene.follower.assembly
    across, along = l2 * (1 - d * scene.motion[1]) - l0 * cosine, l0 * sine
    speed = np.hypot(across, along)
    pressed = l2 * np.abs(along) / speed
    useful = pressed - scene.sense * of.friction
    works = closed & np.all(along > 0, axis=1) & np.all(useful > 0, axis=1)
    useful = np.where(useful > 0, useful, np.maximum(pressed, 1e-12))
    kappa, run = rocker_rolling(d, scene.motion, (cosine, sine), l0, l2)
    run = run * of.square
    if of.gaining is not None:
        run += of.gaining * (speed - sizes.roller[:, None])
    return Turn(np.arctan2(across, along), useful, kappa, run, works)


def judge_rocker(of: RockerScene, sizes: Sizes, apart: bool = False) -> RockerJudged:
    """Margins and values at sizes (B,); every largest value is that over all examined phases, to rounding.

    ``apart``: on each of the K panels of the turn by itself, (B K,). So they are smooth functions of the sizes, which
    the largest of several is not.
    """
    scene, count = of.scene, of.scene.panels if apart else 1
    cut = blocks(scene, len(sizes.roller))
    parts = [_extremes(of, Sizes(*(size[part] for size in sizes)), apart) for part in cut]
    on = Extremes(*(np.concatenate(each, axis=-1) for each in zip(*(part for part, _ in parts), strict=True)))
    theta = np.concatenate([each for _, each in parts], axis=1)
    sizes = Sizes(*(np.repeat(size, count) for size in sizes))
    shared = judged_by(scene, on, sizes.roller, sizes.base, sizes.base)
    limits = scene.limits
    lean = theta[0] / limits.rise
    if limits.back is not None:
        lean = np.maximum(lean, theta[1] / limits.back)
    start, closed = start_angle(sizes)
    l0, l2 = sizes.centres, sizes.rocker
    reach = np.sqrt(l0 * l0 + l2 * l2 - 2 * l0 * l2 * np.cos(start + of.top)) - sizes.roller
    room = l0 - of.pivot
    passing = np.where(room > 0, unused(reach, np.where(room > 0, room, 1.0)), BAD)
    margin = np.concatenate((shared.margin[SHARED], np.stack((np.where(on.works, 1 - lean, BAD), passing))))
    margin[:, ~closed] = BAD
    return RockerJudged(margin, shared, theta, reach)


def _extremes(of: RockerScene, sizes: Sizes, apart: bool) -> tuple[Extremes, Values]:
    """The extremes as of a stem, and the largest |theta| of rise and return (2, B); ``apart`` (B K,) and (2, B K)."""
    scene, turn = of.scene, turn_of(of, sizes)
    inverse = turn.useful * scene.rows.inverse  # 1/R
    growth = turn.run * inverse
    bent = turn.kappa * sizes.roller[:, None]
    span = (scene.requirements.span or 1.0) / 4
    square = inverse * inverse
    functions = np.stack(
        (
            -turn.kappa,
            turn.kappa,
            -growth,
            growth,
            -inverse,
            -square / (span * span + scene.rows.twist * square),
            (bent - 1) * inverse,
            *(np.where(phase, side * turn.theta, -pi) for phase in (of.rising, of.returning) for side in (1, -1)),
        )
    )
    by_panel = scene.by_panel(functions.reshape(COUNT * len(sizes.roller), -1))
    if apart:
        by_panel = by_panel.reshape(-1, 1, by_panel.shape[-1])
    high = largest(by_panel).reshape(COUNT, -1)
    works = np.repeat(turn.works, high.shape[1] // len(turn.works))
    smooth, none = high[6] < 0, np.zeros(high.shape[1])
    contact = 1 / np.abs(high[4])
    found = Extremes(
        works=works & (high[4] < 0),
        smooth=smooth,
        curvature=high[:2] * SIGNS,
        growth=high[2:4] * SIGNS,
        contact=contact,
        edge=none,
        moment=none,
        reduced=1 / np.sqrt(np.abs(high[5])),
        pressed=np.where(smooth, -1 / np.where(smooth, high[6], -1.0), contact),
    )
    return found, np.maximum(high[7::2], high[8::2])


def rocker_choice(of: RockerScene, sizes: tuple[float, float, float, float]) -> Choice:
    """Sizes l2, R0, r2, l0 [m] with all constraints."""
    l2, base, r2, l0 = sizes
    found = judge_rocker(of, Sizes(*(np.array([size]) for size in sizes)))
    shared = [each for each in checks(of.scene, found.shared, 0, base, r2) if each.number in NUMBERS]
    limits = of.scene.limits
    rise, back = (float(value) for value in found.theta[:, 0])
    theta, limit = (rise, limits.rise)
    if limits.back is not None and back / limits.back > rise / limits.rise:
        theta, limit = back, limits.back
    lean, room = (float(margin) for margin in found.margin[-2:, 0])
    own = (
        Check(ANGLE, NAMES[ANGLE], "theta", theta, "<=", limit, "rad", lean),
        Check(PIVOT, NAMES[PIVOT], "r_max", float(found.reach[0]), "<=", l0 - of.pivot, "m", room),
    )
    return Choice(base, r2, l0, l2, (closure(of.scene), *shared, *own))
