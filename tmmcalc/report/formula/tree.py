"""What a formula is made of, and its value with numbers for the names.

Angles are in rad here, whatever they are printed in. All other values are in the units in which they are printed: a
formula holds in these units.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import NamedTuple


class Number(NamedTuple):
    """A number that stands in the formula itself, as it is written."""

    text: str


class Name(NamedTuple):
    """A quantity by its name: ``phi_3``, ``v_{Bx}``, ``a_{BA}^n``."""

    key: str


class Sum(NamedTuple):
    """Terms with their signs, +1 or -1; a single term with -1 is a negative one."""

    terms: tuple[tuple[int, Node], ...]


class Product(NamedTuple):
    """Factors."""

    factors: tuple[Node, ...]


class Quotient(NamedTuple):
    """A fraction."""

    over: Node
    under: Node


class Power(NamedTuple):
    """A power."""

    base: Node
    exponent: Node


class Call(NamedTuple):
    """A function of its arguments, one of FUNCTIONS."""

    function: str
    arguments: tuple[Node, ...]


class Over(NamedTuple):
    """A sum over an index: names that stand for a list of values take one after another."""

    body: Node
    counter: str


class Statement(NamedTuple):
    """Two or more sides with a relation before each but the first: ``=``, ``<``, ``<=``, ``>``, ``>=``, ``~``."""

    sides: tuple[Node, ...]
    relations: tuple[str, ...]


Node = Number | Name | Sum | Product | Quotient | Power | Call | Over

Value = float | Sequence[float]


def _involute(angle: float) -> float:
    return math.tan(angle) - angle


FUNCTIONS: Mapping[str, Callable[..., float]] = {
    "sin": math.sin,
    "cos": math.cos,
    "tan": math.tan,
    "asin": math.asin,
    "acos": math.acos,
    "atan": math.atan,
    "atan2": math.atan2,
    "sqrt": math.sqrt,
    "abs": abs,
    "exp": math.exp,
    "ln": math.log,
    "lg": math.log10,
    "inv": _involute,
    "min": min,
    "max": max,
    "floor": math.floor,
    "ceil": math.ceil,
    "gcd": lambda a, b: math.gcd(round(a), round(b)),
    "sign": lambda x: math.copysign(1.0, x),
    "rad": lambda angle: angle,  # an angle that is printed in rad
    "deg": math.radians,  # a number of degrees
    "vec": lambda x: x,  # a vector, in letters alone
}
CONSTANTS = {"pi": math.pi}


def value(node: Node, values: Mapping[str, Value]) -> float:
    """The value with numbers for the names; angles in rad.

    Raises `KeyError` for a name without a value, `ValueError` and `ArithmeticError` where it has none.
    """
    match node:
        case Number(text):
            return float(text)
        case Name(key):
            found = CONSTANTS[key] if key in CONSTANTS else values[key]
            if not isinstance(found, float | int):
                raise KeyError(f"{key} stands for a list outside of a sum")
            return float(found)
        case Sum(terms):
            return math.fsum(sign * value(term, values) for sign, term in terms)
        case Product(factors):
            return math.prod(value(factor, values) for factor in factors)
        case Quotient(over, under):
            return value(over, values) / value(under, values)
        case Power(base, exponent):
            return math.pow(value(base, values), value(exponent, values))
        case Call(function, arguments):
            return float(FUNCTIONS[function](*(value(argument, values) for argument in arguments)))
        case Over(body):
            return math.fsum(value(body, each) for each in expanded(body, values))


def expanded(body: Node, values: Mapping[str, Value]) -> Iterator[dict[str, Value]]:
    """The values of each term of a sum over an index."""
    lists = {key: found for key in names(body) if not isinstance(found := values.get(key, 0.0), float | int)}
    lengths = {len(found) for found in lists.values()}
    if len(lengths) != 1:
        raise KeyError(f"lists of different lengths in a sum: {', '.join(lists)}")
    for k in range(lengths.pop()):
        yield {**values, **{key: found[k] for key, found in lists.items()}}


def written_out(node: Node, values: Mapping[str, Value]) -> Node:
    """The node with every sum over an index term by term; the k-th value of a list has the name ``P_i#k``."""
    if isinstance(node, Over):
        count = len(list(expanded(node.body, values)))
        return Sum(tuple((1, _numbered(node.body, k, values)) for k in range(count)))
    return mapped(node, lambda part: written_out(part, values))


def _numbered(node: Node, k: int, values: Mapping[str, Value]) -> Node:
    """The k-th term of a sum over an index."""
    if isinstance(node, Name):
        return node if isinstance(values.get(node.key, 0.0), float | int) else Name(f"{node.key}#{k}")
    return mapped(node, lambda part: _numbered(part, k, values))


def mapped(node: Node, change: Callable[[Node], Node]) -> Node:
    """The node with each of its parts changed."""
    match node:
        case Number() | Name():
            return node
        case Sum(terms):
            return Sum(tuple((sign, change(term)) for sign, term in terms))
        case Product(factors):
            return Product(tuple(map(change, factors)))
        case Quotient(over, under):
            return Quotient(change(over), change(under))
        case Power(base, exponent):
            return Power(change(base), change(exponent))
        case Call(function, arguments):
            return Call(function, tuple(map(change, arguments)))
        case Over(body, counter):
            return Over(change(body), counter)


def renamed(node: Node, other: Mapping[str, str]) -> Node:
    """The node with other names for some of its own."""
    if isinstance(node, Name):
        return Name(other.get(node.key, node.key))
    return mapped(node, lambda part: renamed(part, other))


def names(node: Node | Statement) -> list[str]:
    """The names in it, each once, in the order in which they stand; constants are none."""
    found: dict[str, None] = {}
    _gather(node, found)
    return list(found)


def _gather(node: Node | Statement, found: dict[str, None]) -> None:
    if isinstance(node, Name):
        if node.key not in CONSTANTS:
            found[node.key] = None
        return
    for part in parts(node):
        _gather(part, found)


def parts(node: Node | Statement) -> tuple[Node, ...]:
    """What a node is made of."""
    match node:
        case Number() | Name():
            return ()
        case Sum(terms):
            return tuple(term for _, term in terms)
        case Product(factors):
            return factors
        case Quotient(over, under):
            return over, under
        case Power(base, exponent):
            return base, exponent
        case Call(_, arguments):
            return arguments
        case Over(body):
            return (body,)
        case Statement(sides):
            return sides


def largest_term(node: Node, values: Mapping[str, Value]) -> float:
    """The size against which an error of the value is judged: that of the largest term of any sum that decides it."""
    match node:
        case Sum(terms):
            return max(largest_term(term, values) for _, term in terms)
        case Over(body):
            return max(largest_term(body, each) for each in expanded(body, values))
        case Product(factors):
            return math.prod(largest_term(factor, values) for factor in factors)
        case Quotient(over, under):
            return largest_term(over, values) / abs(value(under, values))
        case Call("sin" | "cos"):
            return 1.0
        case _:
            return abs(value(node, values))
