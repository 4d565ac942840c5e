"""The speeds of a train by Willis' equations of its wheels, each solved for the speed that is new in it."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from typing import NamedTuple

from numpy.typing import ArrayLike

from tmmcalc.gears.chosen.motion import Moving, equations
from tmmcalc.gears.gearingtask import ends
from tmmcalc.gears.network.model import FRAME, Network
from tmmcalc.gears.network.willis import Willis, wheel_names
from tmmcalc.gears.notes.inorder import Equation, Together, in_order
from tmmcalc.gears.notes.letters import joined, member_name, noted, speed_of, teeth
from tmmcalc.report.formula.digits import RESULT, Given, significant
from tmmcalc.report.formula.symbols import canonical
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.language import tr, tr_number, tr_unit
from tmmcalc.report.manuscript import Block, Display, Heading, Lexicon, Paragraph, Place, Table
from tmmcalc.report.telling import lines, named, tabulated

MESH = re.compile(r"\((?P<sign>-?)(?P<over>Z[^/]*)/(?P<under>Z[^)]*)\)")


class Told(NamedTuple):
    """A train in motion with the quantities of its formulas."""

    moving: Moving
    lexicon: Lexicon

    @property
    def network(self) -> Network:
        """Its members and meshes."""
        return self.moving.task.network

    def lines(self, *texts: str) -> Iterator[Block]:
        """Formulas worked out."""
        return lines(texts, [Place("", self.lexicon)])

    def together(self, name: str) -> Paragraph:
        """A quantity that only all equations that are left give."""
        given = self.lexicon[canonical(name)]
        assert isinstance(given.value, float)
        value = f"{tr_number(significant(given.value, RESULT))} {tr_unit(given.unit)}"
        return Paragraph(tr("The equations that are left give together ${name}$ = {value}.", name=name, value=value))

    def relative(self, member: str, carrier: str) -> str:
        """The speed of a member against the carrier of a mesh, in letters; of a bevel planet that on its own axis."""
        if carrier == FRAME or self.network.tilted(member):
            return speed_of(member)
        return f"({speed_of(member)} - {speed_of(carrier)})"


def told_motion(moving: Moving) -> Told:
    """A train in motion: numbers of teeth, speeds of all members."""
    network, motion = moving.task.network, moving.motion
    layout = None if moving.chosen is None else moving.chosen.sets.scheme
    found: Lexicon = {}
    for mesh, names in zip(network.meshes, wheel_names(network, layout), strict=True):
        found |= teeth(dict(zip(names, (mesh.first_teeth, mesh.second_teeth), strict=True)))
    for name, speed in zip(motion.members, motion.speeds.tolist(), strict=True):
        found[speed_of(name)] = Given(speed, "rad/s", tr("angular velocity of link {link}", link=name))
    return Told(moving, named(found))


def told_speeds(told: Told, key: str) -> Iterator[Block]:
    """Known speeds, Willis' equations with their ratios, all speeds; ``key`` that of their table."""
    moving, network = told.moving, told.network
    yield Heading(tr("Angular velocities"), 3)
    yield from _known(told)
    carriers = list(dict.fromkeys(network.carriers))
    if any(carrier != FRAME for carrier in carriers):
        yield Paragraph(
            tr("Willis' formula: with the carrier stopped in thought the wheels turn as in an ordinary train.")
        )
    found = equations(moving).equations
    for each in found:
        yield from _inverted(told, each)
    held = (speed_of(name) for name in moving.task.speeds)
    for step in in_order([*(_solved(told, each) for each in found), *_locks(told)], set(held)):
        if isinstance(step, Together):
            yield told.together(step.name)
        else:
            yield from told.lines(step)
    yield from _planets(told)
    yield from _ratio(told)
    yield Paragraph(tr("The angular velocities of all links are listed in table {tab}.", tab=f"{{tab:{key}}}"))
    yield _table(told, key)


def _known(told: Told) -> Iterator[Block]:
    """The speeds that are given, and what stands."""
    moving = told.moving
    still = [name for name, speed in moving.task.speeds.items() if not speed]
    for name, speed in moving.task.speeds.items():
        if not speed:
            continue
        turns = moving.motion.turns[moving.motion.members.index(name)]
        if moving.remarks:
            said = tr("No speed is given: ${omega}$ = 1 rad/s is taken.", omega=speed_of(name))
            yield Paragraph(said)
            continue
        said = tr("speed of link {link}", link=name)
        told.lexicon.update(named({f"n_{{{name}}}": Given(float(turns), "rpm", said)}))
        yield from told.lines(f"{speed_of(name)} = pi*n_{{{name}}}/30")
    if still:
        yield Paragraph(tr("Links at rest: {members}.", members=_listed(told, still)))


def _listed(told: Told, members: list[str]) -> str:
    """Members with their speed of nothing."""
    return ", ".join(f"${speed_of(name)} = 0$" for name in members)


def ratio_name(each: Willis) -> str:
    """The ratio of the train with the carrier stopped."""
    upper = "" if each.carrier == FRAME else f"^{{{each.carrier}}}"
    return f"i_{{{joined((each.first, each.last))}}}{upper}"


