"""What the chapter is told from: the motion at the shown rows, its quantities by their names in formulas.

Points of the arm's vertical plane have the coordinates <r>, <z>: r and z with a turning base, else x and y.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from typing import NamedTuple

import numpy as np

from tmmcalc.core.records import record
from tmmcalc.manipulators.arms import meridian, polar
from tmmcalc.manipulators.results import Manipulator
from tmmcalc.manipulators.routes import Leg, Piece, legs_of
from tmmcalc.manipulators.task import Arm, Drive, Joint, ManipulatorTask, PathTask
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Lexicon, Line, Place
from tmmcalc.report.optimal import quantities
from tmmcalc.report.telling import lines, named

AXES = "xyz"


class At(NamedTuple):
    """A row of the table: the leg of the path and its piece that the gripper is on."""

    row: int
    leg: int
    piece: int


@record
class Told:
    """The task, its result, and the rows that are shown."""

    task: ManipulatorTask
    result: Manipulator
    rows: tuple[int, ...]

    @property
    def arm(self) -> Arm:
        """The arm."""
        return self.task.arm

    @property
    def axes(self) -> str:
        """Names of the coordinates of the gripper."""
        return AXES[: self.arm.dimensions]

    @property
    def words(self) -> dict[str, str]:
        """The coordinates of the arm's plane."""
        return {"r": "r", "z": "z"} if self.arm.spatial else {"r": "x", "z": "y"}

    @cached_property
    def legs(self) -> tuple[Leg, ...]:
        """The legs of the path; none in the direct problem."""
        asked = self.task.motion
        return legs_of(asked.route) if isinstance(asked, PathTask) else ()

    @cached_property
    def sites(self) -> tuple[At, ...]:
        """The shown rows with the pieces of the path."""
        return tuple(self.site(row) for row in self.rows)

    def site(self, row: int) -> At:
        """Where on the path the gripper is at a row."""
        t, side = self.result.t[row], self.result.side[row]
        near = 1e-9 * self.result.duration

        def last(begins: Sequence[float]) -> int:
            return max([k for k, begin in enumerate(begins) if begin < t + (near if side > 0 else -near)], default=0)

        leg = last([each.begin for each in self.result.legs])
        return At(row, leg, last([each.begin for each in self.result.legs[leg].pieces]))

    def piece(self, at: At) -> Piece:
        """The piece of the path at a row."""
        return self.legs[at.leg][at.piece]

    def named(self, row: int) -> str:
        """A row as it stands before a line."""
        return tr("in row {label}", label=self.result.labels[row])

    def lines(
        self, texts: Sequence[str], rows: Sequence[int], more: Mapping[int, Lexicon], words: Mapping[str, str] | None
    ) -> Iterator[Line]:
        """Formulas worked out at rows; ``more`` is beside gripper and joints what each has."""
        places = [Place(self.named(row), {**self.lexicon(row), **more.get(row, {})}) for row in rows]
        if places:
            yield from lines(texts, places, {**self.words, **(words or {})})

    def lexicon(self, row: int) -> Lexicon:
        """Gripper, joints and elbow at a row, with the sizes of the arm."""
        result, arm = self.result, self.arm
        found = {
            "t": Given(float(result.t[row]), "s", tr("time")),
            "H": Given(arm.height, "m", tr("height of the shoulder")),
        }
        said = (tr("coordinates of the gripper"), tr("velocity of the gripper"), tr("acceleration of the gripper"))
        for order, (letter, unit) in enumerate((("", "m"), ("v_", "m/s"), ("a_", "m/s^2"))):
            for axis, value in zip(self.axes, result.gripper[order, :, row].tolist(), strict=True):
                found[f"{letter}{axis}"] = Given(value, unit, said[order])
        found |= self._in_plane(row)
        for k, joint in enumerate(arm.joints):
            found |= joint_quantities(arm, joint, result.q[:, k, row].tolist())
        if result.elbow is not None and result.elbow_angle is not None:
            found |= {
                "l_a": Given(arm.upper, "m", tr("length of the upper arm")),
                "l_b": Given(arm.forearm, "m", tr("length of the forearm")),
                "gamma": Given(math.degrees(result.elbow_angle[0, row]), "deg", elbow_words()),
            }
            for axis, value in zip(self.axes, result.elbow[:, row].tolist(), strict=True):
                found[f"{axis}_E"] = Given(value, "m", tr("coordinates of the elbow"))
        return named(found)

    def _in_plane(self, row: int) -> dict[str, Given]:
        """The distance of the gripper from the axis of the base, and from the shoulder."""
        w = meridian(self.arm, self.result.gripper[:, :, row : row + 1])
        found = {}
        if self.arm.spatial:
            said = (
                tr("distance of the gripper from the axis of the base"),
                tr("radial velocity of the gripper"),
                tr("second derivative of the distance by the time"),
            )
            for name, unit, value, what in zip(("r", "v_r", "a_r"), ("m", "m/s", "m/s^2"), w[:, 0], said, strict=True):
                found[name] = Given(float(value.real), unit, what)
        if self.arm.kind == "angular":
            with np.errstate(divide="ignore", invalid="ignore"):
                far = polar(w)[0, 0]
            found["l"] = Given(float(far[0]), "m", tr("distance of the gripper from the shoulder"))
        return found


