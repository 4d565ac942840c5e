"""The documents of the manipulator stage: path and phases, joints, singular places, limits, obstacles, the table."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from tmmcalc.core.quantity import Quantity, keyed
from tmmcalc.manipulators.columns import manipulator_columns
from tmmcalc.manipulators.results import LegFacts, Manipulator, PieceFacts
from tmmcalc.report.document import Document, Fact, angles_in_degrees
from tmmcalc.report.numbers import angle, number
from tmmcalc.report.positions import with_positions
from tmmcalc.report.timelaw import extreme_lines, extreme_values, law_facts

ARMS = {
    "spherical": "spherical: elevation phi_2, extension l_3",
    "cylindrical": "cylindrical: height h, reach r",
    "angular": "angular: upper arm phi_2, forearm phi_3",
}
PROBLEM = Quantity("problem", "problem of the kinematics")
ELBOW = Quantity("elbow", "side of the elbow")
GRIPPER = (  # whose extremes are told
    Quantity("speed[m/s]", "speed of the gripper"),
    Quantity("acceleration[m/s^2]", "acceleration of the gripper"),
    Quantity("a_tangential[m/s^2]", "tangential acceleration of the gripper"),
    Quantity("a_normal[m/s^2]", "normal acceleration of the gripper"),
)
ELBOW_RATES = (
    Quantity("omega_elbow[rad/s]", "angular velocity at the elbow"),
    Quantity("eps_elbow[rad/s^2]", "angular acceleration at the elbow"),
)


def summary(result: Manipulator, title: str) -> Document:
    """Facts and notes, without the table."""
    return angles_in_degrees(Document(title, tuple(_facts(result)), tuple(str(grade) for grade in result.grades)))


def document(
    result: Manipulator,
    title: str,
    *,
    patterns: Sequence[str] = (),
    rows: Sequence[int] | None = None,
    everything: bool = False,
    where: str = "",
) -> Document:
    """Summary and table; ``patterns`` choose columns, ``rows`` instants by index; there are no further columns."""
    told, available = summary(result, title), manipulator_columns(result)
    example = f"t,{','.join(result.joints)}"
    return with_positions(
        told, result.labels, available, patterns, rows, example=example, everything=everything, where=where
    )


def _facts(result: Manipulator) -> Iterator[Fact]:
    yield _arm_fact(result)
    for k, leg in enumerate(result.legs):
        yield from _leg_facts(leg, f"leg {k + 1}" if len(result.legs) > 1 else "the gripper", k, len(result.legs))
    for name, angular, law in zip(result.joints, result.angular, result.laws, strict=False):
        for fact in law_facts(law, angular, name, f"{name}_"):
            yield fact if fact.label.startswith("travel") else Fact(f"{fact.label}, {name}", fact.text, fact.values)
    if len(result.legs) != 1:
        yield Fact("duration", f"T = {number(result.duration)} s", keyed(result, "duration"))
    yield from _extreme_facts(result)
    yield from _place_facts(result)
    yield from _contact_facts(result)
    if result.residual is not None:
        text = f"{result.residual:.0e} (relative): the joints lead the gripper back to where it was"
        yield Fact("direct of inverse problem", text, {"residual": {"round_trip": result.residual}})


def _arm_fact(result: Manipulator) -> Fact:
    arm = result.arm
    lines = [f"{ARMS[arm.kind]}{'; base psi' if arm.spatial else ''}"]
    values = {**keyed(arm, "kind"), **PROBLEM.value("inverse" if result.inverse else "direct")}
    if arm.kind == "angular":
        values |= keyed(arm, "upper", "forearm")
        side = ""
        if result.inverse:  # else the joints settle it
            up = "up" if arm.elbow > 0 else "down"
            values |= ELBOW.value(up)
            side = f", elbow {up}"
        lines.append(f"arms of {number(arm.upper)} m and {number(arm.forearm)} m{side}")
    if arm.height:
        lines.append(f"shoulder at a height of {number(arm.height)} m")
        values |= keyed(arm, "height")
    return Fact("arm", "\n".join(lines), values)


def _leg_facts(leg: LegFacts, what: str, k: int, count: int) -> Iterator[Fact]:
    prefix = f"leg_{k + 1}_" if count > 1 else ""
    arcs = [_piece(piece) for piece in leg.pieces]
    begin = f"from t = {number(leg.begin)} s: " if count > 1 else ""
    pieces = [_values(piece) for piece in leg.pieces]
    yield Fact(f"path of {what}", begin + "\n".join(arcs), {f"{prefix}path": pieces})
    for fact in law_facts(leg.law, False, what, prefix, "the tangential"):
        label = fact.label if fact.label.startswith("travel") or count == 1 else f"{fact.label}, {what}"
        yield Fact(label, fact.text, fact.values)
    if leg.speed_limit is not None:
        text = f"{number(leg.speed_limit)} m/s by the limits of the accelerations on the arc"
        values = {f"{prefix}{key}": value for key, value in keyed(leg).items()}
        yield Fact("speed allowed" + ("" if count == 1 else f", {what}"), text, values)


def _point(place: Sequence[float]) -> str:
    return f"({', '.join(number(v, 6) for v in place)})"


def _piece(piece: PieceFacts) -> str:
    ends = f"{_point(piece.start)} to {_point(piece.end)} m, {number(piece.length)} m long"
    if piece.radius is None or piece.centre is None or piece.theta is None or piece.theta_end is None:
        return f"line {ends}"
    turn = f"{angle(math.degrees(piece.theta))} to {angle(math.degrees(piece.theta_end))} deg"
    about = f"centre {_point(piece.centre)} m, R = {number(piece.radius)} m"
    return f"arc {ends}\n{about}, theta from {turn}, q = {piece.sense:+d}"


def _values(piece: PieceFacts) -> dict[str, object]:
    return {key: value for key, value in keyed(piece).items() if value is not None}


def _extreme_facts(result: Manipulator) -> Iterator[Fact]:
    """Extremes of the gripper and of each joint, for people without what never changes."""
    found = {each.name: each for each in result.extremes}
    groups = {"gripper": tuple(each.name for each in GRIPPER)}
    for what, names in (groups | {joint.name: joint[:3] for joint in result.arm.ranged}).items():
        own = [found[name] for name in names if name in found]
        told = [each for each in own if each.least != each.largest]
        if told:
            yield Fact(f"extremes, {what}", extreme_lines(told), extreme_values(own))


def _place_facts(result: Manipulator) -> Iterator[Fact]:
    """Singular places and passed limits: for programs; people read the notes."""
    singular = [keyed(each, unit=each.unit) for each in result.singular]
    text = "none" if not singular else f"{len(singular)} nearly singular or singular, see the notes"
    yield Fact("singular places", text, {"singular": singular})
    excesses = [keyed(each, unit=each.unit) for each in result.excesses]
    if excesses:
        yield Fact("joint limits", f"{len(excesses)} passed, see the notes", {"limits_passed": excesses})


def _contact_facts(result: Manipulator) -> Iterator[Fact]:
    for name in dict.fromkeys(contact.obstacle for contact in result.contacts):
        own = [contact for contact in result.contacts if contact.obstacle == name]
        lines = [f"{each.what}: {'crosses it' if each.intervals else 'clear'}" for each in own]
        values: dict[str, object] = {}
        for each in own:
            values |= keyed(each, obstacle=name, part=each.what.replace(" ", "_"), unit=each.unit)
        yield Fact(f"obstacle {name}" if not name.startswith("obstacle") else name, "\n".join(lines), values)