def _inverted(told: Told, each: Willis) -> Iterator[Block]:
    """The equation in letters, and its ratio by the numbers of teeth."""
    name = ratio_name(each)
    if each.carrier == FRAME:
        said = tr("ratio of {first} and {last}", first=each.first, last=each.last)
    else:
        said = tr("ratio of {first} and {last} with the carrier stopped", first=each.first, last=each.last)
    told.lexicon.update(named({name: Given(each.inverted, "", said)}))
    one, other = (told.relative(member, each.carrier).strip("()") for member in (each.first, each.last))
    yield Display(read(f"({one})/({other}) = {name}"))
    yield from told.lines(f"{name} = {_product(each)}")


def _product(each: Willis) -> str:
    """The ratio by the numbers of teeth of the meshes, without those of idlers."""
    meshes = [*MESH.finditer(each.formula)]
    sign = "-" * (sum(bool(mesh["sign"]) for mesh in meshes) % 2)
    over, under = ([noted(mesh[side]) for mesh in meshes] for side in ("over", "under"))
    for idler in [name for name in over if name in under]:
        over.remove(idler)
        under.remove(idler)
    return f"{sign}{'*'.join(over) or '1'}" + (f"/({'*'.join(under)})" if under else "")


def _solved(told: Told, each: Willis) -> Equation:
    """Willis' equation solved for each of its speeds; those of a bevel planet are on its own axis."""
    i, c = ratio_name(each), speed_of(each.carrier)
    first, last = speed_of(each.first), speed_of(each.last)
    one, other = (told.relative(name, each.carrier) for name in (each.first, each.last))
    carried = {name: speed.startswith("(") for name, speed in ((first, one), (last, other))}
    plus = {name: f"{c} + " if turns else "" for name, turns in carried.items()}
    solved = {last: f"{last} = {plus[last]}{one}/{i}", first: f"{first} = {plus[first]}{i}*{other}"}
    if carried[first] and carried[last] and each.inverted != 1:
        solved[c] = f"{c} = ({first} - {i}*{last})/(1 - {i})"
    elif carried[first] and not carried[last]:
        solved[c] = f"{c} = {first} - {i}*{last}"
    elif carried[last] and not carried[first]:
        solved[c] = f"{c} = {last} - {first}/{i}"
    return Equation(solved)


def _locks(told: Told) -> Iterator[Equation]:
    """Members that turn as one."""
    for one, other in told.moving.task.locked:
        a, b = speed_of(one), speed_of(other)
        yield Equation({a: f"{a} = {b}", b: f"{b} = {a}"})


def _planets(told: Told) -> Iterator[Block]:
    """Speeds of planets against their carriers."""
    motion = told.moving.motion
    for name, speed in zip(motion.members, motion.relative.tolist(), strict=True):
        carrier = told.network.bearer(name)
        if carrier == FRAME or told.network.tilted(name) or not motion.speed(carrier):
            continue
        symbol = f"omega_{{{name}}}^{{{carrier}}}"
        said = tr("angular velocity of link {link} against its carrier", link=name)
        told.lexicon.update(named({symbol: Given(speed, "rad/s", said)}))
        yield from told.lines(f"{symbol} = {speed_of(name)} - {speed_of(carrier)}")


def ends_of(moving: Moving) -> tuple[str, str] | None:
    """The driver and the only driven member that turns, in a motion of one driver; None: there are no such two."""
    driver, outputs = ends(moving.task)
    turning = [name for name, speed in moving.task.speeds.items() if speed]
    if driver is None or len(turning) != 1 or len(outputs) != 1 or not moving.motion.speed(outputs[0]):
        return None
    return driver, outputs[0]


def _ratio(told: Told) -> Iterator[Block]:
    """The ratio of the whole train, where one member drives one other."""
    pair = ends_of(told.moving)
    if pair is None:
        return
    motion = told.moving.motion
    first, last = (motion.exact[told.network.place[name]] for name in pair)
    name = f"i_{{{joined(pair)}}}"
    if canonical(name) in told.lexicon:  # of fixed axes it is one of the equations
        return
    told.lexicon.update(named({name: Given(float(first / last), "", tr("ratio of the train"))}))
    yield from told.lines(f"{name} = {speed_of(pair[0])}/{speed_of(pair[1])}")


def _table(told: Told, key: str) -> Table:
    motion = told.moving.motion
    columns: dict[str, ArrayLike] = {
        "$omega$, rad/s": motion.speeds,
        "$n$, rpm": motion.turns,
    }
    borne = [told.network.bearer(name) != FRAME for name in motion.members]
    if any(borne):
        relative = zip(borne, motion.relative.tolist(), strict=True)
        columns[f"{tr('against the carrier')}, rad/s"] = [speed if of else math.nan for of, speed in relative]
    labels = [member_name(told.network, name) for name in motion.members]
    return tabulated(tr("Angular velocities of the links"), columns, labels, head=tr("Link"), key=key)
