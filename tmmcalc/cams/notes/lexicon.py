"""The quantities of a cam by their names in formulas, in which all parts of its chapter agree; lengths in mm.

What differs by the follower has a place in angle brackets: ``<dy>`` is the displacement from the lowest position,
``<y>`` that from the axis of the cam or from the line of centres, with primes for its derivatives by the angle of the
cam, ``<h>`` the stroke, ``<y0>`` the lowest position, ``<v>`` and ``<a>`` velocity and acceleration. Coordinates are
in the user's sense; the formulas of a cam that turns counter-clockwise have other signs, ``<+>`` and ``<->``, and those
of a rocker that rises against the cam ``<d+>`` and ``<d->``.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import pairwise
from math import degrees
from typing import NamedTuple

import numpy as np

from tmmcalc.cams.facts.rows import told_rows
from tmmcalc.cams.follower import Follower
from tmmcalc.cams.lawresult import LawResult
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.pictures.ordered import cam_of
from tmmcalc.cams.program import PhaseKind, Program
from tmmcalc.cams.task import CamTask
from tmmcalc.report.drawing.order import POSITIONS, Order
from tmmcalc.report.formula.digits import Given, significant
from tmmcalc.report.formula.setting import spelt
from tmmcalc.report.formula.symbols import canonical
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.manuscript import Lexicon, Place, Table
from tmmcalc.report.telling import filled, named

STEM = {"dy": "DeltaS", "y": "S", "h": "h", "y0": "S_0", "v": "v", "a": "a"}
# angular velocities of the cam: what is given, and the mean of the time; ``omega`` is that of a position
CONSTANT, VARYING = {"wn": "omega", "wt": "omega"}, {"wn": "omega_n", "wt": "omega_t"}
ROCKER = {"dy": "Deltapsi", "y": "psi", "h": "psi_m", "y0": "psi_0", "v": "omega_2", "a": "eps_2"}
PLUS, MINUS = {"+": "+", "-": "-"}, {"+": "-", "-": "+"}
ANGLES: dict[PhaseKind, str] = {"rise": "phi_y", "high dwell": "phi_d", "return": "phi_c", "low dwell": "phi_b"}
THIRD = 0.3  # of a phase: where it is worked out, as near as the rows of the tables come
NEAR = 1e-9  # of the turn, or a part of a phase: one place
FIGURES = 7  # digits of a value of a table
PLACES = 6  # its decimals at most
SHORT = 5  # digits of an angle within a sentence


class Told(NamedTuple):
    """A cam with its rows, as all parts of the chapter have them."""

    task: CamTask
    law: LawResult
    follower: Follower
    rows: tuple[int, ...]  # that are worked out
    words: Mapping[str, str]  # for the places in angle brackets
    asked: bool  # whether rows were asked for

    @property
    def turns(self) -> bool:
        """The follower is a rocker."""
        return self.follower.kind == "oscillating"

    def labelled(self, row: int) -> str:
        """``in position 4``."""
        return tr("pos. {label}", label=self.law.labels[row])

    def places(self, common: Lexicon, of_row: Sequence[Lexicon]) -> tuple[Place, ...]:
        """The rows that are worked out, each with its quantities and those that all have in common."""
        return tuple(
            Place(self.labelled(row), self.named(common | own)) for row, own in zip(self.rows, of_row, strict=True)
        )

    def named(self, quantities: Lexicon) -> Lexicon:
        """Quantities by their names in the formulas of this follower."""
        return named({filled(name, self.words): given for name, given in quantities.items()})


def told_of(order: Order) -> Told:
    """The cam of a run, at the positions that are asked for, or one of the rise and one of the return."""
    task, law = cam_of(order), order.results["cam_law"]
    follower: Follower = order.results["cam_synthesis"].follower
    rows = tuple(_rows(order, law))
    words = words_of(follower) | (VARYING if task.turning is not None else CONSTANT)
    return Told(task, law, follower, rows, words, _asked(order, law) is not None)


def words_of(follower: Follower) -> dict[str, str]:
    """The words of a follower: its coordinate, and the signs that its senses make."""
    signs = PLUS if follower.sense > 0 else MINUS
    turn = PLUS if follower.assembly > 0 else MINUS
    own = ROCKER if follower.kind == "oscillating" else STEM
    return {**own, **signs, "d+": turn["+"], "d-": turn["-"]}


def _rows(order: Order, law: LawResult) -> Iterator[int]:
    """The rows of the flag, which of a machine counts those of its linkage; a moving phase without one has its own."""
    asked = _asked(order, law)
    listed = told_rows(np.degrees(law.positions.phi), phase_ends(law))
    found = list(asked or ())
    for number, phase in enumerate(law.phases):
        own = [int(row) for row in np.flatnonzero((law.phase == number) & (law.part > 0) & (law.part < 1))]
        if phase.constants is not None and own and not set(own) & set(found):
            wanted = THIRD if phase.kind == "rise" else 1 - THIRD
            found.append(min(own, key=lambda row: _fitness(float(law.part[row]), wanted, row in listed)))
    yield from sorted(found)


def _asked(order: Order, law: LawResult) -> Sequence[int] | None:
    """The rows that are asked for."""
    return order.rows(POSITIONS, law.labels) if "kinematics" not in order.results else None


def _fitness(part: float, wanted: float, listed: bool) -> tuple[bool, bool, float]:
    """How little a row fits: at an eighth of its phase functions of the law may be 0, 1 or alike."""
    return abs(8 * part - round(8 * part)) < NEAR, not listed, abs(part - wanted)


def phase_ends(law: LawResult) -> list[float]:
    """The angles [deg] of the cam at which phases begin and end."""
    return [degrees(each.begin) for each in law.phases] + [degrees(law.phases[-1].end)]


def table_rows(told: Told, dwells: bool = True) -> list[int]:
    """The rows of the tables of the chapter: some forty at round angles and at the ends of phases, and those shown.

    Without ``dwells`` the ends of dwells alone.
    """
    law, ends = told.law, np.array(phase_ends(told.law))
    phi = np.degrees(law.positions.phi)
    rows = sorted({*told_rows(phi, ends.tolist()), *told.rows})
    still = [phase.constants is None for phase in law.phases]
    return [
        row for row in rows if dwells or not still[law.phase[row]] or np.min(np.abs(ends - phi[row])) <= NEAR * phi[-1]
    ]


def of_task(told: Told) -> Lexicon:
    """What is given of the motion: stroke, phases, speed; angles in rad, as the formulas of the law take them."""
    meanings: Mapping[PhaseKind, str] = {
        "rise": tr("phase angle of the rise"),
        "high dwell": tr("phase angle of the far dwell"),
        "return": tr("phase angle of the return"),
        "low dwell": tr("phase angle of the near dwell"),
    }
    task, law = told.task, told.law
    stroke = Given(law.stroke, "rad", tr("swing angle of the rocker")) if law.turns else mm(law.stroke, tr("stroke"))
    found = {"<h>": stroke}
    found |= {ANGLES[each.kind]: Given(each.end - each.begin, "rad", meanings[each.kind]) for each in law.phases}
    if task.loads is not None:
        even = task.turning is None
        said = tr("angular velocity of the cam") if even else tr("given angular velocity of the cam")
        found["<wn>"] = Given(task.loads.speed, "rad/s", said)
    return found


def mean_speed(told: Told) -> Lexicon:
    """The mean angular velocity of a cam whose shaft turns unevenly; nothing of others."""
    if told.task.turning is None:
        return {}
    said = tr("mean angular velocity of the cam over the time of a turn")
    return {"<wt>": Given(told.task.turning.mean, "rad/s", said)}


def of_follower(follower: Follower) -> Lexicon:
    """The sizes of the cam and its follower, the offset in the user's sense."""
    if follower.kind == "flat":
        return {"S_0": mm(follower.start, tr("distance of the face from the axis of the cam in its lowest position"))}
    found = {
        "R_0": mm(follower.base, tr("radius of the base circle of the pitch curve")),
        "r_2": mm(follower.roller, tr("radius of the roller")),
    }
    if follower.kind == "translating":
        found["S_0"] = mm(follower.start, tr("height of the roller centre above the axis of the cam at its lowest"))
        found["e"] = mm(follower.sense * follower.offset + 0.0, tr("offset of the stem, to the right of the axis"))
        return found
    found["l_0"] = mm(follower.centres, tr("distance of the axes of cam and rocker"))
    found["l_2"] = mm(follower.rocker, tr("length of the rocker"))
    found["psi_0"] = angle(follower.start, tr("angle of the rocker from the line of centres in its lowest position"))
    return found


