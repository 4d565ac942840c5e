"""Stresses of the parts of a grab transloader by load cases, beside what is allowed."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import partial

from tmmcalc.extras.loadcases import CASES, LOADS, OF_WEIGHT
from tmmcalc.extras.notes.grabdata import KILO, MEGA, influence, kind_of, lettered, of_part
from tmmcalc.extras.pictures.transloader import draw_stresses
from tmmcalc.extras.transloader import (
    Check,
    Part,
    Transloader,
    TransloaderTask,
)
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr, tr_name, tr_unit
from tmmcalc.report.manuscript import Block, Datum, Lexicon, Paragraph, Place, Result, Table
from tmmcalc.report.telling import cell, drawn, lines, named, numeral

MARGIN = {"sum": "K_m = K_1 + K_2", "product": "K_m = K_1*K_2"}
BAR, FRAME = 9.0, 32.0  # heights of a stress and of what is around all [mm]


def stresses(result: Transloader, task: TransloaderTask) -> Iterator[Block]:
    """Part by part force, stress and allowed stress; then all of them."""
    yield Paragraph(
        tr(
            "The parts are in table {tab:transloader_parts}. The force in a part is the sum of the loads of the "
            "case, each with its coefficient $c$ (table {tab:transloader_influence}); weights act as they are, other "
            "loads to either side, so that they are added at their worst. The allowed stress is $sigma_a = "
            "sigma_0/(K_m*K_n)$ with the factors of the mechanism, $K_1$, of its duty, $K_2$, and against fatigue "
            "that of how the part is made, $K_n$."
        )
    )
    yield _parts(task.parts)
    yield _influence(task.parts)
    yield Paragraph(
        tr("The factors $K_1$ and $K_2$ are added to $K_m$.")
        if result.factors == "sum"
        else tr("The factors $K_1$ and $K_2$ are multiplied to $K_m$.")
    )
    for part in task.parts:
        checks = [each for each in result.checks if each.part == part.name]
        if checks:
            yield from _part(part, checks, result)
    yield Paragraph(
        tr(
            "The stresses beside what is allowed are in table {tab:transloader_stresses} and in figure "
            "{fig:transloader_stresses}."
        )
    )
    yield _checked(result)
    unchecked = [part.name for part in task.parts if not any(_is_of(each, part, "V") for each in result.checks)]
    if unchecked:
        said = tr("Out of service no factor $K_1$ is known of {parts}: cases V1 and V2 are not checked.")
        yield Paragraph(said.replace("{parts}", ", ".join(map(tr_name, unchecked))))
    high = FRAME + BAR * len(result.checks)
    yield drawn(tr("Stresses of the parts"), partial(draw_stresses, result=result), high, "transloader_stresses")
    yield from _worst(result.checks)


def _is_of(check: Check, part: Part, letter: str) -> bool:
    return check.part == part.name and check.case[0] == letter


def _parts(parts: Sequence[Part]) -> Table:
    """Where each part belongs, how it is made, its section and limit stresses."""
    return _beside(
        tr("Parts whose stresses are looked at"), tr("Part"), parts, map(of_part, parts), "transloader_parts"
    )


def _influence(parts: Sequence[Part]) -> Table:
    """Force in each part over each load."""
    caption, order = tr("Force in a part over each load"), list(map(lettered, LOADS))
    return _beside(caption, tr("Load"), parts, map(influence, parts), "transloader_influence", order)


def _beside(
    caption: str, head: str, parts: Sequence[Part], data: Iterable[Iterable[Datum]], key: str, order: Sequence[str] = ()
) -> Table:
    """What is given of parts, a column each; rows in the order in which they come, or in one of what they are."""
    columns = [{each.what: each for each in own} for own in data]
    found = {what: each for column in columns for what, each in column.items()}
    rows = []
    for what in [what for what in order if what in found] or found:
        names = "".join(f", ${name}$" for name in found[what].keys)
        unit = f", {tr_unit(found[what].unit)}" if found[what].unit else ""
        cells = (column[what].text or cell(column[what].values[0]) if what in column else "–" for column in columns)
        rows.append((f"{what}{names}{unit}", *cells))
    return Table(caption, (head, *(tr_name(part.name) for part in parts)), tuple(rows), key)


def _part(part: Part, checks: Sequence[Check], result: Transloader) -> Iterator[Block]:
    """Force and stress of a part by case, its allowed stresses."""
    yield Paragraph(
        tr("Part: {part}. The force by case, and the stress with the section $A$:", part=tr_name(part.name))
    )
    sizes = {each.load: each.value / KILO for each in result.loads}
    acting = {case: [each.load for each in result.loads if case in each.cases] for case in CASES}
    forces: dict[str, list[Place]] = {}
    for check in {each.case: each for each in checks}.values():
        found = _of_part(part, check)
        text = []
        own = [(ratio, sizes[name], name in OF_WEIGHT) for name, ratio in part.influence if name in acting[check.case]]
        for weight, counter, form in ((True, "i", "abs(sum(c_i*F_i, i))"), (False, "k", "sum(abs(c_k)*F_k, k)")):
            chosen = [(ratio, size) for ratio, size, kind in own if kind == weight]
            if chosen:
                text.append(form)
                said = tr("weight of the case") if weight else tr("other load of the case")
                found[f"c_{counter}"] = Given([each for each, _ in chosen], "", tr("force in the part over the load"))
                found[f"F_{counter}"] = Given([each for _, each in chosen], "kN", said)
        if text:
            place = Place(tr("in case {case}", case=check.case), named(found))
            forces.setdefault(f"N = {' + '.join(text)}", []).append(place)
    for formula, places in forces.items():
        yield from lines([formula], places)
    every = [place for places in forces.values() for place in places]
    if every:
        yield from lines(["sigma = 10*N/A"], every)
    yield Paragraph(tr("Its factors and allowed stresses:"))
    yield from lines([MARGIN[result.factors]], [_like(same, part, kind="") for same in _alike(checks, "importance")])
    yield from lines(
        ["sigma_a = sigma_0/(K_m*K_n)"],
        [_like(same, part, kind=kind_of(same[0].kind)) for same in _alike(checks, "importance", "kind")],
    )


def _alike(checks: Sequence[Check], *names: str) -> list[list[Check]]:
    """Checks with the same values of these fields together."""
    found: dict[tuple[object, ...], list[Check]] = {}
    for check in checks:
        found.setdefault(tuple(getattr(check, name) for name in names), []).append(check)
    return list(found.values())


def _like(checks: Sequence[Check], part: Part, *, kind: str) -> Place:
    """The cases that have one allowed stress; of a part that is checked in two ways with the kind of the check."""
    cases = list(dict.fromkeys(each.case for each in checks))
    said = tr("in case {case}", case=cases[0])
    if len(cases) > 1:
        said = tr("in cases {cases}", cases=", ".join(cases))
    if kind and part.endurance is not None:
        said += f", {kind}"
    return Place(said, named(_of_part(part, checks[0])))


def _of_part(part: Part, check: Check) -> Lexicon:
    limit = part.endurance if check.kind == "endurance" else part.strength
    assert limit is not None
    return {
        "N": Given(check.force / KILO, "kN", tr("force in the part")),
        "A": Given(1e4 * part.area, "cm^2", tr("section of the part")),
        "sigma": Given(check.stress / MEGA, "MPa", tr("stress of the part")),
        "sigma_0": Given(limit / MEGA, "MPa", tr("limit stress of the material")),
        "sigma_a": Given(check.allowed / MEGA, "MPa", tr("allowed stress")),
        "K_1": Given(check.importance, "", tr("factor of the importance of the mechanism")),
        "K_2": Given(check.duty, "", tr("factor of its duty")),
        "K_m": Given(check.margin, "", tr("factor of both")),
        "K_n": Given(check.making, "", tr("factor of how the part is made")),
    }


def _checked(result: Transloader) -> Table:
    """All stresses beside what is allowed, also by the other factor."""
    other = "$K_1*K_2$" if result.factors == "sum" else "$K_1 + K_2$"
    both = {each.part for each in result.checks if each.kind == "endurance"}
    rows = tuple(
        (
            tr_name(each.part),
            f"{each.case}, {kind_of(each.kind)}" if each.part in both and each.case == "A" else each.case,
            *(f"${numeral(value)}$" for value in (each.stress / MEGA, each.allowed / MEGA, each.other / MEGA)),
            f"${numeral(100 * each.use, 4)}$",
            tr("yes") if each.holds else tr("no"),
        )
        for each in result.checks
    )
    stress = f"$sigma$, {tr_unit('MPa')}", f"$sigma_a$, {tr_unit('MPa')}"
    by_other = tr("$sigma_a$ by {factor}, MPa", factor=other)
    head = tr("Part"), tr("Case"), *stress, by_other, "$sigma$/$sigma_a$, %", tr("Kept")
    return Table(tr("Stresses beside what is allowed"), head, rows, "transloader_stresses")


def _worst(checks: Sequence[Check]) -> Iterator[Result]:
    """The most strained check of each part, and every one that fails."""
    for same in _alike(checks, "part"):
        worst = max(same, key=lambda each: each.use)
        for check in same:
            if check is worst or not check.holds:
                values = {"part": tr_name(check.part), "case": check.case, "kind": kind_of(check.kind)}
                given_ = Given(check.stress / MEGA, "MPa", tr("stress of the part"))
                allowed = max(check.allowed, check.stress) if check.holds else check.allowed
                said = tr("{part}, case {case}, {kind}", **values)
                yield Result("sigma", given_, allowed / MEGA, "<=", said)