def elbow_words() -> str:
    """What the angle of the elbow is."""
    return tr("angle of the elbow, from the upper arm to the forearm")


def joint_words(arm: Arm, joint: Joint) -> tuple[str, str, str]:
    """What a joint coordinate and its derivatives are."""
    single = (tr("angle of the arm with the horizontal"), tr("angular velocity of the arm"))
    upper = (tr("angle of the upper arm with the horizontal"), tr("angular velocity of the upper arm"))
    return {
        "psi": (
            tr("rotation angle of the base"),
            tr("angular velocity of the base"),
            tr("angular acceleration of the base"),
        ),
        "phi_2": (*upper, tr("angular acceleration of the upper arm"))
        if arm.kind == "angular"
        else (*single, tr("angular acceleration of the arm")),
        "phi_3": (
            tr("angle of the forearm with the horizontal"),
            tr("angular velocity of the forearm"),
            tr("angular acceleration of the forearm"),
        ),
        "l_3": (
            tr("extension of the arm"),
            tr("velocity of the extension"),
            tr("acceleration of the extension"),
        ),
        "h": (
            tr("height of the arm above the shoulder"),
            tr("velocity of the lift"),
            tr("acceleration of the lift"),
        ),
        "r": (tr("reach of the arm"), tr("velocity of the reach"), tr("acceleration of the reach")),
        "elbow": (elbow_words(), "", ""),
    }[joint.name]


def joint_quantities(arm: Arm, joint: Joint, states: Sequence[float]) -> Lexicon:
    """A joint coordinate with its derivatives."""
    units = ("deg", "rad/s", "rad/s^2") if joint.turns else ("m", "m/s", "m/s^2")
    values = (math.degrees(states[0]) if joint.turns else states[0], *states[1:])
    return {
        name: Given(value, unit, said)
        for name, value, unit, said in zip(joint[:3], values, units, joint_words(arm, joint), strict=True)
    }


def letter(joint: Joint) -> str:
    """A joint coordinate by its letter."""
    return "gamma" if joint.name == "elbow" else joint.name


def gripper_law(drive: Drive) -> str:
    """The law by which the gripper goes along its path, in words."""
    if drive.duration is None:
        return tr(
            "The gripper moves from rest to rest in the shortest time that the limits allow: with the largest "
            "tangential acceleration, at constant speed, with the largest deceleration."
        )
    return tr(
        "The gripper moves from rest to rest in the given time: with the largest tangential acceleration, at constant "
        "speed, with the largest deceleration."
    )


def law_of(told: Told, leg: int) -> Lexicon:
    """The time-optimal law of a leg, with what its speed is held to."""
    facts, asked = told.result.legs[leg], told.task.motion
    assert isinstance(asked, PathTask)
    drive = asked.drive
    found = quantities(
        facts.law,
        "m",
        travel=tr("length of the path"),
        peak=tr("largest speed of the gripper that is reached"),
        allowed=tr("allowed tangential acceleration of the gripper"),
    )
    limits = {
        "v_m": (drive.speed, "m/s", tr("allowed speed of the gripper")),
        "a_n^{lim}": (drive.normal, "m/s^2", tr("allowed normal acceleration of the gripper")),
        "a_Σ^{lim}": (drive.total, "m/s^2", tr("allowed total acceleration of the gripper")),
        "v_R": (facts.speed_limit, "m/s", tr("speed that the accelerations on the arcs allow")),
        "R_{min}": (
            min((piece.radius for piece in facts.pieces if piece.radius is not None), default=None),
            "m",
            tr("least radius of the arcs"),
        ),
    }
    found |= {key: Given(value, unit, said) for key, (value, unit, said) in limits.items() if value is not None}
    return named(found)