def of_motion(told: Told, row: int) -> Lexicon:
    """The motion in a row: angles in deg, derivatives by the angle of the cam, rates in time where there is a speed."""
    phi, motion = float(told.law.positions.phi[row]), told.law.motion[:, row]
    return {"phi": angle(phi, tr("angle of the cam from the beginning of the rise")), **of_values(told, motion)}


def of_values(told: Told, motion: Values) -> Lexicon:
    """The displacement and its derivatives (4,) at one place."""
    y, y1, y2, y3 = map(float, motion)
    start, speed = told.follower.start, None if told.task.loads is None else told.task.loads.speed
    first = tr("first derivative of the displacement by the angle of the cam, the analogue of velocity")
    second = tr("second derivative of the displacement by the angle of the cam, the analogue of acceleration")
    third = tr("third derivative of the displacement by the angle of the cam")
    if told.turns:
        found = {
            "<dy>": angle(y, tr("angle of the rocker from its lowest position")),
            "<y>": angle(start + y, tr("angle of the rocker from the line of centres")),
            **{f"<y>{k * chr(39)}": Given(value, "", said)
               for k, value, said in ((1, y1, first), (2, y2, second), (3, y3, third))},
        }  # fmt: skip
        rates = (tr("angular velocity of the rocker"), "rad/s"), (tr("angular acceleration of the rocker"), "rad/s^2")
    else:
        found = {
            "<dy>": mm(y, tr("displacement of the follower from its lowest position")),
            "<y>": mm(start + y, tr("distance of the follower from the axis of the cam along its lift")),
            **{f"<y>{k * chr(39)}": mm(value, said)
               for k, value, said in ((1, y1, first), (2, y2, second), (3, y3, third))},
        }  # fmt: skip
        rates = (tr("velocity of the follower"), "m/s"), (tr("acceleration of the follower"), "m/s^2")
    if speed is not None:
        for k, (name, (said, unit)) in enumerate(zip(("<v>", "<a>"), rates, strict=True), 1):
            found[name] = Given(float(motion[k]) * speed**k, unit, said)
    return found


