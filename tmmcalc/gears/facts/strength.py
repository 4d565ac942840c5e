"""The documents of the strength stage: torque, coefficients with their sources, modules and widths of all sets."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.core.notes import Phrase
from tmmcalc.core.quantity import keyed, quantities
from tmmcalc.gears.sizing import MOMENT, REDUCTION, Sized, Sizing
from tmmcalc.gears.strength.columns import OUTCOMES, sized_columns, stacked
from tmmcalc.gears.strength.endurance import Coefficient
from tmmcalc.gears.strength.explain import SPREADS, coefficients, real_width, reason, remarks
from tmmcalc.gears.strength.results import Strength
from tmmcalc.gears.strength.series import Outcome
from tmmcalc.gears.strength.solve import NARROWEST, WIDEST
from tmmcalc.report.document import Document, Fact
from tmmcalc.report.numbers import number
from tmmcalc.report.sizes import drawn, lengths, plain, quantity

ROWS, FEW = 20, 5  # rows of the table; of the summary of a whole run
CHECKED = (  # what a check shows first
    *("contact_stress", "permissible_contact", "contact_margin"),
    *("bending_stress", "permissible_bending", "bending_margin"),
    *("module", "width"),
)
LAST = ("m_H", "m_F", "governs", "psi", "sigma", "margin", "K_")  # columns that stand behind modules, widths, outcome

WHENCE = {MOMENT: "of the moment that is given", REDUCTION: "of the largest reduced moment"}


def summary(result: Sizing, title: str) -> Document:
    """Facts, notes and the first few sets of every variant."""
    return document(result, title, rows=FEW)


def document(result: Sizing, title: str, *, rows: int = ROWS, everything: bool = False) -> Document:
    """Facts, notes and the first ``rows`` sets of every variant; with ``everything`` all sets in one table instead."""
    before = np.cumsum([0, *(len(sized.sets) for sized in result.variants)]).tolist()
    shown = 0 if everything else rows
    parts = tuple(_variant_document(*each, shown) for each in zip(result.variants, before[:-1], strict=True))
    document = replace(parts[0], title=title) if len(parts) == 1 else Document(title, parts=parts)
    return replace(document, table=plain(stacked(result))) if everything else document


def train_document(result: Sizing, title: str, row: int) -> Document:
    """Every coefficient of one set, its outcome and what is unusual; rows count from 1.

    Raises `UsageError` if there is no such row.
    """
    count = sum(len(sized.sets) for sized in result.variants)
    at = row - 1 if row >= 1 else count
    for sized in result.variants:
        if at < len(sized.sets):
            return _one_document(sized, f"{title}, row {row}", at)
        at -= len(sized.sets)
    raise UsageError(
        f"there is no row {row}: {count} sets are sized",
        where="--train",
        value=row,
        limit=count,
        remedy=f"1 to {count}, as in strength.csv",
    )


def _one_document(sized: Sized, title: str, at: int) -> Document:
    found, told = sized.strength, quantities(Strength)
    teeth = "/".join(map(str, sized.sets.teeth[at].tolist()))
    facts = [
        Fact("train", f"{sized.title}: {teeth}", {"layout": sized.sets.layout, "teeth": sized.sets.teeth[at].tolist()}),
        Fact("outcome", reason(found, at), {"accepted": bool(found.accepted[at])}),
        Fact("modules", lengths(found.module[at].tolist()), {told["module"].key: found.module[at].tolist()}),
        Fact("face widths", lengths(found.width[at].tolist()), {told["width"].key: found.width[at].tolist()}),
        *stress_facts(found, at),
        *coefficient_facts(coefficients(sized.sets, sized.task, at)),
    ]
    return Document(title, tuple(facts), tuple(remark.note for remark in remarks(found, at)))


def stress_facts(found: Strength, at: int) -> Iterator[Fact]:
    """Stresses of all stages beside the permissible ones, with the unused part of these."""
    told = quantities(Strength)
    for kind in ("contact", "bending"):
        names = (f"{kind}_stress", f"permissible_{kind}", f"{kind}_margin")
        stress, permissible, margin = (getattr(found, name) for name in names)
        lines = [
            f"stage {k + 1}: {quantity(stress[at, k], 'Pa')}, permissible {quantity(permissible[at, k], 'Pa')}, "
            f"margin {number(100 * margin[at, k], 4)} %"
            for k in range(stress.shape[1])
        ]
        values = {told[name].key: getattr(found, name)[at].tolist() for name in names}
        yield Fact(f"{kind} stress", "\n".join(lines), values)


def _variant_document(sized: Sized, before: int, rows: int) -> Document:
    told = sized.strength.coefficients
    if real_width(sized.task):  # each train has its own
        told = tuple(each for each in told if each.symbol not in SPREADS)
    facts = (_torque_fact(sized), *_count_facts(sized), *coefficient_facts(told))
    shown = _by_stages if sized.strength.checked else _ordered
    view = drawn(shown(sized, before, rows)) if rows and len(sized.sets) else None
    more = "--format csv prints all of them"
    return Document(sized.title, facts, tuple(_notes(sized)), view, wide=True, more=more)


def _torque_fact(sized: Sized) -> Fact:
    torque = sized.torque
    values = keyed(torque, "value", "source")
    text = f"{number(torque.value)} N*m, as given"
    if torque.moment is not None and torque.ratio is not None:
        values |= keyed(torque, "moment", "ratio")
        text = f"{number(torque.value)} N*m = {number(torque.moment)} N*m / {number(torque.ratio)}, "
        text += WHENCE[torque.source]
        if sized.beyond != 1:
            to_output = number(torque.ratio / sized.beyond)
            text += (
                f"\nratio to the crank {number(torque.ratio)} = {to_output} of the train times {number(sized.beyond)}"
            )
    return Fact("torque on wheel 1", text, values)


def _count_facts(sized: Sized) -> Iterator[Fact]:
    """How many sets there are, how many are strong enough, and why the others are not."""
    found, held = sized.strength, len(sized.sets)
    values = keyed(sized, "count") | {"sized": held}
    text = f"{sized.count}" if held == sized.count else f"{sized.count}, the first {held} of them sized"
    yield Fact("tooth sets", text if sized.count else "none", values)
    if not held:
        return
    strong = int(np.count_nonzero(found.accepted))
    rejected = Counter(found.outcome[~found.accepted].tolist())
    words = {OUTCOMES[Outcome(outcome)]: number for outcome, number in sorted(rejected.items())}
    yield Fact("strong enough", f"{strong} of {held}", {"accepted": strong, "rejected": words})
    for outcome, times in sorted(rejected.items()):
        at = int(np.flatnonzero(found.outcome == outcome)[0])
        teeth = "/".join(map(str, sized.sets.teeth[at].tolist()))
        yield Fact(f"- {OUTCOMES[Outcome(outcome)]}", f"{times}, first {teeth}: {reason(found, at)}")


def coefficient_facts(listed: Sequence[Coefficient]) -> Iterator[Fact]:
    """Coefficients with their sources; wheels that have the same ones are told together."""
    told: dict[tuple[tuple[str, float, str, str], ...], list[str]] = {}
    for of in dict.fromkeys(each.of for each in listed):
        own = tuple((each.symbol, each.value, each.unit, each.source) for each in listed if each.of == of)
        told.setdefault(own, []).append(of)
    values = {"coefficients": [keyed(each) for each in listed]}
    for own, places in told.items():
        lines = [f"{symbol} = {quantity(value, unit)}: {source}" for symbol, value, unit, source in own]
        yield Fact(together(places), "\n".join(lines), values)
        values = {}


def together(places: Sequence[str]) -> str:
    """``wheels 1, 2, 3`` for several of one kind.

    >>> together(["wheel 1", "wheel 2'"]), together(["stage 1"])
    ("wheels 1, 2'", 'stage 1')
    """
    if len(places) == 1:
        return places[0]
    kind = places[0].partition(" ")[0]
    return f"{kind}s {', '.join(place.partition(' ')[2] for place in places)}"


def _ordered(sized: Sized, before: int, rows: int) -> dict[str, np.ndarray]:
    """The first rows, numbered after ``before`` ones of earlier variants; what a reader asks for first in front."""
    columns = {
        header: column[:rows] for header, column in sized_columns(sized).items() if header not in ("layout", "K")
    }
    headers = sorted(columns, key=lambda header: header.startswith(LAST))
    numbers = np.arange(before + 1, before + 1 + min(rows, len(sized.sets)))
    return {"i": numbers, **{header: columns[header] for header in headers}}


def _by_stages(sized: Sized, before: int, rows: int) -> dict[str, np.ndarray]:
    """Stresses, permissible ones and margins of the first sets, one row a stage k: so all of them fit on a page."""
    found, stages, told = sized.strength, sized.sets.scheme.stages, quantities(Strength)
    count = min(rows, len(sized.sets))
    teeth = ["/".join(map(str, numbers)) for numbers in sized.sets.teeth[:count].tolist()]
    shown = {
        "i": np.repeat(np.arange(before + 1, before + 1 + count), stages),
        "z": np.repeat(np.array(teeth), stages),
        "k": np.tile(np.arange(1, stages + 1), count),
    }
    for name in CHECKED:
        each, header = getattr(found, name)[:count].ravel(), told[name].heading.replace("_{stage}", "")
        if told[name].unit:
            shown[header] = each
        else:
            shown[f"{header}[%]"] = np.round(100 * each, 2)
    return {**shown, "outcome": np.repeat(sized_columns(sized)["outcome"][:count], stages)}


def _notes(sized: Sized) -> Iterator[str]:
    """Warnings of materials, and how many trains have unusual widths."""
    found = sized.strength
    for warning in found.warnings:
        yield warning.within(sized.title)
    unusual = int(np.count_nonzero(found.width_unusual.any(axis=1)))
    if unusual:
        yield Phrase(
            "note: b/m is outside {narrowest:g} to {widest:g} in {unusual} of {sets} trains",
            narrowest=NARROWEST,
            widest=WIDEST,
            unusual=unusual,
            sets=len(sized.sets),
        )
    few = int(np.count_nonzero(found.few_teeth))
    if few:
        yield Phrase("note: {few} trains have wheels with fewer teeth than the fit of Y_F holds for", few=few)
