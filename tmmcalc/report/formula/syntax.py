"""The text of a formula read to its tree.

It is written as expressions of the program are, with ``**`` for a power; names have indices and primes, ``phi_3``,
``v_{Bx}``, ``a_{BA}^n``, ``S''``; ``sum(P_i*v_i, i)`` is a sum over an index; ``=``, ``<``, ``<=``, ``>``, ``>=`` stand
between sides, ``~`` is "about".
"""

from __future__ import annotations

import ast
import re
from functools import cache

from tmmcalc.core.expression.tree import NoTreeError, syntax_tree
from tmmcalc.report.formula.symbols import NAME, canonical
from tmmcalc.report.formula.tree import (
    FUNCTIONS,
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

RELATION = re.compile(r"<=|>=|=|<|>|~")
FUNCTION = re.compile(r"[A-Za-z]\w*(?=\()")
LARGE = 1e6  # numbers from which on a decimal one has a power of ten
NUMBER = re.compile(r"\d+(?:\.\d+)?(?:[eE][-+]?\d+)?")


class FormulaError(ValueError):
    """A text that is no formula: what is wrong, in words."""


@cache
def read(text: str) -> Statement:
    """The sides of a formula with their relations; one side alone has none. Raises `FormulaError`.

    >>> read("W = 3*n - 2*p_5").relations
    ('=',)
    """
    found, rest = RELATION.findall(text), RELATION.split(text)
    return Statement(tuple(_side(side) for side in rest), tuple(found))


def _side(text: str) -> Node:
    words: list[str] = []
    lettered = _with_identifiers(text.strip(), words)
    try:
        tree = syntax_tree(lettered, "a formula")
    except NoTreeError as error:
        raise FormulaError(f"{text!r}: {error}") from None
    return _Reader(text, words).node(tree)


def _with_identifiers(text: str, words: list[str]) -> str:
    """The text with every name replaced by one that the grammar knows, ``n0_``; ``words`` takes the names."""
    found, at = [], 0
    while at < len(text):
        if (match := FUNCTION.match(text, at)) or (match := NUMBER.match(text, at)):
            found.append(match[0])
        elif match := NAME.match(text, at):
            found.append(f"n{len(words)}_")
            words.append(canonical(match[0]))
        else:
            found.append(text[at])
            at += 1
            continue
        at = match.end()
    return "".join(found)


class _Reader:
    """From the grammar of expressions to the tree of one formula."""

    def __init__(self, text: str, words: list[str]) -> None:
        self.text, self.words = text, words

    def node(self, tree: ast.expr) -> Node:
        match tree:
            case ast.Constant(value=int() | float() as number) if not isinstance(number, bool):
                return Number(_written(number))
            case ast.Name(id=word):
                return Name(self.words[int(word[1:-1])])
            case ast.UnaryOp(op=ast.USub(), operand=inner):
                return negative(self.node(inner))
            case ast.BinOp(op=operator, left=left, right=right):
                return self._binary(operator, self.node(left), self.node(right))
            case ast.Call(func=ast.Name(id="sum"), args=[body, ast.Name(id=index)]):
                return Over(self.node(body), self.words[int(index[1:-1])])
            case ast.Call(func=ast.Name(id=function), args=arguments) if function in FUNCTIONS:
                return Call(function, tuple(self.node(argument) for argument in arguments))
        raise FormulaError(f"{self.text!r}: {ast.unparse(tree)!r} is nothing of a formula")

    def _binary(self, operator: ast.operator, left: Node, right: Node) -> Node:
        match operator:
            case ast.Add() | ast.Sub():
                sign = 1 if isinstance(operator, ast.Add) else -1
                first = left.terms if isinstance(left, Sum) else ((1, left),)
                if isinstance(right, Sum) and len(right.terms) == 1:
                    ((inner, term),) = right.terms
                    return Sum((*first, (sign * inner, term)))
                return Sum((*first, (sign, right)))
            case ast.Mult():
                return _signed(left, right, lambda a, b: Product((*_factors(a), b)))
            case ast.Div():
                return _signed(left, right, Quotient)
            case ast.Pow():
                return Power(left, right)
        raise FormulaError(f"{self.text!r}: {type(operator).__name__} is nothing of a formula")


def _written(number: float) -> str:
    """A number as it is written, a large one with a power of ten.

    >>> _written(2), _written(0.5), _written(2.06e11)
    ('2', '0.5', '2.06e11')
    """
    if isinstance(number, int) or abs(number) < LARGE:
        return repr(number)
    mantissa, _, exponent = f"{number:.15e}".partition("e")
    return f"{mantissa.rstrip('0').rstrip('.')}e{int(exponent)}"


def negative(node: Node) -> Node:
    """The node with the other sign."""
    if isinstance(node, Sum) and len(node.terms) == 1:
        ((sign, term),) = node.terms
        return term if sign < 0 else Sum(((-1, term),))
    return Sum(((-1, node),))


def _signed(left: Node, right: Node, join: object) -> Node:
    """A product or quotient whose sign stands before the whole: ``-a*b`` is ``-(a*b)``."""
    assert callable(join)
    if isinstance(left, Sum) and len(left.terms) == 1:
        ((sign, term),) = left.terms
        joined: Node = join(term, right)
        return joined if sign > 0 else negative(joined)
    found: Node = join(left, right)
    return found


def _factors(node: Node) -> tuple[Node, ...]:
    return node.factors if isinstance(node, Product) else (node,)
