"""From the syntax tree of a formula to a function of its variables, with the places where it can jump or bend.

The argument of abs or sign, the two sides of a comparison, the operands of min and max, the ends of a remainder each
give a switch: a function that changes its sign there.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Mapping
from difflib import get_close_matches
from functools import reduce
from typing import Any

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.core.expression.tree import shown
from tmmcalc.core.expression.words import COMPARISONS, ONE_ARGUMENT, OPERATORS, SEVERAL
from tmmcalc.core.numerics.panels import Values

Term = Callable[[Values], Any]

DEEPEST = 150  # brackets, signs or terms within each other
ARITHMETIC = "+ - * / % ** and the functions"


def fault(text: str, message: str, remedy: str, where: str) -> UsageError:
    """What is wrong with the formula ``text``."""
    return UsageError(f"formula {shown(text)}: {message}", where=where, remedy=remedy)


class Reader:
    """Translates the nodes of one formula and collects its switches on the way.

    ``names`` are numbers, or functions that take a variable from the argument of all terms.
    """

    def __init__(self, text: str, names: Mapping[str, float | Term], where: str, deep: str) -> None:
        self.text = text
        self.names = names
        self.where = where
        self.deep = deep  # remedy for a formula that is nested too deeply
        self.switches: list[Term] = []
        self._depth = 0

    def read(self, node: ast.expr) -> Term:
        """The node as a function; raises `UsageError` for what is no arithmetic."""
        kind = _KINDS.get(type(node))
        if kind is None:
            variable = next(name for name, value in self.names.items() if callable(value))
            raise self._refusal(node, "this is not arithmetic", f"use numbers, {variable}, {ARITHMETIC}")
        if self._depth == DEEPEST:
            raise self._refusal(node, f"nested deeper than {DEEPEST} times", self.deep)
        self._depth += 1
        term = kind(self, node)
        self._depth -= 1
        return term

    def _refusal(self, node: ast.expr, message: str, remedy: str) -> UsageError:
        return fault(self.text, f"{message} at column {node.col_offset + 1}", remedy, self.where)

    def _number(self, node: ast.Constant) -> Term:
        if isinstance(node.value, bool) or not isinstance(node.value, (int, float)):
            raise self._refusal(node, f"{node.value!r} is not a real number", "write numbers as 12, 0.5 or 1e3")
        try:
            value = float(node.value)
        except OverflowError:
            raise self._refusal(node, "a number too large", "write numbers below 1e308") from None
        return lambda at: value

    def _name(self, node: ast.Name) -> Term:
        if node.id not in self.names:
            raise self._unknown(node, "name", node.id, [*self.names])
        known = self.names[node.id]
        if callable(known):
            return known
        value = float(known)
        return lambda at: value

    def _unknown(self, node: ast.expr, kind: str, name: str, known: list[str]) -> UsageError:
        close = get_close_matches(name, known, 1)
        hint = f"perhaps you meant {close[0]}; " if close else ""
        return self._refusal(node, f"unknown {kind} {name!r}", f"{hint}known: {', '.join(sorted(known))}")

    def _unary(self, node: ast.UnaryOp) -> Term:
        inner = self.read(node.operand)
        if isinstance(node.op, ast.USub):
            return lambda at: np.negative(inner(at))
        if isinstance(node.op, ast.UAdd):
            return inner
        if isinstance(node.op, ast.Not):
            return lambda at: np.logical_not(inner(at))
        raise self._refusal(node, "this operator is not arithmetic", "use + - * / % **")

    def _binary(self, node: ast.BinOp) -> Term:
        operator = OPERATORS.get(type(node.op))
        if operator is None:
            power = isinstance(node.op, ast.BitXor)
            remedy = "a power is written **" if power else "use + - * / % **"
            raise self._refusal(node, "this operator is not arithmetic", remedy)
        left, right = self.read(node.left), self.read(node.right)
        if isinstance(node.op, ast.Mod):
            self.switches.append(lambda at: np.sin(np.pi * np.divide(left(at), right(at))))
        return lambda at: operator(np.asarray(left(at), float), right(at))

    def _comparison(self, node: ast.Compare) -> Term:
        parts: list[Term] = []
        left = self.read(node.left)
        for op, right_node in zip(node.ops, node.comparators, strict=True):
            compare = COMPARISONS.get(type(op))
            if compare is None:
                raise self._refusal(node, "this comparison has no sense on a continuous variable", "use < <= > >=")
            right = self.read(right_node)
            parts.append(_joined(compare, left, right))
            self.switches.append(_joined(np.subtract, left, right))
            left = right
        return lambda at: reduce(np.logical_and, (part(at) for part in parts))

    def _logic(self, node: ast.BoolOp) -> Term:
        parts = [self.read(value) for value in node.values]
        join = np.logical_and if isinstance(node.op, ast.And) else np.logical_or
        return lambda at: reduce(join, (part(at) for part in parts))

    def _choice(self, node: ast.IfExp) -> Term:
        test, yes, no = self.read(node.test), self.read(node.body), self.read(node.orelse)
        return lambda at: np.where(test(at), yes(at), no(at))

    def _call(self, node: ast.Call) -> Term:
        known = [*ONE_ARGUMENT, *SEVERAL]
        if not isinstance(node.func, ast.Name) or node.func.id not in known:
            raise self._unknown(node, "function", ast.unparse(node.func), known)
        name = node.func.id
        if node.keywords or (len(node.args) != 1 if name in ONE_ARGUMENT else len(node.args) < 2):
            wanted = "one argument" if name in ONE_ARGUMENT else "two arguments or more"
            raise self._refusal(node, f"{name} takes {wanted}", f"write {name}(...) with {wanted}")
        arguments = [self.read(argument) for argument in node.args]
        if name in SEVERAL:
            return self._largest_or_smallest(SEVERAL[name], arguments)
        function, argument = ONE_ARGUMENT[name], arguments[0]
        if name in ("abs", "sign"):
            self.switches.append(argument)
        return lambda at: function(argument(at))

    def _largest_or_smallest(self, choose: Callable[[Any, Any], Any], arguments: list[Term]) -> Term:
        for i, first in enumerate(arguments):
            self.switches.extend(_joined(np.subtract, first, second) for second in arguments[i + 1 :])
        return lambda at: reduce(choose, (argument(at) for argument in arguments))


_KINDS: dict[type[ast.expr], Callable[[Reader, Any], Term]] = {
    ast.Constant: Reader._number,
    ast.Name: Reader._name,
    ast.UnaryOp: Reader._unary,
    ast.BinOp: Reader._binary,
    ast.Compare: Reader._comparison,
    ast.BoolOp: Reader._logic,
    ast.IfExp: Reader._choice,
    ast.Call: Reader._call,
}


def _joined(operator: Callable[[Any, Any], Any], left: Term, right: Term) -> Term:
    return lambda at: operator(left(at), right(at))
