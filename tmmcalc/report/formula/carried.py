"""A formula as plain values, by which others than the program compute it: the page makes functions of them.

a number    itself            a name    its text
a sum       ["+", [sign, term], ...]    a product    ["*", factor, ...]
a quotient  ["/", over, under]          a power      ["^", base, exponent]
a function  its name, then its arguments

Statements are steps, each of which tells a name; what no formula tells is sought as a root.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any, NamedTuple

from tmmcalc.report.formula.tree import (
    CONSTANTS,
    Call,
    Name,
    Node,
    Number,
    Over,
    Power,
    Product,
    Quotient,
    Statement,
    Sum,
)

SOLVED = ("inv",)  # functions of one name whose value tells it


class Step(NamedTuple):
    """A name that a formula tells from others: itself, or by a function of it on the left side."""

    name: str
    function: str  # empty: none
    formula: Any  # plain values


class Root(NamedTuple):
    """A name at which what the last of its steps tells is zero, between two ends; the lower where that has one sign."""

    name: str
    low: Any
    high: Any
    steps: tuple[Step, ...]  # which need the name; what they tell at the root is known from there on


def step_of(formula: Statement) -> Step:
    """The step that a formula of two sides is; raises `ValueError` where its left side tells no name.

    >>> from tmmcalc.report.formula.syntax import read
    >>> step_of(read("g = a_w*sin(alpha_tw)"))
    Step(name='g', function='', formula=['*', 'a_w', ['sin', 'alpha_tw']])
    >>> step_of(read("inv(alpha) = 2*x - 1"))
    Step(name='alpha', function='inv', formula=['+', [1, ['*', 2.0, 'x']], [-1, 1.0]])
    """
    left, right = formula.sides
    match left:
        case Name(key):
            return Step(key, "", carried(right))
        case Call(function, (Name(key),)) if function in SOLVED:
            return Step(key, function, carried(right))
    raise ValueError(f"the left side of {formula} tells no name")


def carried(node: Node) -> Any:
    """The node as plain values; raises `ValueError` for a sum over an index."""
    match node:
        case Number(text):
            return float(text)
        case Name(key):
            return key
        case Sum(terms):
            return ["+", *([sign, carried(term)] for sign, term in terms)]
        case Product(factors):
            return ["*", *map(carried, factors)]
        case Quotient(over, under):
            return ["/", carried(over), carried(under)]
        case Power(base, exponent):
            return ["^", carried(base), carried(exponent)]
        case Call(function, arguments):
            return [function, *map(carried, arguments)]
        case Over():
            raise ValueError(f"a sum over an index is not carried: {node}")


def needed(steps: Iterable[Step | Root]) -> list[str]:
    """The names that steps need and do not tell, each once, in the order in which they are needed.

    >>> needed([Step("y", "", ["*", 2.0, "x"]), Root("t", 0.0, "y", (Step("z", "", ["+", [1, "t"], [-1, "a"]]),))])
    ['x', 'a']
    """
    known: set[str] = set()
    found: dict[str, None] = {}
    for step in steps:
        ends = [Step(step.name, "", ["", step.low, step.high]), *step.steps] if isinstance(step, Root) else [step]
        for name, _, formula in ends:
            found.update(dict.fromkeys(key for key in _names(formula) if key not in known))
            known.add(name)
    return list(found)


def _names(formula: Any) -> Iterator[str]:
    """The names in plain values."""
    if isinstance(formula, str):
        if formula not in CONSTANTS:
            yield formula
    elif isinstance(formula, list):
        for part in formula[1:]:
            yield from _names(part)
