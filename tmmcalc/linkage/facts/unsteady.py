"""The documents of the unsteady stage: ends, phases, extremes, and the table over the time."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence

from tmmcalc.core.columns import Column
from tmmcalc.core.notes import Phrase
from tmmcalc.core.quantity import Quantity, keyed
from tmmcalc.linkage.unsteady.columns import OUTPUT, unsteady_columns
from tmmcalc.linkage.unsteady.results import Unsteady
from tmmcalc.report.document import Document, Fact, angles_in_degrees
from tmmcalc.report.errors import digit_facts
from tmmcalc.report.numbers import angle, number
from tmmcalc.report.positions import with_positions
from tmmcalc.report.timelaw import extreme_lines, extreme_values, law_facts

POINT = (
    Quantity("speed_{point}[m/s]", "speed of point {point}"),
    Quantity("acceleration_{point}[m/s^2]", "acceleration of point {point}"),
)
POINTS = tuple(each.name.removesuffix("{point}") for each in POINT)
CENTRE = re.compile(r"(speed|acceleration)_S\d+")  # of a centre of mass


def summary(result: Unsteady, title: str) -> Document:
    """Facts and notes, without the table."""
    return angles_in_degrees(Document(title, tuple(_facts(result)), tuple(str(grade) for grade in result.grades)))


def document(
    result: Unsteady,
    title: str,
    *,
    patterns: Sequence[str] = (),
    rows: Sequence[int] | None = None,
    everything: bool = False,
    where: str = "",
) -> Document:
    """Summary and table; ``patterns`` choose columns, ``rows`` instants by index, ``everything`` takes all columns."""
    told, available = summary(result, title), unsteady_columns(result)
    usual = available if everything else _first(result, available)
    example = "t,x,v,a,omega_*"
    return with_positions(
        told, result.labels, available, patterns, rows, usual=usual, example=example, everything=everything, where=where
    )


def _first(result: Unsteady, available: list[Column]) -> list[Column]:
    """Without the columns of the driven link or joint, which repeat x, v and a."""
    drive = result.input_link if result.turns else result.input_joint
    names = ("angle", "omega", "eps") if result.turns else ("s", "v", "a")
    repeated = {f"{name}_{drive}" for name in names}
    return [column for column in available if column.name not in repeated]


def _facts(result: Unsteady) -> Iterator[Fact]:
    yield from law_facts(result.law, result.turns, "the input")
    yield _ends_fact(result)
    for k, (name, angular) in enumerate(zip(result.outputs, result.angular, strict=True)):
        yield _output_fact(result, k, name, angular)
    yield from _extreme_facts(result)
    e = result.error
    text = f"position {e.position:.0e}, velocity {e.velocity:.0e}, acceleration {e.acceleration:.0e}"
    yield Fact("error (est.)", f"{text} (relative)", {"error": keyed(e, "position", "velocity", "acceleration")})
    if e.last_digit is not None:
        yield from digit_facts(keyed(e.last_digit))


def _ends_fact(result: Unsteady) -> Fact:
    name = f"angle_{result.input_link}" if result.turns else f"s_{result.input_joint}"
    shown = [_amount(value, result.turns) for value in (result.start, result.end)]
    values = keyed(result, "start", "end", unit="rad" if result.turns else "m")
    return Fact("input", f"{name} from {shown[0]} to {shown[1]}", values)


def _amount(value: float, angular: bool) -> str:
    return f"{angle(math.degrees(value))} deg" if angular else f"{number(value)} m"


def _output_fact(result: Unsteady, k: int, name: str, angular: bool) -> Fact:
    start, end = (float(result.coordinate[0, k, row]) for row in (0, -1))
    text = f"from {_amount(start, angular)} to {_amount(end, angular)}, by {_amount(end - start, angular)}"
    told = OUTPUT[0].of(output=name, own="rad" if angular else "m")
    return Fact(
        Phrase("output {name}", name=name), text, {told.marked("start").key: start, told.marked("end").key: end}
    )


def _extreme_facts(result: Unsteady) -> Iterator[Fact]:
    """Extremes of outputs, links and points; those of input, slides and centres of mass are for programs alone."""
    told = [each for each in result.extremes if each.least != each.largest]
    for label, begins in (("outputs", ("vS_", "aS_")), ("links", ("omega_", "eps_")), ("points", POINTS)):
        found = [each for each in told if each.name.startswith(begins) and not CENTRE.fullmatch(each.name)]
        if found:
            yield Fact(f"extremes, {label}", extreme_lines(found), extreme_values(found))
    named = ("vS_", "aS_", "omega_", "eps_", *POINTS)
    rest = [each for each in told if not each.name.startswith(named) or CENTRE.fullmatch(each.name)]
    if rest:
        yield Fact("extremes, input", extreme_lines(rest[:2]), extreme_values(rest))
