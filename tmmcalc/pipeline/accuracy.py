"""Whether a stage reached the accuracy that was asked for, by its own estimate of its error."""

from __future__ import annotations

from tmmcalc.core.errors import AccuracyError
from tmmcalc.core.stored import estimates
from tmmcalc.pipeline.outcome import Outcome


def check_accuracy(outcome: Outcome, tolerance: float) -> None:
    """Raise `AccuracyError` if an estimated relative error of the stage is larger than ``tolerance``."""
    beyond = [(error, name) for name, error in estimates(outcome.record.error) if error > tolerance]
    if not beyond:
        return
    error, name = max(beyond)
    raise AccuracyError(
        f"the estimated error of {name} is {error:.1e}, more than the {tolerance:g} asked for",
        where=outcome.stage.name,
        value=error,
        limit=tolerance,
        remedy="ask for less, take another method, or keep clear of the places that the warnings name",
    )
