"""What an extreme spec is to give: a table in its comments, one line an answer.

    #= to | forces                              the stage to run to; without it all that the scene has
    #= exit | 3 | the crank turns 90 deg | closed form | degrees(pi/2)    exit code, words of the error, their proof
    #= value | kinematics.stroke_B[m] | 0.1 | 1e-14 | closed form, twice the crank | 2*r

A value has its name as ``tmmcalc sweep`` tells it, the number, its tolerance (relative, or ``abs 1e-9``), how it was
proved, and, where it is short, the formula of the proof for mpmath, in which ``mpf``, ``sqrt``, ``pi`` ... are known.
Words of an error have one such formula for every number in them, in their order; of a number that is none of the
program's but stands in the spec, as of ``teeth = [5, 5]``, it is the place: ``given pair.teeth.0``.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from tmmcalc.batch.quantities import told
from tmmcalc.core.errors import TmmError
from tmmcalc.core.records import record
from tmmcalc.naming.scene import Scene
from tmmcalc.pipeline.outcome import RunResult

MARK = "#="


@record
class Value:
    """One number that is known otherwise."""

    name: str  # stage.quantity[unit], or stage.max(column)[unit]
    value: float
    tolerance: float
    absolute: bool
    proof: str
    formula: str = ""  # for mpmath, empty where the proof is longer than a line


@record
class Expected:
    """The end of an extreme scene."""

    target: str | None
    code: int
    words: str
    values: tuple[Value, ...]
    formulas: tuple[str, ...] = ()  # for mpmath, of the numbers in the words


def expected(text: str) -> Expected:
    """Read the table of a spec.

    >>> expected("#= exit | 3 | dead point\\n").code
    3
    """
    target, code, words = None, 0, ""
    formulas: list[str] = []
    values = []
    for line in text.splitlines():
        if not line.startswith(MARK):
            continue
        kind, *cells = [cell.strip() for cell in re.split(r"\s\|\s", line.removeprefix(MARK).strip())]
        if kind == "to":
            target = cells[0]
        elif kind == "exit":
            code, words = int(cells[0]), cells[1] if len(cells) > 1 else ""
            formulas = cells[3:]
        else:
            values.append(_value(cells))
    return Expected(target, code, words, tuple(values), tuple(formulas))


def _value(cells: list[str]) -> Value:
    name, value, tolerance, proof, *formula = cells
    size = tolerance.removeprefix("abs").strip()
    return Value(name, float(value), float(size), size != tolerance, proof, formula[0] if formula else "")


def disagreements(found: RunResult | TmmError, wanted: Expected) -> Iterator[str]:
    """In what the end of a run differs from what is expected."""
    error = found if isinstance(found, TmmError) else next(iter(found.failures.values()), None)
    code = error.exit_code if error is not None else 0
    if code != wanted.code:
        yield f"exit code {code} in place of {wanted.code}{f': {error}' if error is not None else ''}"
    elif error is not None and wanted.words not in " ".join(str(error).split()):
        yield f"the error does not say {wanted.words!r}: {error}"
    if isinstance(found, RunResult):
        for value in wanted.values:
            yield from _differences(found, value)


def _differences(run: RunResult, wanted: Value) -> Iterator[str]:
    stage = wanted.name.partition(".")[0]
    if stage not in run.outcomes:
        yield f"{wanted.name}: there is no result of {stage}"
        return
    met = dict(told(run.results, [wanted.name], Scene(run.spec, run.results), [stage]))
    if wanted.name not in met:
        yield f"{wanted.name}: {stage} tells no such quantity"
        return
    allowed = wanted.tolerance * (1.0 if wanted.absolute else abs(wanted.value))
    if not abs(met[wanted.name] - wanted.value) <= allowed:
        yield f"{wanted.name} = {met[wanted.name]!r} in place of {wanted.value!r}, beyond {allowed:.1e}"
