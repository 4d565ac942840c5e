"""The documents of the gearing stage: ratios, speeds, torques, power flow, efficiency and frequencies of a train."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction

from tmmcalc.core.notes import Phrase
from tmmcalc.core.quantity import Quantity, keyed, quantities
from tmmcalc.gears.gearing import Drive, Gearing
from tmmcalc.gears.members import Columns, frequency_columns, member_columns, power_columns, torque_columns
from tmmcalc.gears.network.model import FRAME
from tmmcalc.gears.network.power import PowerFlow
from tmmcalc.gears.scheme import layout_of
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.numbers import number

MORE = "--format json prints all of them"
NOISE = 1e-10  # part of the power put in: what is below it is the rounding of the equilibrium
LONGEST = 24  # characters of a fraction that is printed; longer ones go to programs alone


def summary(result: Gearing, title: str, people: bool = False) -> Document:
    """Facts and the table of members, for people with their speeds in rpm."""
    facts = (*_train_facts(result), *_ratio_facts(result), *_efficiency_facts(result), *_power_facts(result))
    legend = f"{'n_rel' if people else 'omega_rel'} against its own carrier"
    columns = member_columns(result, people)
    if "i" in columns:
        legend += f"; i: speed of {result.input} over that of the member"
    if result.flow is not None:
        legend += "; torque and power from outside"
    facts += (Fact("in the table", legend),)
    return Document(title, facts, tuple(_notes(result)), _view(columns), wide=True, more=MORE)


def document(result: Gearing, title: str, *, everything: bool = False) -> Document:
    """Facts, the table of members, and those of meshes: torques, powers, frequencies; ``everything`` is all in SI."""
    return replace(summary(result, title, people=not everything), parts=tuple(_mesh_parts(result)))


def _train_facts(result: Gearing) -> Iterator[Fact]:
    """What the train is, its mobility, what of its motion is known."""
    task, motion = result.task, result.motion
    if task.layout is not None:
        scheme = layout_of(task.layout)
        teeth = ", ".join(f"Z{wheel} = {z}" for wheel, z in zip(scheme.wheels, task.teeth, strict=True))
        values = {**keyed(task, "layout"), "teeth": dict(zip(scheme.wheels, task.teeth, strict=True))}
        yield Fact("train", f"{task.layout}: {scheme.title}\n{teeth}", values)
    else:
        counted = f"{len(task.network.meshes)} meshes, {len(motion.members)} members that turn"
        yield Fact("train", counted, {MESHES.key: len(task.network.meshes), MEMBERS.key: len(motion.members)})
    if task.locked:
        pairs = ", ".join(" and ".join(pair) for pair in task.locked)
        yield Fact("locked", pairs, {"locked": [list(pair) for pair in task.locked]})
    yield Fact("mobility", f"W = {motion.mobility}, as many known speeds determine all", keyed(motion, "mobility"))
    known = [f"{name} {f'at {_speed(w)}' if w else 'held'}" for name, w in task.speeds.items()]
    yield Fact("known speeds", ", ".join(known), keyed(task, "speeds"))
    if result.assembly is not None:
        text = f"{number(float(result.assembly))} = whole number for {task.planets} equally spaced planets"
        if result.assembly.denominator != 1:
            text = f"{number(float(result.assembly))} is no whole number"
        yield Fact("assembly", text, keyed(task, "planets") | {"assembly": float(result.assembly)})


def _speed(omega: float) -> str:
    return f"{number(omega * 30 / math.pi)} rpm"


def _ratio_facts(result: Gearing) -> Iterator[Fact]:
    """Exact ratios of the input to every output; of several known speeds what each adds to the others."""
    for name in result.outputs:
        ratio = result.ratio_to(name)
        if ratio is None or result.input is None or name == result.input:
            continue
        for first, last, value in ((result.input, name, ratio), (name, result.input, 1 / ratio)):
            yield _ratio_fact(first, last, value)
    if len(result.turning) > 1:
        yield from _sum_facts(result)
    if result.basic is not None:
        basic = result.basic
        inverted = 1 - basic.ratio
        text = f"{_exact(inverted)}, carrier {basic.carrier} stopped: {basic.first} over {basic.last}"
        yield Fact("inverted train", text, {"i_inverted": float(inverted), "i_inverted_exact": str(inverted)})


RATIO = Quantity("i_{first}_{last}", "ratio of the turns of {first} to those of {last}")
EXACT = Quantity("i_{first}_{last}_exact", "exact ratio of the turns of {first} to those of {last}")
INVERTED = Quantity("i_inverted", "ratio of the inverted train")
INVERTED_EXACT = Quantity("i_inverted_exact", "exact ratio of the inverted train")
MESHES, MEMBERS = Quantity("meshes", "number of meshes"), Quantity("members", "number of members")
COUNTS = Quantity("counts", "members of this name")


def _ratio_fact(first: str, last: str, value: Fraction) -> Fact:
    name = RATIO.of(first=first, last=last).key
    return Fact(
        f"ratio {first} : {last}", _exact(value), {name: float(value), EXACT.of(first=first, last=last).key: str(value)}
    )


def _exact(value: Fraction) -> str:
    """A ratio as a fraction and a decimal.

    >>> _exact(Fraction(22, 3)), _exact(Fraction(-6))
    ('22/3 = 7.333333333', '-6')
    """
    exact, decimal = str(value), number(float(value), 10)
    return decimal if exact == decimal or len(exact) > LONGEST else f"{exact} = {decimal}"


def _sum_facts(result: Gearing) -> Iterator[Fact]:
    """Speeds of the members that no one gave as sums of those that were given."""
    motion = result.motion
    for name, row in zip(motion.members, motion.transfer, strict=True):
        if name in motion.driven or result.task.network.bearer(name) != FRAME:
            continue
        terms = [(c, driven) for c, driven in zip(row, motion.driven, strict=True) if c]
        text = " ".join(f"{'-' if c < 0 else '+'} {_factor(abs(c))}n_{driven}" for c, driven in terms)
        values = {driven: str(c) for c, driven in terms}
        yield Fact(
            Phrase("speed of {member}", member=name),
            f"n_{name} = {text.removeprefix('+ ')}",
            {f"speed_of_{name}": values},
        )


def _factor(value: Fraction) -> str:
    return "" if value == 1 else f"{value} "


def _efficiency_facts(result: Gearing) -> Iterator[Fact]:
    """Both directions, the closed formula beside them."""
    for way in result.ways:
        yield _way_fact(way)
    if result.basic is not None and any(way.formula is not None for way in result.ways):
        text = f"eta_0 = {number(result.basic.efficiency)}, carrier stopped (textbook, table 4.6)"
        yield Fact("of the inverted train", text, keyed(result.basic, "efficiency"))


def _way_fact(way: Drive) -> Fact:
    text = f"eta = {number(way.efficiency)}"
    if way.formula is not None:
        text += f", by the closed formula {number(way.formula)}"
    if way.self_locking:
        text += "\nself-locking: no load can be moved this way"
    text += f"\nrolling power up to {number(way.potential, 5)} of the power put in"
    values = keyed(way, "efficiency", "formula", "self_locking", "potential", way=f"{way.driver}_{way.output}")
    return Fact(f"{way.driver} drives {way.output}", text, values)


def _power_facts(result: Gearing) -> Iterator[Fact]:
    """Power in and out, what circulates, locks, how planets share."""
    flow = result.flow
    if flow is None:
        return
    peak = max(abs(flow.power_in), abs(flow.power_lost))
    given = (flow.power_in, flow.power_in - flow.power_lost, flow.power_lost)
    text = "{} in, {} out, {} lost".format(*(_power(watts, peak) for watts in given))
    if flow.efficiency is not None and not result.ways:
        text += f"\neta = {number(flow.efficiency)}"
    values = keyed(flow, "power_in", "power_lost", "efficiency") | keyed(result, "assumed")
    values |= {"residual": {"equilibrium": flow.residual}, "error": result.error}
    yield Fact("power", text, values)
    yield _loops_fact(flow, {*result.motion.members})
    if result.task.locked:
        torques = dict(zip(map("-".join, result.task.locked), flow.lock_torques.tolist(), strict=True))
        text = ", ".join(f"{pair}: {number(abs(torque), 6)} N*m" for pair, torque in torques.items())
        yield Fact("torque in locks", text, {quantities(PowerFlow)["lock_torques"].key: torques})
    yield from _sharing_facts(result)


def _power(watts: float, peak: float = 0.0) -> str:
    """A power for people; 0 if it is noise against ``peak``."""
    if abs(watts) < NOISE * peak:
        watts = 0.0
    return f"{number(watts / 1000, 6)} kW" if abs(watts) >= 1e4 else f"{number(watts, 6)} W"


def _loops_fact(flow: PowerFlow, members: set[str]) -> Fact:
    """Power that goes round in the train, and its way."""
    lines = []
    for loop in flow.loops:
        part = f", {number(loop.power / flow.power_in, 4)} of the power put in" if flow.power_in else ""
        round_ = ", ".join(name for name in loop.path if name in members)
        lines += [f"{_power(loop.power)}{part}, round {round_}:", " > ".join((*loop.path, loop.path[0]))]
    values = [keyed(loop, "power", "path") for loop in flow.loops]
    return Fact("circulating power", "\n".join(lines) or "none", {"circulating": values})


def _sharing_facts(result: Gearing) -> Iterator[Fact]:
    network = result.task.network
    several = [name for name in result.motion.members if network.count(name) > 1]
    lines = []
    for name in several:
        share = network.sharing(name) / network.count(name)
        text = f"{network.count(name)} members {name}: the most loaded one takes {number(share, 5)} of the torque"
        lines.append(f"{text} (factor {network.sharing(name):g})" if network.sharing(name) != 1 else text)
    if lines:
        counts = {name: network.count(name) for name in several}
        yield Fact("side by side", "\n".join(lines), {COUNTS.key: counts}, COUNTS.meaning)


def _notes(result: Gearing) -> Iterator[str]:
    """What was taken for want of data, and what is unusual."""
    if result.locking:
        yield Phrase("warning: {locking}", locking=result.locking)
    if result.assembly is not None and result.assembly.denominator != 1:
        planets = result.task.planets
        yield Phrase(
            "warning: {planets} equally spaced planets do not fit in with these numbers of teeth", planets=planets
        )
    if result.task.layout is not None and layout_of(result.task.layout).single:
        sun, planet, ring = result.task.teeth
        if ring != sun + 2 * planet:
            yield Phrase("note: Z3 is not Z1 + 2 Z2 = {sun}: such wheels need profile shifts", sun=sun + 2 * planet)
    for name in result.motion.redundant:
        yield Phrase("note: mesh {name} turns in step with the others, which imply it", name=name)
    for remark in result.task.remarks:
        yield Phrase("note: {remark}", remark=remark)
    if result.assumed:
        yield Phrase("note: no torque is known: torques and powers are those of 1 N*m on {input}", input=result.input)
    elif result.flow is None and not result.locking:
        yield "note: no torque is known: give torques, load or powers for the power flow"


def _mesh_parts(result: Gearing) -> Iterator[Document]:
    """Tables of the meshes."""
    if result.flow is not None:
        text = "on wheel 1, wheel 2 and the carrier c; of the most loaded planet"
        yield _part("torques in the meshes", text, torque_columns(result, result.flow))
        text = "P_roll from wheel 1 to wheel 2, the carrier held; P_1, P_2, P_c given to them in the frame"
        yield _part("power in the meshes", text, power_columns(result, result.flow))
    text = "turns against the carrier; tooth: meetings of one tooth; pair: of the same two teeth"
    yield _part("frequencies of the meshes", text, frequency_columns(result))


def _part(title: str, legend: str, columns: Columns) -> Document:
    return Document(title, (Fact("in the table", legend),), (), _view(columns), wide=True, more=MORE)


def _view(columns: Columns) -> View:
    """The columns with their peaks: powers are noise against the largest of all, and so are torques and speeds."""
    groups: dict[str, float] = {}
    sizes = [max((abs(v) for v in column if isinstance(v, float)), default=0.0) for column in columns.values()]
    units = [header.partition("[")[2] for header in columns]
    for unit, size in zip(units, sizes, strict=True):
        groups[unit] = max(groups.get(unit, 0.0), size if unit else 0.0)
    return View(list(columns), list(columns.values()), [groups[unit] for unit in units])
