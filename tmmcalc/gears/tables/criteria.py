"""``[criteria]``: by what the best of all gear trains is chosen."""

from typing import Annotated, Any

from pydantic import Field

from tmmcalc.gears.criteria.objectives import OBJECTIVES
from tmmcalc.spec.choices import Known, OneOrMore
from tmmcalc.spec.phrases import listing, nearest, show
from tmmcalc.spec.quantities import Number
from tmmcalc.spec.reader import Reader
from tmmcalc.spec.table import Table
from tmmcalc.spec.units import UnitError

WEIGHTED = "weighted"


class Choose(Reader):
    """A criterion, ``"weighted"``, or the number of a row."""

    WORDS = (*OBJECTIVES, WEIGHTED)

    def read(self, value: object) -> str | int:
        """Return the word or the number; raise UnitError with the fault in plain words."""
        if isinstance(value, int) and not isinstance(value, bool) and value >= 1:
            return value
        if isinstance(value, str) and value in self.WORDS:
            return value
        close = nearest(value, self.WORDS) if isinstance(value, str) else None
        guess = f'did you mean "{close}"? ' if close else ""
        kinds = f"there are: {listing(self.WORDS)}, and the numbers of the rows of criteria.csv, from 1"
        raise UnitError(f"{show(value)} does not say which train is chosen", f"{guess}{kinds}")

    def describe(self) -> dict[str, Any]:
        """Return the JSON Schema: a word or a whole number."""
        kinds = [{"type": "string", "enum": list(self.WORDS)}, {"type": "integer", "minimum": 1}]
        return {"anyOf": kinds, "description": "A criterion, weighted, or the number of a row of criteria.csv, from 1."}


Objectives = Annotated[list[str], OneOrMore(Known("criterion", tuple(OBJECTIVES)))]
Weight = Annotated[float, Number("a weight", "2", at_least=0)]
Efficiency = Annotated[float, Number("an efficiency", "0.97", above=0, at_most=1)]


class CriteriaWeightsTable(Table):
    """How much each criterion counts in the ranking; each is scaled from its best to its worst value."""

    mass: Weight = Field(default=0.0, description="Mass of the moving wheels.")
    inertia: Weight = Field(
        default=0.0, description="Moment of inertia of the moving wheels, reduced to the output shaft."
    )
    size: Weight = Field(
        default=0.0, description="D of the textbook: diameter around the planets, or length of the row."
    )
    envelope: Weight = Field(default=0.0, description="Diameter or length around all wheels and rings.")
    efficiency: Weight = Field(
        default=0.0, description="Efficiency of the train, bearings without losses; the more the better."
    )
    error: Weight = Field(default=0.0, description="Relative deviation of the ratio, of the kind asked for.")
    width_deviation: Weight = Field(
        default=0.0, description="How far b/m, face width over module, lies outside 6 to 40, relative to that limit."
    )


class CriteriaTable(Table):
    """By what the trains that are strong enough are compared, and the best of them is chosen."""

    objectives: Objectives | None = Field(
        default=None,
        description="Criteria of the Pareto front and the comparisons, of those of `weights` (default: "
        '`["mass", "inertia", "size"]`).',
    )
    weights: CriteriaWeightsTable | None = Field(
        default=None,
        description="Weights of criteria in the ranking, `{ mass = 1, inertia = 2 }`; "
        "each criterion is scaled from its best to its worst value (default: all objectives alike).",
    )
    choose: Annotated[str | int, Choose()] = Field(
        default="inertia",
        description='The best train: of one criterion, by the weights, `"weighted"`, or the number `i` of a row of '
        "`criteria.csv`, from 1.",
    )
    external_efficiency: Efficiency | None = Field(
        default=None, description="Efficiency of one external mesh (default: 0.975)."
    )
    internal_efficiency: Efficiency | None = Field(
        default=None, description="Efficiency of one internal mesh (default: 0.985)."
    )
    series: bool = Field(
        default=False,
        description="Whether two trains AIbar (single planets) in series, each of the ratio sqrt(i_1H), are compared "
        "with the best single one.",
    )
