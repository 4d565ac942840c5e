"""The documents of one chosen train: conditions with both sides, Willis' equations, plans of velocities and speeds."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from tmmcalc.core.notes import Note, Phrase
from tmmcalc.core.quantity import Quantity, keyed, quantities, table
from tmmcalc.gears.advice import called
from tmmcalc.gears.chosen.condition import Condition, Conditions
from tmmcalc.gears.chosen.motion import Equations
from tmmcalc.gears.network.plans import PlanLine, PlanPoint, Plans
from tmmcalc.gears.network.willis import Willis
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.numbers import number

DIGITS, SHORT = 9, 6  # of ratios that a reader works out again; of both sides beside their formula
VELOCITIES, SPEEDS = "plan of velocities", "plan of speeds"


def conditions_document(found: Conditions, title: str, *, everything: bool = False) -> Document:
    """Every condition with the numbers of the set and both its sides; with ``everything`` all that is known of it."""
    rows = found.conditions
    kept = [each for each in rows if each.asked and each.kept]
    asked = sum(each.asked for each in rows)
    text = f"all {asked} that are asked for" if found.kept else f"{len(kept)} of {asked} that are asked for"
    facts = (Fact("kept", f"{text}; in brackets: not asked for", keyed(found)),)
    notes = tuple(
        Note(
            "warning",
            _broken(each),
            value=float(each.left),
            limit=float(each.right),
            name=each.name,
        )
        for each in rows
        if each.asked and not each.kept
    )
    if everything:
        return Document(title, facts, notes, _view(table(rows, Condition)))
    columns = {
        "condition": [called(each.name) for each in rows],
        "of": [each.of for each in rows],
        "with numbers": [each.numbers for each in rows],
        "sides": [_sides(each) for each in rows],
        "kept": [_kept(each) for each in rows],
    }
    return Document(title, facts, notes, _view(columns))


def _sides(each: Condition) -> str:
    return f"{number(each.left, SHORT)} {each.relation} {number(each.right, SHORT)}"


def _broken(each: Condition) -> str:
    """A condition that is not kept, with both sides."""
    text = {
        "=": "{condition} is not kept: {left}, not {right}",
        ">": "{condition} is not kept: {left}, not above {right}",
        ">=": "{condition} is not kept: {left}, below {right}",
        "<=": "{condition} is not kept: {left}, above {right}",
    }[each.relation]
    what = called(each.name)
    condition = Phrase("{condition} of {of}", condition=what, of=each.of) if each.of else what
    return Phrase(text, condition=condition, left=number(each.left, SHORT), right=number(each.right, SHORT))


def _kept(each: Condition) -> str:
    word = "yes" if each.kept else "no"
    return word if each.asked else f"({word})"


def willis_document(found: Equations, title: str, *, everything: bool = False) -> Document:
    """Every equation in letters and with numbers; with ``everything`` as a table."""
    values: dict[str, Any] = {quantities(Equations)["speeds"].key: dict(zip(found.members, found.speeds, strict=True))}
    speeds = Fact("speeds", "in the equations in rad/s, with their signs", values)
    if everything:
        columns = table(found.equations, Willis)
        path, held = (quantities(Willis)[name].key for name in ("path", "held"))
        columns[path] = [" > ".join(names) for names in columns[path]]
        columns[held] = ["" if value is None else value for value in columns[held]]
        return Document(title, (speeds,), (), _view(columns))
    return Document(title, (speeds, *map(_equation, found.equations)))


def _equation(each: Willis) -> Fact:
    lines = [each.formula, each.numbers]
    ratio = f"i = {each.exact}"
    lines.append(ratio if "/" not in each.exact else f"{ratio} = {number(each.inverted, DIGITS)}")
    if each.held is not None:
        lines.append(f"with {each.last} held {each.first} : {each.carrier} is 1 - i = {number(each.held, DIGITS)}")
    of = "fixed axes" if each.carrier == "frame" else f"carrier {each.carrier}"
    return Fact(f"{of}: {each.first}, {each.last}", "\n".join(lines))


def plans_document(found: Plans, title: str, *, everything: bool = False) -> Document:
    """Both plans: points with velocities, members with rays; with ``everything`` all in SI."""
    told = {name: each.key for name, each in quantities(Plans).items()}
    text = ", ".join(
        f"{key.partition('[')[0]} = {number(getattr(found, name))} {key.partition('[')[2].removesuffix(']')}"
        for name, key in told.items()
        if name.endswith("scale")
    )
    text += f"\npole {number(1e3 * found.pole)} mm from the line of speeds"
    facts = (Fact("scales", text, keyed(found)),)
    notes = (
        ()
        if found.assumed is None
        else (Phrase("note: no module is known: m_1 is {assumed} mm", assumed=number(1e3 * found.assumed)),)
    )
    parts = (
        Document(VELOCITIES, tuple(_legend(found)), (), _points(found, everything), wide=True),
        Document(SPEEDS, (), (), _lines(found, everything), wide=True),
    )
    return Document(title, facts, notes, parts=parts)


def _legend(found: Plans) -> Iterator[Fact]:
    yield Fact("in the table", "x along the line of centres, v across it; drawn: to the scales")
    if any(point.y for point in found.points):
        yield Fact("beside it", "y of planets beside the line of centres, of bevel planets the radius on the planet")


def _points(found: Plans, everything: bool) -> View:
    rows = found.points
    if everything:
        columns = table(rows, PlanPoint)
        names, radii = (quantities(PlanPoint)[name].key for name in ("members", "radii"))
        columns[names] = [", ".join(each) for each in columns[names]]
        both = columns.pop(radii)
        for k in (0, 1):
            columns[_of_wheel(k)] = ["" if each is None else each[k] for each in both]
        return _view(columns)
    beside = ("y[mm]",) if any(point.y for point in rows) else ()
    along = ("along",) if any(point.along for point in rows) else ()
    columns = {
        **table(rows, PlanPoint, "name"),
        quantities(PlanPoint)["members"].key: [", ".join(point.members) for point in rows],
        **table(rows, PlanPoint, "x[mm]", *beside, "velocity", *along, "drawn_x[mm]", "drawn_velocity[mm]"),
    }
    return _view(columns)


RADIUS = Quantity("r_w{wheel}[m]", "of a pitch point the operating radius of wheel {wheel}")


def _of_wheel(k: int) -> str:
    return RADIUS.of(wheel=k + 1).key


def _lines(found: Plans, everything: bool) -> View:
    if everything:
        columns = table(found.lines, PlanLine, *(name for name in quantities(PlanLine) if name != "turns"))
        return _view({key: ["" if value is None else value for value in column] for key, column in columns.items()})
    columns = table(
        found.lines, PlanLine, "member", "x[mm]", "axis_velocity", "speed", "turns", "slope[deg]", "ray[mm]"
    )
    centres = table(found.lines, PlanLine, "centre_x[mm]")
    return _view(columns | {key: ["" if v is None else v for v in column] for key, column in centres.items()})


def _view(columns: dict[str, Any]) -> View:
    return View(list(columns), list(columns.values()))
