"""The documents of the pair stage: what a project copies of each pair of gears, its checks, its sliding.

The order is that of the textbook: data, shifts, angles, centre distance, radii, quality.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

from tmmcalc.core.notes import Note, Phrase
from tmmcalc.core.quantity import Quantity, keyed, quantities, table
from tmmcalc.gears.facts.meshes import known, places, titles, wheel_names
from tmmcalc.gears.facts.pair_checks import VERDICTS, checks_document, checks_values, pair_notes
from tmmcalc.gears.facts.pair_facts import pair_facts
from tmmcalc.gears.layouts.open_pair import GEAR_NAME, PINION_NAME
from tmmcalc.gears.meshing.results import Measures, MeshPair, Pairs, WheelSizes
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.sizes import drawn, plain

FURTHER = ("tmmcalc.gears.facts.pair_facts",)  # where quantities stand, too
SHORT = ("pair", "shifts", "operating angle", "centre distance", "contact ratio", "measured", "verdict")  # of a summary
SIZES = (  # lengths, down the table
    *("reference", "operating", "tip", "root", "base", "form", "active", "active_shortened", "pointing"),
    *("thickness", "tip_thickness", "limit"),
)
ARC = Quantity("r_gamma[m]", "arc between the points of a flank on reference and operating circle", source="(4.74)")
ON_CRANK = (PINION_NAME, GEAR_NAME)  # wheels of the open pair, which are none of the train
MORE = ("arc", "tip_arc", "half_angle", "operating_half_angle", "least_teeth")  # for programs


def chosen_pairs(result: Pairs, name: str | None) -> Pairs:
    """The pair of a name alone, all for None; raises `UsageError` if there is none."""
    at = places([found.task.name for found in result.pairs], name, "pair")
    return replace(result, pairs=tuple(result.pairs[k] for k in at))


def summary(result: Pairs, title: str) -> Document:
    """The shifts of every pair and what they give, one row each; of a single pair its radii as well."""
    notes = (*_remarks(result), *_all_notes(result))
    if len(result.pairs) == 1:
        (found,) = result.pairs
        facts = tuple(fact for fact in pair_facts(found) if fact.label in SHORT)
        return Document(title, (*_train_facts(result), *facts), notes, _wheels_view(found))
    return Document(title, tuple(_train_facts(result)), notes, _rows_view(result))


def document(result: Pairs, title: str, *, everything: bool = False, step: float | None = None) -> Document:
    """All of every pair; with ``everything`` every digit and the sliding of all pairs in one table instead.

    With a ``step`` [m] the sliding is tabulated in equal steps of rho1; raises as `sliding_steps` does.
    """
    each = zip(result.pairs, titles(result), strict=True)
    parts = tuple(_whole(*named) if everything else _part(*named, step) for named in each)
    if len(parts) == 1:
        facts, notes = (*_train_facts(result), *parts[0].facts), (*_remarks(result), *parts[0].notes)
        document = replace(parts[0], title=title, facts=facts, notes=notes)
    else:
        document = Document(title, tuple(_train_facts(result)), tuple(_remarks(result)), parts=parts)
    if everything:
        from tmmcalc.gears.meshing.columns import pair_columns

        return replace(document, table=plain(pair_columns(result, step)))
    return document


def _part(found: MeshPair, title: str, step: float | None) -> Document:
    parts = (checks_document(found),) if step is None else (checks_document(found), _sliding_document(found, step))
    return Document(title, tuple(pair_facts(found)), tuple(pair_notes(found)), _wheels_view(found), parts=parts)


def _sliding_document(found: MeshPair, step: float) -> Document:
    """theta and lambda in equal steps, as program 1.15 prints them."""
    from tmmcalc.gears.meshing.columns import sliding_columns
    from tmmcalc.gears.meshing.sliding import sliding_steps

    columns = sliding_columns(found, sliding_steps(found, step))
    legend = "rho1 = N1K, s from P; active: whether the flanks touch there"
    view = drawn({header: column for header, column in columns.items() if header != "pair"})
    return Document("sliding", (Fact("in the table", legend),), (), view)


def _whole(found: MeshPair, title: str) -> Document:
    """A pair for programs: wheels and checks as values."""
    sizes = zip(found.task.wheels, found.sizes, found.measures, strict=False)
    turn = abs(found.turn)
    values = {
        "wheels": {
            name: {**_wheel_values(size, measures), ARC.key: turn * size.reference} for name, size, measures in sizes
        },
        "checks": checks_values(found),
    }
    return Document(title, (*pair_facts(found), Fact("wheels and checks", "", values)), tuple(pair_notes(found)))


def _train_facts(result: Pairs) -> Iterator[Fact]:
    if result.train and any(found.task.wheels != ON_CRANK for found in result.pairs):
        yield Fact("meshes of", result.train, {"train": result.train})


def _remarks(result: Pairs) -> Iterator[str]:
    for remark in result.remarks:
        yield Phrase("note: {remark}", remark=remark)


def _all_notes(result: Pairs) -> Iterator[Note]:
    """The notes of all pairs, each with its pair where there are several."""
    for found, title in zip(result.pairs, titles(result), strict=True):
        for note in pair_notes(found):
            yield note if len(result.pairs) == 1 else note.within(found.task.name or title)


def _wheels_view(found: MeshPair) -> View:
    """Sizes down the page, wheels across it."""
    told = quantities(WheelSizes)
    rows = [(told[name], [getattr(size, name) for size in found.sizes]) for name in SIZES]
    rows = [row for row in rows if any(value is not None for value in row[1])]
    columns: list[Sequence[Any]] = [[size.meaning for size, _ in rows], [size.name for size, _ in rows]]
    for k in range(len(found.sizes)):
        columns.append([length_cell(values[k]) for _, values in rows])
    return View(["size", "symbol", *(f"{name}[mm]" for name in wheel_names(found))], columns)


def length_cell(value: float | None) -> float | str:
    """A length in millimetres, empty if there is none."""
    return "" if value is None else 1e3 * value


def _wheel_values(size: WheelSizes, measures: Measures) -> dict[str, Any]:
    """A wheel for programs."""
    values = keyed(size, "kind", "teeth", "shift", "least_shift", *SIZES, *MORE)
    if size.strength is not None:
        values |= keyed(size.strength)
    if size.kind != "ring":
        values |= keyed(measures, "span_most")
    if measures.span is not None:
        values |= keyed(measures.span, "teeth", "length")
    if measures.balls is not None:
        values |= keyed(measures.balls, "diameter", "size")
    return known(values)


def _rows_view(result: Pairs) -> View:
    """One row a pair."""
    shift = quantities(MeshPair)["shifts"]
    rounded = table(result.pairs, MeshPair, "angle_w[deg]", "shortened")
    columns: dict[str, list[Any]] = {
        "pair": titles(result),
        shift.of(wheel=1).key: [round(found.shifts[0], 4) for found in result.pairs],
        shift.of(wheel=2).key: [
            "" if found.task.kind == "rack" else round(found.shifts[1], 4) for found in result.pairs
        ],
        **table(result.pairs, MeshPair, "distance[mm]"),
        **{header: [round(value, 4) for value in values] for header, values in rounded.items()},
        "verdict": [VERDICTS[found.verdict] for found in result.pairs],
    }
    return View(list(columns), list(columns.values()))
