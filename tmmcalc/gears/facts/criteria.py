"""The documents of the criteria stage: the best gear train and why, minima, Pareto front, comparisons."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from tmmcalc.core.notes import Note, Phrase, held
from tmmcalc.core.quantity import Quantity, keyed, quantity_of
from tmmcalc.gears.criteria.choice import Reason
from tmmcalc.gears.criteria.comparison import Comparison
from tmmcalc.gears.criteria.evaluate import Assumptions
from tmmcalc.gears.criteria.objectives import OBJECTIVES
from tmmcalc.gears.selection.columns import YES, chosen_columns, pair_columns
from tmmcalc.gears.selection.results import Guide, Selection, SeriesChoice, Weighed, Winner
from tmmcalc.gears.selection.series import SERIES
from tmmcalc.gears.selection.task import ROW, WEIGHTED
from tmmcalc.report.document import Document, Fact
from tmmcalc.report.numbers import number
from tmmcalc.report.sizes import drawn, lengths, plain, quantity

ROWS, FEW = 20, 5  # rows of the table; of the summary of a whole run
BEST = 3  # trains of the ranking that are named
DIGITS = 5

CRITERION = Quantity("{criterion}[{unit}]", "criterion of a train")
RATIO = Quantity("ratio", "ratio of the best train")
RATIO_EXACT = Quantity("ratio_exact", "ratio of the best train, exactly")
LEFT = Quantity("left", "sets that are left")
EXTREME = Quantity("best_{criterion}[{unit}]", "best value among all trains: {criterion}")
EXTREME_ROW = Quantity("best_{criterion}_row", "row of the best value among all trains: {criterion}")


def summary(result: Selection, title: str) -> Document:
    """Facts, notes and the first trains of the Pareto front."""
    return document(result, title, rows=FEW)


def document(result: Selection, title: str, *, rows: int = ROWS, everything: bool = False) -> Document:
    """Facts, notes and the Pareto front, the best by the choice first; with ``everything`` all trains instead."""
    columns = chosen_columns(result)
    facts = (
        *(_variant_fact(each) for each in result.variants),
        *_winner_facts(result),
        *_minimum_facts(result, columns),
        _front_fact(result, rows),
        _ranking_fact(result, columns),
        *_comparison_facts("planets", result.by_planets),
        *_comparison_facts("layouts", result.by_layouts),
        *(fact for guide in result.guides for fact in _guide_facts(result, guide)),
        *(() if result.pairs is None else _pair_facts(result.pairs)),
    )
    whole = {**columns, "front": columns["front"] == YES}
    view = plain(whole) if everything else drawn(_front_rows(result, columns, rows))
    more = "--format csv prints all trains and columns"
    parts = () if result.pairs is None or everything else tuple(_pair_documents(result.pairs, rows))
    return Document(title, facts, tuple(_notes(result)), view, wide=True, more=more, parts=parts)


def _value(key: str, value: float) -> str:
    """A criterion with its unit, a part as per cent.

    >>> _value("inertia", 3.173144), _value("size", 0.594), _value("error", 0.0057444)
    ('3.1731 kg*m^2', '594 mm', '0.57444 %')
    """
    if key in ("efficiency", "error"):
        return f"{number(100 * value, DIGITS)} %"
    return quantity(value, OBJECTIVES[key].unit, DIGITS)


def _key(criterion: str, told: Quantity = CRITERION) -> str:
    """The key of a criterion for programs."""
    return told.of(criterion=criterion, unit=OBJECTIVES[criterion].unit.removesuffix("-")).key


def _called(key: str) -> str:
    return key.replace("_", " ")


def _variant_fact(each: Weighed) -> Fact:
    """How many sets are left of a variant, and what the others lack."""
    left = len(each.sets)
    lacks = [f"{each.weak} are not strong enough"] if each.weak else []
    lacks += [f"{each.locking} lock themselves"] if each.locking else []
    lacks += [f"constraint {name} removed {count}" for name, count in each.refused.items() if count]
    text = "; ".join([f"{left} of {each.sized} tooth sets", *lacks]) if each.sized else "no tooth sets"
    key = each.title.replace(" ", "_")
    values = keyed(each, "sized") | LEFT.value(left) | keyed(each, "weak", "locking")
    return Fact(each.title, text, {key: values | ({"removed": each.refused} if each.refused else {})})


def _winner_facts(result: Selection) -> Iterator[Fact]:
    best = result.winner
    values = keyed(best, "name") | {"winner_row": best.place + 1}
    values |= keyed(best, "layout", "planets", "teeth", "modules", "widths")
    text = f"{best.title}: {'/'.join(map(str, best.teeth))} (row {best.place + 1})\n"
    text += f"m = {lengths(best.modules)}, b = {lengths(best.widths)}"
    yield Fact("best train", text, values)
    yield Fact("because", _because(result), {"choose": result.choose})
    criteria = [f"{_called(key)} {_value(key, best.values[key])}" for key in OBJECTIVES if key != "width_deviation"]
    yield Fact("its criteria", ", ".join(criteria), {_key(key): best.values[key] for key in OBJECTIVES})
    exact = f" = {best.ratio}" if best.ratio.denominator > 1 else ""
    values = {**RATIO.value(float(best.ratio)), **RATIO_EXACT.value(str(best.ratio))}
    yield Fact("its ratio", f"{number(float(best.ratio), 10)}{exact}", values)
    text = f"{number(best.inertia)} kg*m^2 on its output shaft"
    if best.beyond != 1:
        text += f", {number(best.on_crank)} kg*m^2 on the crank, which turns {number(1 / best.beyond)} times as fast"
    yield Fact("reduced inertia", text, keyed(best, "inertia", "on_crank"))


def _because(result: Selection) -> str:
    reason = result.reason
    if result.choose == ROW:
        return "it is the row that choose asks for"
    if result.choose == WEIGHTED:
        weights = ", ".join(f"{_called(key)} {number(share, 3)}" for key, share in result.ranking.weights.items())
        text = f"its weighted sum is the least, {number(reason.value, 4)} (weights: {weights})"
    else:
        text = f"its {_called(result.choose)} is the {_extreme(result.choose)}, {_value(result.choose, reason.value)}"
    if reason.runner_up is None or reason.runner_up_value is None:
        return f"{text}; there is no other train"
    value = reason.runner_up_value
    second = number(value, 4) if result.choose == WEIGHTED else _value(result.choose, value)
    ties = f"; {reason.tied} more {'is' if reason.tied == 1 else 'are'} as good" if reason.tied else ""
    return f"{text}; next {second} (row {reason.runner_up + 1}){ties}"


def _extreme(key: str) -> str:
    return "largest" if OBJECTIVES[key].largest else "least"


def _minimum_facts(result: Selection, columns: dict[str, np.ndarray]) -> Iterator[Fact]:
    for reason in result.minima:
        key = reason.criterion
        text = f"{_value(key, reason.value)}: {_train(columns, reason.winner)}{_tied(reason)}"
        values = {_key(key, EXTREME): reason.value, EXTREME_ROW.of(criterion=key).key: reason.winner + 1}
        yield Fact(f"{_extreme(key)} {_called(key)}", text, values)


def _tied(reason: Reason) -> str:
    return f" and {reason.tied} more" if reason.tied else ""


def _train(columns: dict[str, np.ndarray], row: int) -> str:
    """Layout, planets, teeth and row of a train; rows are shown from 1."""
    teeth = [column[row] for header, column in columns.items() if header.startswith("z_")]
    numbers = "/".join(str(z) for z in teeth if str(z))
    planets = int(columns["K"][row])
    return f"{columns['layout'][row]}{f' K = {planets}' if planets > 1 else ''} {numbers} (row {row + 1})"


def _front_fact(result: Selection, rows: int) -> Fact:
    count = len(result.front)
    text = f"{count} of {len(result.ranking.order)} trains by {', '.join(map(_called, result.objectives))}"
    if count > rows:
        text += f"; the first {rows} are shown"
    return Fact("Pareto front", text, {"objectives": list(result.objectives), "front": (result.front + 1).tolist()})


def _ranking_fact(result: Selection, columns: dict[str, np.ndarray]) -> Fact:
    """The first trains by the weighted sum."""
    ranking = result.ranking
    first = ranking.order[:BEST].tolist()
    lines = [f"{number(float(ranking.scores[row]), 4)}: {_train(columns, row)}" for row in first]
    values = {"weights": ranking.weights, "ranking": [row + 1 for row in first]}
    return Fact("by weights", "\n".join(lines), values)


def _comparison_facts(what: str, compared: Sequence[Comparison]) -> Iterator[Fact]:
    """The best of every option by each criterion, and which option wins."""
    if not compared:
        return
    lines, values = [], {}
    for each in compared:
        key = each.criterion
        best = {str(option.option): option.values.get(key) for option in each.options}
        told = ", ".join(f"{name}: {'none' if v is None else _value(key, v)}" for name, v in best.items())
        lines.append(f"{_called(key)} - {told}; best {each.winner}")
        values[_key(key)] = {"best": each.winner, **{name: v for name, v in best.items() if v is not None}}
    yield Fact(what, "\n".join(lines), {f"by_{what}": values})


def _guide_facts(result: Selection, guide: Guide) -> Iterator[Fact]:
    """mu* and the theoretical splits of the ratio, beside those of the best train."""
    own = result.winner if result.winner.layout == guide.layout else None
    if guide.proportion is not None:
        text = f"mu* = m2/m1 = {number(guide.proportion, DIGITS)} at U = {number(guide.ratio, DIGITS)}"
        if own is not None and len(own.modules) > 1:
            text += f"; the best train has {number(own.modules[1] / own.modules[0], DIGITS)}"
        yield Fact(f"equal strength, {guide.layout}", text, {f"mu_star_{guide.layout}": guide.proportion})
    if not guide.splits:
        return
    lines = [f"{split.criterion}: {_ratios(split.ratios.tolist())}" for split in guide.splits]
    if own is not None:
        z = own.teeth
        lines.append(f"best train: {_ratios([z[k + 1] / z[k] for k in range(0, len(z), 2)])}")
    values = {split.criterion: split.ratios.tolist() for split in guide.splits}
    yield Fact(f"best splits of U, {guide.layout}", "\n".join(lines), {f"splits_{guide.layout}": values})


def _ratios(ratios: Sequence[float]) -> str:
    return " x ".join(number(ratio, DIGITS) for ratio in ratios)


def _pair_facts(pairs: SeriesChoice) -> Iterator[Fact]:
    one, two = pairs.counts
    if pairs.best is None:
        yield Fact("two in series", pairs.failure, keyed(pairs, "failure"))
        return
    text = f"{SERIES}, each of i_1H near {number(float(pairs.single), DIGITS)}, {pairs.planets} planets\n"
    text += f"{one} and {two} trains, {pairs.admitted} of {pairs.tried} pairs within the tolerance\n"
    text += ", ".join(f"{_extreme(key)} {_called(key)} {_value(key, value)}" for key, value in pairs.best.items())
    best = {quantity_of(SeriesChoice, "best").key: {_key(key): value for key, value in pairs.best.items()}}
    yield Fact("two in series", text, keyed(pairs, "admitted", "tried") | best)


def _pair_documents(pairs: SeriesChoice, rows: int) -> Iterator[Document]:
    columns = {header: column[:rows] for header, column in pair_columns(pairs).items()}
    if columns:
        yield Document(f"{SERIES}: Pareto front", table=drawn(columns), wide=True, more="--format json prints more")


def _front_rows(result: Selection, columns: dict[str, np.ndarray], rows: int) -> dict[str, np.ndarray]:
    """The front, the best by the choice first."""
    scores = result.ranking.scores[result.front]
    if result.choose in OBJECTIVES:
        own: np.ndarray = getattr(result.pool, result.choose)[result.front]
        scores = -own if OBJECTIVES[result.choose].largest else own
    order = result.front[np.argsort(scores, kind="stable")][:rows]
    single = len({*columns["layout"].tolist()}) == 1 and len({*columns["K"].tolist()}) == 1
    hidden = {"front", *(("layout", "K") if single else ())}
    return {header: column[order] for header, column in columns.items() if header not in hidden}


def _width_notes(winner: Winner) -> Iterator[Note]:
    """The stages of the best train whose teeth are narrower or wider than usual."""
    low, high = Assumptions().slenderness
    for stage, (module, width) in enumerate(zip(winner.modules, winner.widths, strict=True), 1):
        ratio = width / module
        if not low <= ratio <= high:
            text = "the face width of stage {stage} of the best train is {value:.4g} of its modules, above {limit:g}"
            if ratio < low:
                text = (
                    "the face width of stage {stage} of the best train is {value:.4g} of its modules, below {limit:g}"
                )
            limit = low if ratio < low else high
            yield held("warning", text, ratio, limit, name=f"b_{stage}/m_{stage}", stage=stage)


def _notes(result: Selection) -> Iterator[str]:
    yield from _width_notes(result.winner)
    unseen = {each.title: each.unseen for each in result.variants if each.unseen}
    for title, count in unseen.items():
        yield Phrase(
            "note: {title}: {count} further tooth sets, of larger Z1 + Z2, are not compared", title=title, count=count
        )
    if any(each.winner == SERIES for each in result.by_layouts if each.criterion == result.choose):
        yield Phrase(
            "note: two trains {series} in series have a better {called} than the best single one",
            series=SERIES,
            called=_called(result.choose),
        )
