"""``[class]``: what every student gets of an assignment, and what is asked of each."""

import re
from fractions import Fraction
from typing import Annotated, Any

from pydantic import Field

from tmmcalc.design.tables.key import Keys, Result
from tmmcalc.spec.choices import Exact, Listed, OneOrMore, Whole
from tmmcalc.spec.phrases import show
from tmmcalc.spec.quantities import Bound, Limit
from tmmcalc.spec.reader import Reader
from tmmcalc.spec.table import Table
from tmmcalc.spec.units import UnitError

LONGEST = 80  # characters of a name: it stands in headers of tables and in names of files


class Words(Reader):
    """A text of one line that names something."""

    def __init__(self, noun: str, example: str, most: int = LONGEST) -> None:
        self.noun = noun
        self.example = example
        self.most = most

    def read(self, value: object) -> str:
        """Return the text without blanks around it; raise UnitError with the fault in plain words."""
        if not isinstance(value, str) or not value.strip() or not value.isprintable():
            raise UnitError(f"{show(value)} is not {self.noun}", f'write one line: "{self.example}"')
        if len(value) > self.most:
            raise UnitError(f"{show(value)} is longer than {self.most} characters", "write a shorter one")
        return value.strip()

    def describe(self) -> dict[str, Any]:
        """Return the JSON Schema of a text."""
        return {"type": "string", "description": f"{self.noun.capitalize()}."}


def followed(text: str) -> tuple[str, float]:
    """The name of a result that another follows, and its power; 0 where none is told.

    >>> followed("omega_3^2"), followed("v_D ^ -1")
    (('omega_3', 2.0), ('v_D', -1.0))
    """
    match = re.fullmatch(r"(.+?)\s*\^\s*([+-]?\d+(?:\.\d+)?)", text)
    return (match[1], float(match[2])) if match else (text, 0.0)


def _part(noun: str, example: str) -> Exact:
    return Exact(noun, example, above=0, below=1, percent=True)


Values = Annotated[list[Any], Listed(Bound("a value", '"2.5 mm"'), '["2 mm", "2.5 mm", "3 mm"]')]
Factor = Annotated[Fraction, Exact("a factor", "3, 3.5 or 7/2", above=0)]
Tolerance = Annotated[Fraction, _part("a relative tolerance", '"1 %"')]
Share = Annotated[Fraction, Exact("a part", '"5 %"', at_least=0, below=1, percent=True)]
Weight = Annotated[Fraction, Exact("a weight", "2", above=0)]
Spread = Annotated[Fraction, Exact("a ratio", "5", above=1)]
Digits = Annotated[int, Whole("a number of digits", 2, 9)]
Said = Annotated[str, Words("a name", "stroke H")]
Meant = Annotated[str, Words("a meaning", "mean power of the motor", most=200)]
Other = Annotated[list[str], OneOrMore(Words("a name", "stroke"))]
Named = Annotated[str, Result()]


class DrawnTable(Table):
    """A number that each variant has its own of: in steps between two limits, or among values."""

    of: Keys = Field(
        description='Its key as in `--set`, `"mechanism.links[id=1].points.A[0]"`; several keys get the same value.'
    )
    at_least: Limit | None = Field(
        default=None, description="The least value, in the unit of the key or in its own; with `times` a factor."
    )
    at_most: Limit | None = Field(default=None, description="The greatest value, likewise.")
    step: Limit | None = Field(
        default=None,
        description='What its values are multiples of, from 0 on: `"5 mm"`, `"0.01 m"`, `1`; needed beside limits.',
    )
    among: Values | None = Field(default=None, description='Or the values that there are: `["2 mm", "2.5 mm"]`.')
    times: Keys | None = Field(
        default=None,
        description="The key whose value `at_least` and `at_most` multiply, given or drawn before: with 3, 4 and a "
        "step of 5 mm a value is three to four times that one, to 5 mm.",
    )


class AskedTable(Table):
    """A result that every student is asked for."""

    result: Named = Field(description='Its name: `"kinematics.stroke_D"`, `"forces.R_A@3"`.')
    name: Said | None = Field(
        default=None, description="What it is called in sheets and answers (default: the name of the result)."
    )
    also: Other = Field(default=[], description='What else it may be called in answers: `["H", "хід"]`.')
    meaning: Meant | None = Field(
        default=None, description="What it is, as task sheets say it (default: as the program does)."
    )
    unit: Said | None = Field(default=None, description="The unit it is asked in (default: that of the result).")
    tolerance: Tolerance | None = Field(default=None, description="Within it an answer is right (default: of all).")
    within: Limit | None = Field(
        default=None,
        description='Or so much, whatever the value: `"0.5 mm"`; the larger of both counts, as near zero it has to.',
    )
    plans: Tolerance | None = Field(default=None, description="Accuracy of plans for it (default: of all).")
    weight: Weight = Field(default=Fraction(1), description="Points for a right answer.")
    digits: Digits | None = Field(default=None, description="Significant digits that are asked for (default: of all).")
    after: Other = Field(
        default=[],
        description="Names of asked results that it is computed from: one that is wrong there and carried on rightly "
        'counts. With a power, `"omega_3^2"`, it follows it by this one; without it by 1.',
    )
    either_sense: bool = Field(default=False, description="Whether the assignment leaves its sign open.")


class ClassTable(Table):
    """An assignment for many: what is drawn for each, what is asked, how answers are judged.

    Variants keep all `[[constraints]]` by the rule of `[feasibility]`, with `margin`.
    """

    drawn: list[DrawnTable] = Field(
        default=[], max_length=60, description="What each variant has its own of; the spec of a variant has none."
    )
    asked: list[AskedTable] = Field(min_length=1, max_length=60, description="What is asked.")
    roster: str | None = Field(
        default=None,
        description="File with the name or number of a student a line, beside the spec; without it `-n` says how many.",
    )
    margin: Share = Field(
        default=Fraction(1, 50),
        description="By how much of a limit constraints are kept, so that rounding decides nothing.",
    )
    apart: Share = Field(
        default=Fraction(1, 20),
        description="Least distance of two variants: the part of its range by which a drawn number differs, in the "
        "mean of all.",
    )
    spread: Spread = Field(
        default=Fraction(10),
        description="Greatest ratio of an asked result among variants, of magnitudes: each is within its root of that "
        "of the assignment itself.",
    )
    tolerance: Tolerance = Field(default=Fraction(1, 100), description="Within it an answer is right.")
    plans: Tolerance = Field(
        default=Fraction(3, 100), description="Accuracy of plans: right, but by a drawing; no less than `tolerance`."
    )
    for_plans: Share = Field(
        default=Fraction(1, 2), description="Part of the points for an answer within the accuracy of plans."
    )
    for_carried: Share = Field(
        default=Fraction(4, 5), description="Part of the points for one that is right for a wrong value before it."
    )
    digits: Digits = Field(default=4, description="Significant digits that are asked for.")
