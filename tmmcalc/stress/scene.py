"""What a ladder is made of: a scene as a document, and the rungs that it leads to."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.core.errors import NoSolutionError, TmmError, UsageError
from tmmcalc.core.facts import facts
from tmmcalc.core.records import record
from tmmcalc.pipeline.outcome import RunResult
from tmmcalc.pipeline.runner import run
from tmmcalc.stress.compare import Alignment

if TYPE_CHECKING:
    from tmmcalc.project import Spec

Document = dict[str, Any]

DISTANCES = (1.0, 1e-1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 0.0)  # parts of the way to an edge that are left
OWN_TWIN = (
    "the same scene in units of a third of a metre, 1/7 kg, 1/1.7 s: what the arithmetic and the last digits lose"
)
NUDGED_TWIN = "the same scene in other units, its pure numbers a rounding away: what digits there can be"


@record
class Scene:
    """A scene, its ordinary run, and what makes a spec of another document."""

    document: Document
    make: Callable[[Document], Spec]
    base: RunResult
    target: str | None = None

    def run(self, document: Mapping[str, Any], target: str | None = None) -> RunResult:
        """Run a changed scene as far as this one; a stage without a solution ends only those that read it."""
        return run(self.make(dict(document)), target=target or self.target, keep_going=True)

    def has(self, stage: str) -> bool:
        """Whether the scene has a stage, with a result."""
        return stage in self.base.outcomes

    def fact(self, stage: str, name: str) -> float | None:
        """A number of the summary of a stage, None if it has none of this name."""
        told = dict(facts(stage, self.base.results[stage])) if self.has(stage) else {}
        return told[name][0] if name in told else None


Condition = Callable[[RunResult], float | None]


@record
class Step:
    """A rung that is to be climbed. Without an alignment its own twin in other units is what it is compared with."""

    setting: str
    size: float
    document: Mapping[str, Any]
    condition: Condition
    alignment: Alignment | None = None
    beside: RunResult | None = None  # what it is compared with in place of the scene as it is


@record
class Climb:
    """A ladder as planned."""

    title: str
    condition: str
    against: str
    steps: Iterator[Step]


def changed(document: Mapping[str, Any], *path: str | int, to: Any) -> Document:
    """A copy of a document with one value set; what is not on the way to it is shared.

    >>> changed({"a": [{"b": 1}, 2]}, "a", 0, "b", to=3)
    {'a': [{'b': 3}, 2]}
    """
    found: Document = _changed(document, path, to)
    return found


def _changed(here: Any, path: tuple[str | int, ...], value: object) -> Any:
    if not path:
        return value
    copied, key = here.copy(), path[0]
    inner = copied.get(key, {}) if isinstance(copied, dict) else copied[key]
    copied[key] = _changed(inner, path[1:], value)
    return copied


def lacking(reason: str, remedy: str = "") -> UsageError:
    """The error of a ladder that the scene has not."""
    return UsageError(reason, where="stress", remedy=remedy)


def regularity(result: RunResult) -> float | None:
    """The smallest regularity of the groups over the motion, None if there is no motion."""
    if "kinematics" not in result.outcomes:
        return None
    qualities = result.results["kinematics"].qualities
    return min((quality.regularity for quality in qualities), default=1.0)


def by_regularity(result: RunResult) -> float | None:
    """Amplification of errors by the linkage; of a dead point that which the program refuses."""
    least = regularity(result)
    if least is None:
        error = result.failures.get("kinematics")
        least = abs(error.value) if error is not None and error.value else None
    return 1 / max(least, 1e-300) if least else None


def always(value: float) -> Condition:
    """A condition number that is known beforehand."""
    return lambda _: value


def regularity_with(scene: Scene, document: Mapping[str, Any]) -> float | None:
    """The regularity of a changed linkage, None if it cannot make its motion."""
    try:
        return regularity(scene.run(document, "kinematics"))
    except TmmError as error:
        if error.exit_code == NoSolutionError.exit_code:
            return None
        raise


def decades(low: int, high: int, step: int = 1) -> list[float]:
    """Powers of ten, both ends included.

    >>> decades(-2, 1)
    [0.01, 0.1, 1.0, 10.0]
    """
    powers = range(low, high + (1 if step > 0 else -1), step)
    return [float(f"1e{k}") for k in powers]
