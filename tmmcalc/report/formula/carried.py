"""A formula as plain values, by which others than the program compute it: the page makes functions of them.

a number    itself            a name    its text
a sum       ["+", [sign, term], ...]    a product    ["*", factor, ...]
a quotient  ["/", over, under]          a power      ["^", base, exponent]
a function  its name, then its arguments
"""

from __future__ import annotations

from typing import Any, NamedTuple

from tmmcalc.report.formula.tree import Call, Name, Node, Number, Over, Power, Product, Quotient, Statement, Sum

SOLVED = ("inv",)  # functions of one name whose value tells it


class Step(NamedTuple):
    """A name that a formula tells from others: itself, or by a function of it on the left side."""

    name: str
    function: str  # empty: none
    formula: Any  # plain values


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
