"""The conditions of a tooth set: each side worked out, whether it holds; then all of them in a table."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import groupby
from typing import NamedTuple

from tmmcalc.gears.advice import called
from tmmcalc.gears.chosen.choice import Chosen
from tmmcalc.gears.chosen.condition import Condition
from tmmcalc.gears.chosen.conditions import conditions
from tmmcalc.gears.columns import ratios
from tmmcalc.gears.notes.letters import asked_ratio, joined, letter, noted
from tmmcalc.gears.pictures.words import KINDS, counted
from tmmcalc.report.formula.digits import Given, significant
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.formula.tree import Call, Name, Number
from tmmcalc.report.language import tr, tr_name
from tmmcalc.report.manuscript import Block, Display, Heading, Lexicon, Paragraph, Place, Table
from tmmcalc.report.telling import lines, named

SHOWN = 6  # digits of the sides
PLANETS = "planets "  # before the wheel that a condition of neighbours is of


class Side(NamedTuple):
    """The name of one side of a condition."""

    name: str
    meaning: str


def told_conditions(chosen: Chosen, key: str) -> Iterator[Block]:
    """Every condition; ``key`` that of the table of all of them."""
    found = conditions(chosen).conditions
    yield Heading(tr("Conditions on the numbers of teeth"), 3)
    lexicon: Lexicon = {}
    for name, group in groupby(found, lambda each: each.name):
        own = list(group)
        lead = _lead(name, chosen)
        if lead:
            yield Paragraph(lead)
            yield from _worked(own, lexicon, chosen)
        if name == "ratio":
            yield from _error(chosen, lexicon)
    yield Paragraph(tr("All conditions are listed in table {tab}.", tab=f"{{tab:{key}}}"))
    yield _table(found, key)


def _lead(name: str, chosen: Chosen) -> str:
    """What a condition says; empty of those that the table alone tells."""
    parallel = counted(chosen.sets.scheme, chosen.sets.planets)
    leads = {
        "ratio": tr("The ratio with these numbers of teeth lies within its tolerance."),
        "coaxiality": tr("Coaxiality: meshes between the same axes have equal centre distances."),
        "assembly": tr(
            "Assembly: {planets} at equal angles fit in if this number is whole.",
            planets=parallel,
        ),
        "adjacency": tr("Neighbours: the tips of neighbouring wheels 2 keep clear of each other.")
        if not chosen.sets.scheme.planetary
        else tr("Neighbours: the tips of neighbouring planets keep clear of each other."),
        "interference": tr("No interference: the ring has enough teeth more than the wheel in it."),
        "undercut": tr("No undercut: the least number of teeth is not below that which the rack does not undercut."),
        "stage_ratio": tr("The ratio of each stage is within its limit."),
        "diameter_band": tr("Wheels of neighbouring stages are of nearly equal diameter, to dip alike into the oil."),
    }
    return leads.get(name, "")


def _worked(own: list[Condition], lexicon: Lexicon, chosen: Chosen) -> Iterator[Block]:
    """Both sides of each condition as lines, where there is something to compute, and the verdict."""
    told: set[str] = set()
    judged: set[tuple[float, str, float]] = set()
    for k, each in enumerate(own):
        left, right = _texts(each)
        names = _left(each, len(own), k), _right(each)
        if names[0] is not None and names[1] is not None and names[0].name not in told:
            yield Display(read(f"{left} {each.relation} {right}"))
        lexicon |= _letters(each, chosen)
        for side, text, value in ((names[0], left, each.left), (names[1], right, each.right)):
            if side is not None and side.name not in told:
                told.add(side.name)
                lexicon |= named({side.name: Given(value, "", side.meaning)})
                yield from lines([f"{side.name} = {text}"], [Place("", lexicon)])
        if (sides := (each.left, each.relation, each.right)) not in judged:
            judged.add(sides)
            yield Paragraph(_verdict(each))


def _error(chosen: Chosen, lexicon: Lexicon) -> Iterator[Block]:
    """The deviation of the ratio from the one that is asked for."""
    request = chosen.request
    assert request is not None
    kind, asked = KINDS[request.kind], asked_ratio(request.kind)
    error = 100 * float(ratios(request, chosen.sets)[1][0])
    lexicon |= named(
        {
            asked: Given(float(request.nominal), "", tr("ratio that is asked for")),
            "delta": Given(error, "%", tr("error of the ratio")),
        }
    )
    yield from lines([f"delta = 100*({kind} - {asked})/{asked}"], [Place("", lexicon)])


def _texts(each: Condition) -> tuple[str, str]:
    """Both sides in letters."""
    left, right = each.formula.split(f" {each.relation} ")
    return noted(left), noted(right)


def _computed(text: str) -> bool:
    """Whether a side is more than a letter, a number, or the least of several."""
    side = read(text).sides[0]
    return not (isinstance(side, Name | Number) or (isinstance(side, Call) and side.function in ("min", "max")))


def _left(each: Condition, several: int, k: int) -> Side | None:
    """The name of the left side; None where it is none of its own."""
    of = each.of.removeprefix(PLANETS)
    if not _computed(_texts(each)[0]):
        return None
    match each.name:
        case "ratio":
            return Side(KINDS[each.of], tr("ratio of the train"))
        case "coaxiality":
            return Side(f"A_{{{_axes(of.split(', ')[:-1])}}}", _distance())
        case "assembly":
            return Side("R" if several == 1 else f"R_{k + 1}", tr("number of the assembly condition"))
        case "adjacency":
            said = tr("distance of the axes of neighbouring wheels {wheel}, in modules", wheel=of)
            return Side(f"C_{{{of}}}", said)
        case "interference":
            return Side(f"Deltaz_{{{joined(of.split('-'))}}}", tr("difference of the teeth of the ring and its wheel"))
        case "stage_ratio":
            return Side(f"u_{{{joined(of.split('-'))}}}", tr("ratio of the pair {pair}", pair=of.replace("-", "–")))
        case "diameter_band":
            said = tr("relative difference of the diameters of wheels {wheels}", wheels=of)
            return Side(f"delta_{{{joined(of.split(', '))}}}", said)
    return None


def _right(each: Condition) -> Side | None:
    """The name of the right side."""
    of = each.of.removeprefix(PLANETS)
    match each.name:
        case "coaxiality":
            return Side(f"A_{{{_axes(of.split(', ')[-1:])}}}", _distance())
        case "adjacency":
            said = tr("room across that wheel {wheel} needs, in modules", wheel=of)
            return Side(f"G_{{{of}}}", said)
        case "undercut":
            return Side("z_{0}", tr("least number of teeth without undercut"))
    return None


def _axes(meshes: list[str]) -> str:
    """The first and the last wheel of meshes that follow each other, as an index."""
    return joined((meshes[0].split("-")[0], meshes[-1].split("-")[1]))


def _distance() -> str:
    return tr("doubled distance of the axes, in units of the common measure of the modules")


def _verdict(each: Condition) -> str:
    left, right = _values(each)
    if each.kept and each.name == "assembly":
        return tr("${left}$ is a whole number: the condition holds.", left=left)
    if each.kept:
        return tr("${sides}$: the condition holds.", sides=f"{left} {each.relation} {right}")
    return tr("The left side is ${left}$, the right one ${right}$: the condition fails.", left=left, right=right)


def _values(each: Condition) -> tuple[str, str]:
    """Both sides as they are printed, angles in degrees."""
    if each.name == "mesh_angles":
        left, right = (significant(math.degrees(value), SHOWN) for value in (each.left, each.right))
        return f"deg({left})", f"deg({right})"
    return significant(each.left, SHOWN), significant(each.right, SHOWN)


def _letters(each: Condition, chosen: Chosen) -> Lexicon:
    """The quantities that stand in a condition."""
    found: Lexicon = {}
    for name, value in each.letters.items():
        angle = name.startswith("alpha")
        found[letter(name)] = Given(math.degrees(value) if angle else float(value), "deg" if angle else "", "")
    found |= {name: given._replace(meaning=_meaning(name, chosen)) for name, given in found.items()}
    return named(found)


def _meaning(name: str, chosen: Chosen) -> str:
    """What a letter of the conditions is."""
    if name.startswith("z_{") and name[3:-1] in chosen.teeth:
        return tr("number of teeth of wheel {wheel}", wheel=name[3:-1])
    if name.startswith("mu_"):
        return tr("proportion of the modules of the stages in lowest terms")
    if name.startswith("alpha_{w"):
        pairs = {f"{mesh.first}{mesh.second}": f"{mesh.first}–{mesh.second}" for mesh in chosen.sets.scheme.meshes}
        return tr("operating pressure angle of the pair {pair}", pair=pairs[name[8:-1]])
    return {
        "alpha": tr("profile angle of the rack"),
        "h_a^{*}": tr("addendum coefficient"),
        "c_g": tr("least gap between the tips of neighbours, in modules"),
        "K": tr("number of planets") if chosen.sets.scheme.planetary else tr("number of layshafts"),
    }.get(name, "")


def _table(found: tuple[Condition, ...], key: str) -> Table:
    """All conditions with both sides and their verdicts; those that are good custom in brackets."""
    head = (tr("Condition"), tr("Wheels"), tr("With numbers"), tr("Verdict"))
    return Table(tr("Conditions on the numbers of teeth"), head, tuple(dict.fromkeys(map(_row, found))), key)


def _row(each: Condition) -> tuple[str, ...]:
    numbers = _values(each)
    sides = f"${numbers[0]} {each.relation} {numbers[1]}$" if each.kept else f"${numbers[0]}$; ${numbers[1]}$"
    if each.kept and each.name == "assembly":
        sides = tr("${left}$ is whole", left=numbers[0])
    verdict = tr("kept") if each.kept else tr("not kept") if each.asked else tr("not recommended")
    name = tr("numbers of teeth") if each.name == "teeth" else tr_name(called(each.name))
    of = "" if each.name == "ratio" else each.of.removeprefix(PLANETS).replace("-", "–")
    return name, of, sides, verdict
