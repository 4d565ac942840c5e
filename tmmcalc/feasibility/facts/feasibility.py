"""The document of the feasibility stage: every constraint with its value, its limits, what is left; the rule."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from tmmcalc.core.notes import Note
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
    text = f"{', '.join([measured(verdict), *_limits(verdict)])}: {'holds' if verdict.holds else 'fails'}"
    return Fact(verdict.name, text, {f"constraint_{verdict.name}": values})


def _design_notes(result: Feasibility, shown: Candidate) -> Iterator[str]:
    """What fails of the design that is shown, and whether another would do."""
    if shown.feasible:
        return
    none = not any(each.feasible for each in result.candidates)
    if shown.refused:
        yield f"warning: solution {shown.number} cannot be judged: {shown.refused}"
    else:
        near = ", this one comes nearest" if none and shown.number == result.chosen else ""
        rest = f"no solution is feasible{near}" if none else f"solution {result.chosen} is feasible"
        yield f"warning: solution {shown.number} does not keep {', '.join(shown.failing)}; {rest}"
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
    state = "must not hold" if verdict.holds else "asked"
    text = f"{measured(verdict)}; {': '.join([state, *_limits(verdict)])}"
    low, high = verdict.at_least, verdict.at_most
    limit = low if high is None or (low is not None and verdict.value < low) else high
    return Note("warning", text, f"constraint {verdict.name}", verdict.value, limit, verdict.unit, verdict.name)


def _limits(verdict: Verdict) -> list[str]:
    """The limits in one text, if there are any: a truth has none."""
    return [" and ".join(words)] if (words := limits_in_words(verdict)) else []


def measured(verdict: Verdict) -> str:
    """The quantity with its value: ``kinematics stroke_D is 0.658 m``."""
    if verdict.quantity == TRUTH:
        return f"given as {str(verdict.value > 0).lower()}"
    return f"{verdict.quantity} is {number(verdict.value)} {verdict.unit}".rstrip()


def limits_in_words(verdict: Verdict) -> list[str]:
    """The limits that there are: ``at most 2 m/s``."""
    if verdict.quantity == TRUTH:
        return []
    pairs = (("at least", verdict.at_least), ("at most", verdict.at_most))
    return [f"{word} {number(limit)} {verdict.unit}".rstrip() for word, limit in pairs if limit is not None]


def _limit(limit: float | None) -> str:
    return "" if limit is None else number(limit)
