"""Linear equations told one after the other, each solved for the quantity that is new in it."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from typing import NamedTuple


class Equation(NamedTuple):
    """One equation: of each of its quantities the formula with it on the left side."""

    solved: Mapping[str, str]

    def unknown(self, known: Collection[str]) -> list[str]:
        """Its quantities that are not known."""
        return [name for name in self.solved if name not in known]


class Together(NamedTuple):
    """A quantity that only the equations that are left give together."""

    name: str


def in_order(equations: Sequence[Equation], known: Collection[str]) -> Iterator[str | Together]:
    """The formulas in an order in which each has one quantity that is not known before.

    Where every equation has several, one of them is taken as found from all; an equation in which everything is known
    is told of its first quantity, as a check.

    >>> chain = [Equation({"b": "b = c - 1", "c": "c = b + 1"}), Equation({"a": "a = b/2", "b": "b = 2*a"})]
    >>> [*in_order(chain, {"a"})]
    ['b = 2*a', 'c = b + 1']
    """
    left, have = list(equations), set(known)
    while left:
        fewest = min(left, key=lambda each: len(each.unknown(have)))
        unknown = fewest.unknown(have)
        if len(unknown) > 1:
            have.add(unknown[0])
            yield Together(unknown[0])
            continue
        left.remove(fewest)
        name = unknown[0] if unknown else next(iter(fewest.solved))
        have.add(name)
        yield fewest.solved[name]