def mm(value: float, meaning: str = "") -> Given:
    """A length [m] in mm."""
    return Given(1e3 * value, "mm", meaning)


def angle(value: float, meaning: str = "") -> Given:
    """An angle [rad] in degrees."""
    return Given(degrees(value), "deg", meaning)


def quantities_table(caption: str, names: Sequence[str], lexicon: Lexicon, key: str) -> Table:
    """Quantities of a lexicon that are there, a row each; in names are no places any more."""
    found = ((name, lexicon.get(canonical(name))) for name in names)
    rows = [
        (given.meaning, f"${name}$", shown_unit(given.unit), number(given))
        for name, given in found
        if given is not None
    ]
    return Table(caption, (tr("Quantity"), tr("Designation"), tr("Unit"), tr("Value")), tuple(rows), key)


def number(given: Given) -> str:
    """A value as it is printed in a table."""
    assert isinstance(given.value, float)
    text = significant(round(given.value, PLACES) + 0.0, FIGURES)
    return f"${text}$" if "e" in text else spelt(text)


def degrees_of(phi: float) -> str:
    """An angle [rad] in degrees within a sentence, without the sign of degrees."""
    return spelt(significant(round(degrees(phi), PLACES) + 0.0, SHORT))


def dwell_of(
    program: Program, phi: float, keeps: Callable[[float, float], bool] | None = None
) -> tuple[float, float] | None:
    """The dwell [rad] all over which something is what it is at phi, so that the angle itself tells nothing; or None.

    ``keeps`` tells whether it is the same all over between two angles, and decides at the ends of a dwell, too; without
    it only the inside of a dwell counts, where a motion has nothing to change it.
    """
    end, starts = float(program.starts[-1]), program.starts.tolist()
    near = NEAR * end if keeps is None else -NEAR * end
    for phase, (first, last) in zip(program.phases, pairwise(starts), strict=True):
        there = not phase.moves and any(first + near < at < last - near for at in (phi, phi + end, phi - end))
        if there and (keeps is None or keeps(first, last)):
            return first, last
    return None


def where(phi: float, dwell: tuple[float, float] | None) -> str:
    """An angle of the cam [rad] in a sentence, or the dwell in which every angle would do."""
    if dwell is None:
        return tr("at $phi$ = {angle}°", angle=degrees_of(phi))
    low, high = map(degrees_of, dwell)
    return tr("over the dwell from $phi$ = {low}° to {high}°", low=low, high=high)


def shown_unit(unit: str) -> str:
    """A unit as it stands in a cell."""
    return "°" if unit == "deg" else tr_unit(unit)
