"""The document of the feasibility stage: every constraint with its value, its limits, what is left; the rule."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from tmmcalc.core.notes import Note, Phrase
from tmmcalc.core.quantity import keyed, table
from tmmcalc.feasibility.judge import Candidate, Feasibility, Verdict
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.numbers import number

TRUTH = "given truth"  # the quantity of a constraint whose truth is given


def document(result: Feasibility, title: str) -> Document:
    """One row a constraint, a warning for each that fails; of several designs a second table."""
    parts = (candidates_document(result, "designs"),) if result.candidates else ()
    return Document(title, _facts(result), _notes(result), _view(result.verdicts), parts=parts)


def _view(rows: Sequence[Verdict]) -> View:
    shown = table(rows, Verdict, "name", "quantity", "value", "unit", "at_least", "at_most", "margin[%]", "holds")
    name, quantity, value, unit, least, most, margin, holds = shown.values()
    columns = [name, quantity, [*map(number, value)], unit, [*map(_limit, least)], [*map(_limit, most)], margin]
    return View(list(shown), [*columns, ["yes" if each else "no" for each in holds]])


def candidates_document(result: Feasibility, title: str, number: int | None = None) -> Document:
    """All designs, the best first; with ``number`` also the constraints of this one and warnings of what fails."""
    designs = result.candidates
    view = View(
        list(table((), Candidate, "number", "name", "feasible", "function", "failing", form=result.form)),
        [
            [str(each.number) for each in designs],
            [each.name for each in designs],
            ["yes" if each.feasible else "no" for each in designs],
            [each.function for each in designs],
            [each.refused or ", ".join(each.failing) for each in designs],
        ],
    )
    if number is None:
        return Document(title, (_count(result),), (), view)
    shown = next(each for each in designs if each.number == number)
    facts = (_count(result), Fact("rule", result.rule, keyed(result, "rule")), *map(_verdict_fact, shown.verdicts))
    return Document(title, facts, tuple(_design_notes(result, shown)), view)


def _chosen(result: Feasibility) -> Fact:
    best = result.candidates[0]
    count = len(result.candidates)
    return Fact("solution", f"{best.number} of {count}, {best.name}", keyed(best, "number") | {"solutions": count})


def _count(result: Feasibility) -> Fact:
    designs = result.candidates
    good = sum(each.feasible for each in designs)
    values = {"feasible": good, "designs": len(designs)} | keyed(result, "chosen")
    return Fact("feasible", f"{good} of {len(designs)} designs", values)


def _verdict_fact(verdict: Verdict) -> Fact:
    values = keyed(verdict, "value", "unit", "margin", "holds")
    told = ", ".join(filter(None, (measured(verdict), limits_of(verdict))))
    text = f"{told}: {'holds' if verdict.holds else 'fails'}"
    return Fact(verdict.name, text, {f"constraint_{verdict.name}": values})


def _design_notes(result: Feasibility, shown: Candidate) -> Iterator[str]:
    """What fails of the design that is shown, and whether another would do."""
    if shown.feasible:
        return
    none = not any(each.feasible for each in result.candidates)
    if shown.refused:
        yield Phrase(
            "warning: solution {number} cannot be judged: {refused}", number=shown.number, refused=shown.refused
        )
    else:
        rest: str = Phrase("solution {chosen} is feasible", chosen=result.chosen)
        if none:
            nearest = shown.number == result.chosen
            rest = "no solution is feasible, this one comes nearest" if nearest else "no solution is feasible"
        yield Phrase(
            "warning: solution {number} does not keep {failing}; {rest}",
            number=shown.number,
            failing=shown.failing,
            rest=rest,
        )
    for verdict in shown.verdicts:
        if verdict.name in shown.failing:
            yield _broken(verdict)


def summary(result: Feasibility, title: str) -> Document:
    """The same without the table."""
    return Document(title, _facts(result), _notes(result))


def _facts(result: Feasibility) -> tuple[Fact, ...]:
    verdict = "all that is asked holds" if result.feasible else f"does not hold: {', '.join(result.failing)}"
    chosen = (_chosen(result),) if result.candidates else ()
    return (
        *chosen,
        Fact("rule", result.rule, keyed(result, "rule")),
        Fact("feasible", verdict, keyed(result, "feasible", "failing")),
        Fact(f"function ({result.form})", number(result.function), keyed(result, "function")),
    )


def _notes(result: Feasibility) -> tuple[str, ...]:
    if result.feasible:
        return ()
    return tuple(_broken(verdict) for verdict in result.verdicts if verdict.name in result.failing)


def _broken(verdict: Verdict) -> Note:
    """The warning of a constraint at fault, with the limit that its value passes, or the one that it has."""
    limits, said = limits_of(verdict), "{measured}; must not hold" if verdict.holds else "{measured}; asked"
    if limits:
        said = "{measured}; must not hold: {limits}" if verdict.holds else "{measured}; asked: {limits}"
    text = Phrase(said, measured=measured(verdict), limits=limits)
    low, high = verdict.at_least, verdict.at_most
    limit = low if high is None or (low is not None and verdict.value < low) else high
    return Note(
        "warning",
        text,
        Phrase("constraint {name}", name=verdict.name),
        verdict.value,
        limit,
        verdict.unit,
        verdict.name,
    )


def measured(verdict: Verdict) -> str:
    """The quantity with its value: ``kinematics stroke_D is 0.658 m``."""
    if verdict.quantity == TRUTH:
        return "given as true" if verdict.value > 0 else "given as false"
    return Phrase("{quantity} is {value}", quantity=verdict.quantity, value=_with_unit(verdict, verdict.value))


def limits_of(verdict: Verdict) -> str:
    """The limits that there are: ``at most 2 m/s``; empty without one, as of a truth."""
    if verdict.quantity == TRUTH:
        return ""
    low, high = (None if each is None else _with_unit(verdict, each) for each in (verdict.at_least, verdict.at_most))
    if low is not None and high is not None:
        return Phrase("at least {low} and at most {high}", low=low, high=high)
    if low is not None:
        return Phrase("at least {low}", low=low)
    return "" if high is None else Phrase("at most {high}", high=high)


def _with_unit(verdict: Verdict, value: float) -> str:
    return f"{number(value)} {verdict.unit}".rstrip()


def _limit(limit: float | None) -> str:
    return "" if limit is None else number(limit)
