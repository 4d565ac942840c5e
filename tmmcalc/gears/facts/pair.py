"""The documents of the pair stage: what a project copies of each pair of gears, its checks, its sliding.

The order is that of the textbook: data, shifts, angles, centre distance, radii, quality.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import Any

from tmmcalc.gears.facts.meshes import known, places, titles, wheel_names
from tmmcalc.gears.facts.pair_checks import VERDICTS, checks_document, checks_values, pair_notes
from tmmcalc.gears.facts.pair_contact import NOISE
from tmmcalc.gears.facts.pair_facts import pair_facts
from tmmcalc.gears.meshing.results import Measures, MeshPair, Pairs, WheelSizes
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.sizes import drawn, plain

SHORT = ("pair", "shifts", "operating angle", "centre distance", "contact ratio", "measured", "verdict")  # of a summary
SIZES: tuple[tuple[str, str, Callable[[WheelSizes], float | None]], ...] = (
    ("reference radius", "r", lambda size: size.reference),
    ("operating pitch radius", "r_w", lambda size: size.operating),
    ("tip radius", "r_a", lambda size: size.tip),
    ("root radius", "r_f", lambda size: size.root),
    ("base radius", "r_b", lambda size: size.base),
    ("form radius: the involute ends", "r_F", lambda size: size.form),
    ("active radius: the contact ends", "r_p", lambda size: size.active),
    ("the same of the flanks left", "r_p_left", lambda size: size.active_left if _shorter(size) else None),
    ("radius where the flanks meet", "r_s", lambda size: size.pointing),
    ("tooth thickness, normal", "s_n", lambda size: size.thickness),
    ("tip thickness, normal", "s_na", lambda size: size.tip_thickness),
    ("curvature at the limit point", "LN", lambda size: size.limit),
)


MORE: tuple[tuple[str, Callable[[WheelSizes], float | None]], ...] = (  # for programs
    ("s_t[m]", lambda size: size.arc),
    ("s_ta[m]", lambda size: size.tip_arc),
    ("psi[rad]", lambda size: size.half_angle),
    ("psi_w[rad]", lambda size: size.operating_half_angle),
    ("z_min", lambda size: size.least_teeth),
    ("Y_F", lambda size: size.strength.factor if size.strength else None),
    ("s_Fn[m]", lambda size: size.strength.chord if size.strength else None),
    ("h_F[m]", lambda size: size.strength.arm if size.strength else None),
)


def _shorter(size: WheelSizes) -> bool:
    """Whether the contact ends earlier than the whole flanks would let it."""
    return abs(size.active_left - size.active) > NOISE * size.base


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
    from tmmcalc.gears.meshing.slidingtable import sliding_steps

    columns = sliding_columns(found, sliding_steps(found, step))
    legend = "rho1 = N1K, s from P; active: whether the flanks touch there"
    view = drawn({header: column for header, column in columns.items() if header != "pair"})
    return Document("sliding", (Fact("in the table", legend),), (), view)


def _whole(found: MeshPair, title: str) -> Document:
    """A pair for programs: wheels and checks as values."""
    sizes = zip(found.task.wheels, found.sizes, found.measures, strict=False)
    turn = abs(found.turn)  # of the arcs r gamma (4.74)
    values = {
        "wheels": {
            name: {**_wheel_values(size, measures), "r_gamma[m]": turn * size.reference}
            for name, size, measures in sizes
        },
        "checks": checks_values(found),
    }
    return Document(title, (*pair_facts(found), Fact("wheels and checks", "", values)), tuple(pair_notes(found)))


def _train_facts(result: Pairs) -> Iterator[Fact]:
    if result.train:
        yield Fact("meshes of", result.train, {"train": result.train})


def _remarks(result: Pairs) -> Iterator[str]:
    for remark in result.remarks:
        yield f"note: {remark}"


def _all_notes(result: Pairs) -> Iterator[str]:
    """The notes of all pairs, each with its pair where there are several."""
    for found, title in zip(result.pairs, titles(result), strict=True):
        for note in pair_notes(found):
            kind, _, text = note.partition(": ")
            yield note if len(result.pairs) == 1 else f"{kind}: {found.task.name or title}: {text}"


def _wheels_view(found: MeshPair) -> View:
    """Sizes down the page, wheels across it."""
    rows = [(label, symbol, [read(size) for size in found.sizes]) for label, symbol, read in SIZES]
    rows = [row for row in rows if any(value is not None for value in row[2])]
    columns: list[Sequence[Any]] = [[row[0] for row in rows], [row[1] for row in rows]]
    for k in range(len(found.sizes)):
        columns.append([_length(row[2][k]) for row in rows])
    return View(["size", "symbol", *(f"{name}[mm]" for name in wheel_names(found))], columns)


def _length(value: float | None) -> float | str:
    return "" if value is None else 1e3 * value


def _wheel_values(size: WheelSizes, measures: Measures) -> dict[str, Any]:
    """A wheel for programs."""
    values: dict[str, Any] = {"kind": size.kind, "z": size.teeth, "x": size.shift, "x_min": size.least_shift}
    values |= {f"{symbol}[m]": read(size) for _, symbol, read in SIZES}
    values |= {key: get(size) for key, get in MORE}
    if size.kind != "ring":
        values["z_w_max"] = measures.span_most
    if measures.span is not None:
        values |= {"z_w": measures.span.teeth, "W[m]": measures.span.length}
    if measures.balls is not None:
        values |= {"D[m]": measures.balls.diameter, "M[m]": measures.balls.size}
    return known(values)


def _rows_view(result: Pairs) -> View:
    """One row a pair."""
    columns: dict[str, list[Any]] = {
        "pair": titles(result),
        "x_1": [round(found.shifts[0], 4) for found in result.pairs],
        "x_2": ["" if found.task.kind == "rack" else round(found.shifts[1], 4) for found in result.pairs],
        "a_w[mm]": [1e3 * found.distance for found in result.pairs],
        "alpha_tw[deg]": [round(math.degrees(found.angle_w), 4) for found in result.pairs],
        "eps_alpha": [round(found.shortened, 4) for found in result.pairs],
        "verdict": [VERDICTS[found.verdict] for found in result.pairs],
    }
    return View(list(columns), list(columns.values()))
