"""The same scene solved with the overrides of each variant in turn; one without a solution does not end the rest."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Any

from tmmcalc.errors import TmmError, UsageError
from tmmcalc.pipeline.runner import run

Overrides = tuple[str, ...]


def solved(
    read: Callable[[Sequence[str]], object], variants: Iterable[Overrides], target: str
) -> Iterator[tuple[Overrides, Any | TmmError]]:
    """The result of stage ``target`` in every variant, or why there is none: a faulty spec, or no solution.

    ``read`` makes a spec of overrides. Raises `UsageError` for what no other value of a key would mend.
    """
    for overrides in variants:
        try:
            yield overrides, run(read(overrides), target=target).results[target]
        except UsageError as error:
            where = f"{error.where}, with {', '.join(overrides)}" if error.where else f"with {', '.join(overrides)}"
            raise UsageError(error.message, where=where, remedy=error.remedy) from None
        except TmmError as error:
            yield overrides, error
