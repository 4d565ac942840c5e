"""The torques of a train mesh by mesh, from equilibrium and the losses of the meshes; powers and efficiency.

A mesh puts torques on both its wheels and their sum, reversed, on the carrier; the sum of all torques on a member is
zero. Losses are parts of the power that rolls through a mesh with its carrier stopped.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from tmmcalc.gears.gearing import Gearing
from tmmcalc.gears.network.model import FRAME, INTERNAL, Mesh
from tmmcalc.gears.network.power import PowerFlow
from tmmcalc.gears.network.willis import wheel_names
from tmmcalc.gears.notes.inorder import Equation, Together, in_order
from tmmcalc.gears.notes.letters import speed_of, teeth_of
from tmmcalc.gears.notes.speeds import Told
from tmmcalc.report.formula.digits import Given, significant
from tmmcalc.report.language import tr, tr_number
from tmmcalc.report.manuscript import Block, Heading, Lexicon, Paragraph, Table
from tmmcalc.report.telling import named

NOTHING = 1e-12  # of the largest torque
DIGITS = 5


class Mark(NamedTuple):
    """A mesh with its number in the note."""

    number: str
    mesh: Mesh
    carrier: str
    wheels: tuple[str, str]

    def torque(self, member: str) -> str:
        """The torque that it puts on a member."""
        return f"T_{{{member}}}^{{{self.number}}}"

    @property
    def eta(self) -> str:
        """Its efficiency."""
        return f"eta_{{{self.number}}}"

    @property
    def power(self) -> str:
        """The power that rolls through it."""
        return f"P^{{{self.number}}}"

    @property
    def loss(self) -> str:
        """The power that is lost in it."""
        return f"P_v^{{{self.number}}}"


def told_torques(told: Told, found: Gearing, key: str, *, sized: bool = False) -> Iterator[Block]:
    """Meshes, torques in an order in which each follows from those before, powers; ``key`` of the table of meshes.

    Where the train is ``sized`` the torque on its first wheel is that of the strength calculation.
    """
    flow = found.flow
    if flow is None:
        return
    marks = _marks(told)
    outside = _outside(found, flow)
    told.lexicon.update(named(_quantities(told, marks, flow, outside)))
    yield Heading(tr("Torques, powers, efficiency"), 3)
    yield Paragraph(
        tr(
            "The meshes are numbered as in table {tab}. In N·m the torque $T_j^k$ is that of the mesh $k$ on the link "
            "$j$, $T_j$ that from outside; $eta_k$ is the efficiency of the mesh.",
            tab=f"{{tab:{key}}}",
        )
    )
    yield _table(told, marks, key)
    yield from _known(told, found, outside, sized=sized)
    equations = [*_meshes(told, marks, flow), *_members(told, found, marks, outside)]
    for step in in_order(equations, {_from_outside(name) for name in _given(found)}):
        if isinstance(step, Together):
            yield told.together(step.name)
        else:
            yield from told.lines(step)
    yield from _powers(told, marks, found, flow, outside)


def _marks(told: Told) -> list[Mark]:
    layout = None if told.moving.chosen is None else told.moving.chosen.sets.scheme
    network = told.network
    meshes = zip(network.meshes, network.carriers, wheel_names(network, layout), strict=True)
    return [Mark(_roman(k), *each) for k, each in enumerate(meshes, 1)]


def _roman(k: int) -> str:
    """A number below 40."""
    return "X" * (k // 10) + ("", "I", "II", "III", "IV", "V", "VI", "VII", "VIII", "IX")[k % 10]


def _from_outside(member: str) -> str:
    return f"T_{{{member}}}"


def _power(member: str) -> str:
    return f"P_{{{member}}}"


def _outside(found: Gearing, flow: PowerFlow) -> list[str]:
    """Members with a torque from outside."""
    largest = float(abs(flow.torques).max(initial=0.0))
    return [
        name
        for name, torque in zip(found.motion.members, flow.torques.tolist(), strict=True)
        if abs(torque) > NOTHING * largest
    ]


def _given(found: Gearing) -> list[str]:
    """Members whose torque from outside is given."""
    task = found.task
    given = [*task.torques, *task.loads, *task.powers]
    return given or ([] if found.input is None else [found.input])


def _quantities(told: Told, marks: list[Mark], flow: PowerFlow, outside: list[str]) -> Lexicon:
    """Torques, powers, losses; what they are is said of all at once."""
    found: Lexicon = {}
    for k, mark in enumerate(marks):
        members = (mark.mesh.first, mark.mesh.second, mark.carrier)
        for member, value in zip(members, flow.mesh_torques[k].tolist(), strict=True):
            if member != FRAME:
                found[mark.torque(member)] = Given(value, "N*m", "")
        found[mark.eta] = Given(mark.mesh.efficiency, "", "")
        found[mark.power] = Given(abs(float(flow.rolling[k])), "W", "")
        found[mark.loss] = Given(float(flow.losses[k]), "W", "")
    for name in outside:
        found[_from_outside(name)] = Given(flow.torque(name), "N*m", "")
        found[_power(name)] = Given(flow.power(name), "W", "")
    for (one, other), value in zip(told.moving.task.locked, flow.lock_torques.tolist(), strict=True):
        said = tr("torque that {first} gets of {second}, with which it turns as one", first=one, second=other)
        found[_lock(one, other)] = Given(value, "N*m", said)
    return found


def _lock(one: str, other: str) -> str:
    return f"T_{{{one},{other}}}"


def _table(told: Told, marks: list[Mark], key: str) -> Table:
    """The meshes with their numbers."""
    moves = any(mark.carrier != FRAME for mark in marks)
    head = (tr("Mesh"), tr("Wheels"), tr("Kind of mesh"), tr("Links"), *[tr("Carrier")] * moves, "$eta_k$")
    rows = []
    for mark in marks:
        kind = tr("internal") if mark.mesh.sign == INTERNAL else tr("external")
        if told.network.tilted(mark.mesh.first) or told.network.tilted(mark.mesh.second):
            kind = tr("bevel")
        carrier = tr("frame") if mark.carrier == FRAME else mark.carrier
        eta = tr_number(significant(mark.mesh.efficiency, DIGITS))
        links = f"{mark.mesh.first}, {mark.mesh.second}"
        rows.append((mark.number, "–".join(mark.wheels), kind, links, *[carrier] * moves, eta))
    return Table(tr("Meshes of the train"), head, tuple(rows), key)


def _known(told: Told, found: Gearing, outside: list[str], *, sized: bool) -> Iterator[Block]:
    """The torques from outside that are given."""
    task, flow = found.task, found.flow
    if found.assumed:
        yield Paragraph(tr("No torque is given: ${torque}$ = 1 N·m is taken.", torque=_from_outside(found.input or "")))
    for name, torque in task.torques.items():
        if torque and name in outside:
            values = {"torque": _from_outside(name), "value": tr_number(significant(torque, DIGITS))}
            yield Paragraph(
                tr(
                    "The torque from outside is that for which the strength is calculated below: ${torque}$ = {value} "
                    "N·m.",
                    **values,
                )
                if sized
                else tr("The torque from outside is known: ${torque}$ = {value} N·m.", **values)
            )
    for name, load in task.loads.items():
        if load:
            sign = "-" if flow is not None and flow.torque(name) < 0 else ""
            said = tr("load of link {link}, against its motion", link=name)
            told.lexicon.update(named({f"M_{{{name}}}": Given(load, "N*m", said)}))
            yield from told.lines(f"{_from_outside(name)} = {sign}M_{{{name}}}")
    for name in task.powers:
        yield from told.lines(f"{_from_outside(name)} = {_power(name)}/{speed_of(name)}")


def _meshes(told: Told, marks: list[Mark], flow: PowerFlow) -> Iterator[Equation]:
    """Of each mesh the torque on the second wheel by that on the first, and that on the carrier."""
    for k, mark in enumerate(marks):
        mesh, carrier = mark.mesh, mark.carrier
        one, other = mark.torque(mesh.first), mark.torque(mesh.second)
        sign = "-" if mesh.sign == INTERNAL else ""
        first, second = map(teeth_of, mark.wheels)
        rolls = float(flow.rolling[k]) if mesh.efficiency < 1 else 0.0
        times, over = {1: (f"*{mark.eta}", ""), -1: ("", f"*{mark.eta}"), 0: ("", "")}[(rolls > 0) - (rolls < 0)]
        yield Equation(
            {
                other: f"{other} = {sign}{second}*{one}{times}/({first}{over})",
                one: f"{one} = {sign}{first}*{other}{over}/({second}{times})",
            }
        )
        carried = [name for name in (mesh.first, mesh.second) if not told.network.tilted(name)]
        if not _bears(told, mark):
            continue
        own = mark.torque(carrier)
        solved = {own: f"{own} = {_minus([mark.torque(name) for name in carried])}"}
        for name in carried:
            rest = [own, *(mark.torque(each) for each in carried if each != name)]
            solved[mark.torque(name)] = f"{mark.torque(name)} = {_minus(rest)}"
        yield Equation(solved)


def _bears(told: Told, mark: Mark) -> list[str]:
    """The carrier of a mesh that gets a torque from it."""
    parallel = not all(told.network.tilted(name) for name in (mark.mesh.first, mark.mesh.second))
    return [mark.carrier] if parallel and mark.carrier != FRAME else []


def _members(told: Told, found: Gearing, marks: list[Mark], outside: list[str]) -> Iterator[Equation]:
    """Of each member that the sum of all torques is zero."""
    for name in found.motion.members:
        on = [(mark.mesh.first, mark.mesh.second, *_bears(told, mark)) for mark in marks]
        terms = [mark.torque(name) for mark, members in zip(marks, on, strict=True) if name in members]
        terms += [_from_outside(name)] * (name in outside)
        locked = {_lock(*pair): pair.index(name) for pair in found.task.locked if name in pair}
        solved = {}
        for term in terms:
            rest = [each for each in terms if each != term]
            turned = "".join(f" {'-+'[k]} {lock}" for lock, k in locked.items())
            solved[term] = f"{term} = {_minus(rest)}{turned}".replace("= 0 - ", "= -").replace("= 0 + ", "= ")
        for lock, k in locked.items():
            value = _minus(terms) if not k else " + ".join(terms)
            solved[lock] = f"{lock} = {value}"
        yield Equation(solved)


def _minus(names: list[str]) -> str:
    """The sum of several, reversed."""
    return "-" + " - ".join(names) if names else "0"


def _powers(told: Told, marks: list[Mark], found: Gearing, flow: PowerFlow, outside: list[str]) -> Iterator[Block]:
    """Powers from outside, rolling powers, losses, the balance."""
    lossy = [(k, mark) for k, mark in enumerate(marks) if flow.losses[k]]
    said = tr("In watts $P_j$ is the power at the link $j$, put in if it is positive")
    if lossy:
        rolls = any(mark.carrier != FRAME for mark in marks)
        said += "; " + (
            tr("$P^k$ that which rolls through the mesh $k$ with its carrier stopped, $P_v^k$ what is lost in it")
            if rolls
            else tr("$P^k$ that which passes through the mesh $k$, $P_v^k$ what is lost in it")
        )
    yield Paragraph(f"{said}.")
    for name in outside:
        if name not in found.task.powers:
            yield from told.lines(f"{_power(name)} = {_from_outside(name)}*{speed_of(name)}")
    for k, mark in lossy:
        source = mark.mesh.first if flow.rolling[k] > 0 else mark.mesh.second
        speed = told.relative(source, mark.carrier)
        yield from told.lines(
            f"{mark.power} = abs({mark.torque(source)}*{speed})", f"{mark.loss} = {mark.power}*(1 - {mark.eta})"
        )
    if flow.efficiency is None:
        return
    said = tr("efficiency of the train")
    told.lexicon.update(named({"eta": Given(flow.efficiency, "", said)}))
    put_in = [_power(name) for name in outside if flow.power(name) > 0]
    taken = [_power(name) for name in outside if flow.power(name) < 0]
    if taken:
        out = " + ".join(f"abs({name})" for name in taken)
        yield from told.lines(f"eta = ({out})/({' + '.join(put_in)})")
    if lossy:
        lost = " + ".join(mark.loss for _, mark in lossy)
        told.lexicon.update(named({"P_v": Given(flow.power_lost, "W", tr("power lost in all meshes"))}))
        yield from told.lines(f"P_v = {lost}")
        yield Paragraph(tr("As a check, the powers from outside leave the same:"))
        yield from told.lines(f"P_v = {' + '.join([*put_in, *taken])}")
