"""A formula of one variable, read without running it as a program: arithmetic, conditions, a closed list of functions.

The text is parsed into Python's syntax tree, and only the nodes listed here are translated. Every place where the
formula can jump or bend (the argument of abs or sign, the two sides of a comparison, the operands of min and max, the
ends of a remainder) gives a switch: a function that changes its sign there.
"""

from __future__ import annotations

import ast
import math
from collections.abc import Callable, Mapping
from difflib import get_close_matches
from functools import reduce
from typing import Any

import numpy as np

from tmmcalc.errors import UsageError
from tmmcalc.numerics.panels import Values
from tmmcalc.numerics.roots import bracketed
from tmmcalc.records import record

Term = Callable[[Values], Any]

LONGEST = 2000  # characters of a formula
DEEPEST = 150  # brackets, signs or terms within each other
SAMPLES = 1024  # of a switch over the range, between which its sign changes are sought
TABLE = "give the diagram as a table or in pieces"
ARITHMETIC = "+ - * / % ** and the functions"
DOMAIN = "keep roots, logarithms and quotients inside their domain, e.g. with max(0, ...) or a condition"

ANGLES = ("theta", "phi")
CONSTANTS = {"pi": math.pi, "e": math.e}
ONE_ARGUMENT: dict[str, Callable[[Any], Any]] = {
    "abs": np.abs,
    "acos": np.arccos,
    "asin": np.arcsin,
    "atan": np.arctan,
    "cos": np.cos,
    "degrees": np.degrees,
    "exp": np.exp,
    "log": np.log,
    "radians": np.radians,
    "sign": np.sign,
    "sin": np.sin,
    "sqrt": np.sqrt,
    "tan": np.tan,
}
SEVERAL: dict[str, Callable[[Any, Any], Any]] = {"max": np.maximum, "min": np.minimum}
OPERATORS: dict[type[ast.operator], Callable[[Any, Any], Any]] = {
    ast.Add: np.add,
    ast.Sub: np.subtract,
    ast.Mult: np.multiply,
    ast.Div: np.divide,
    ast.Mod: np.mod,
    ast.Pow: np.power,
}
COMPARISONS: dict[type[ast.cmpop], Callable[[Any, Any], Any]] = {
    ast.Lt: np.less,
    ast.LtE: np.less_equal,
    ast.Gt: np.greater,
    ast.GtE: np.greater_equal,
}


@record
class Formula:
    """A formula of one variable, by default the angle theta [rad], ready to be evaluated on arrays."""

    text: str
    term: Term  # (n,) values of the variable -> values
    switches: tuple[Term, ...]  # they change sign where the formula jumps or bends
    variables: tuple[str, ...] = ANGLES  # names of the variable
    where: str = "torque diagram"  # in messages

    def __call__(self, theta: Values) -> Values:
        """Values (n,) at the variable (n,); raises `UsageError` where the formula has no finite value."""
        with np.errstate(all="ignore"):
            values = np.array(np.broadcast_to(self.term(theta), theta.shape), float)
        bad = np.flatnonzero(~np.isfinite(values))
        if len(bad):
            at = float(theta[bad[0]])
            degrees = f" rad ({math.degrees(at):.4g} deg)" if self.variables == ANGLES else ""
            message = f"no finite value at {self.variables[0]} = {at:.6g}{degrees}"
            raise _fault(self.text, message, DOMAIN, self.where)
        return values

    def breaks(self, low: float, high: float) -> Values:
        """Places (m,) in [low, high] where the formula jumps or bends."""
        x = np.linspace(low, high, SAMPLES + 1)
        found = [_sign_changes(switch, x) for switch in self.switches]
        return np.concatenate(found) if found else np.empty(0)


@record
class Field:
    """A formula of several variables, ready to be evaluated on arrays."""

    text: str
    term: Term  # (d, n) values of the variables -> values
    variables: tuple[str, ...]
    where: str  # in messages

    def __call__(self, *at: Values) -> Values:
        """Values (n,) at the variables (n,) each; raises `UsageError` where the formula has no finite value."""
        places = np.array(at)
        with np.errstate(all="ignore"):
            values = np.array(np.broadcast_to(self.term(places), places.shape[1:]), float)
        bad = np.flatnonzero(~np.isfinite(values))
        if len(bad):
            named = zip(self.variables, places[:, bad[0]].tolist(), strict=True)
            message = f"no finite value at {', '.join(f'{name} = {value:.6g}' for name, value in named)}"
            raise _fault(self.text, message, DOMAIN, self.where)
        return values


def parse(
    text: str,
    constants: Mapping[str, float] | None = None,
    variables: tuple[str, ...] = ANGLES,
    where: str = "torque diagram",
) -> Formula:
    """Read a formula of ``theta`` (or ``phi``) [rad], or of other ``variables``; ``constants`` adds named numbers.

    Operators + - * / % **, comparisons, and, or, not, ``a if condition else b``, the constants pi and e,
    and the functions of `ONE_ARGUMENT` and `SEVERAL`. Raises `UsageError` with the column of the fault.

    >>> formula = parse("M * max(0, sin(theta))", {"M": 50})
    >>> formula(np.array([0.5 * np.pi, 1.5 * np.pi])).tolist()
    [50.0, 0.0]
    """
    tree = _tree(text, variables, where)
    reader = _Reader(text.strip(), {**CONSTANTS, **(constants or {})}, variables, where)
    term = reader.read(tree.body)
    return Formula(text.strip(), term, tuple(reader.switches), variables, where)


def parse_field(text: str, variables: tuple[str, ...], where: str) -> Field:
    """Read a formula of several variables that differ, as `parse` reads one of a single variable.

    >>> parse_field("x**2 + y", ("x", "y"), "gap")(np.array([3.0, 1.0]), np.array([1.0, 2.0])).tolist()
    [10.0, 3.0]
    """
    tree = _tree(text, variables, where)
    term = _FieldReader(text.strip(), CONSTANTS, variables, where).read(tree.body)
    return Field(text.strip(), term, variables, where)


def _tree(text: str, variables: tuple[str, ...], where: str) -> ast.Expression:
    if len(text) > LONGEST:
        raise _fault(text[:40] + "...", f"longer than {LONGEST} characters", TABLE, where)
    try:
        return ast.parse(text.strip(), mode="eval")
    except (SyntaxError, ValueError, RecursionError, MemoryError) as error:
        column = getattr(error, "offset", None)
        at = f" at column {column}" if column else ""
        raise _fault(text, f"not a formula{at}", _example(variables), where) from None


def _example(variables: tuple[str, ...]) -> str:
    terms = "M0 * (1 + 0.3*sin(2*theta))" if variables == ANGLES else f"1 + 0.3*sin(2*{variables[0]})"
    return f"write it as in {terms}"


def _sign_changes(switch: Term, x: Values) -> Values:
    def value(at: Values) -> Values:
        with np.errstate(all="ignore"):
            return np.nan_to_num(np.broadcast_to(np.asarray(switch(at), float), at.shape))

    sampled = np.signbit(value(x))
    k = np.flatnonzero(sampled[1:] != sampled[:-1])
    return bracketed(lambda at, which: value(at), x[k], x[k + 1])


def _fault(text: str, message: str, remedy: str, where: str) -> UsageError:
    return UsageError(f"formula {text!r}: {message}", where=where, remedy=remedy)


class _Reader:
    """Translates the nodes of one formula and collects its switches on the way."""

    def __init__(self, text: str, names: Mapping[str, float], variables: tuple[str, ...], where: str) -> None:
        self.text = text
        self.names = names
        self.variables = variables
        self.where = where
        self.switches: list[Term] = []
        self.depth = 0

    def read(self, node: ast.expr) -> Term:
        """The node as a function of the angle."""
        kinds: dict[type[ast.expr], Callable[[Any], Term]] = {
            ast.Constant: self._number,
            ast.Name: self._name,
            ast.UnaryOp: self._unary,
            ast.BinOp: self._binary,
            ast.Compare: self._comparison,
            ast.BoolOp: self._logic,
            ast.IfExp: self._choice,
            ast.Call: self._call,
        }
        kind = kinds.get(type(node))
        if kind is None:
            raise self._refusal(node, "this is not arithmetic", f"use numbers, {self.variables[0]}, {ARITHMETIC}")
        if self.depth == DEEPEST:
            raise self._refusal(node, f"nested deeper than {DEEPEST} times", TABLE)
        self.depth += 1
        term = kind(node)
        self.depth -= 1
        return term

    def _refusal(self, node: ast.expr, message: str, remedy: str) -> UsageError:
        return _fault(self.text, f"{message} at column {node.col_offset + 1}", remedy, self.where)

    def _number(self, node: ast.Constant) -> Term:
        if isinstance(node.value, bool) or not isinstance(node.value, (int, float)):
            raise self._refusal(node, f"{node.value!r} is not a real number", "write numbers as 12, 0.5 or 1e3")
        try:
            value = float(node.value)
        except OverflowError:
            raise self._refusal(node, "a number too large", "write numbers below 1e308") from None
        return lambda theta: value

    def _name(self, node: ast.Name) -> Term:
        if node.id in self.variables:
            return lambda theta: theta
        if node.id not in self.names:
            raise self._unknown(node, "name", node.id, [*self.variables, *self.names])
        value = float(self.names[node.id])
        return lambda theta: value

    def _unknown(self, node: ast.expr, kind: str, name: str, known: list[str]) -> UsageError:
        close = get_close_matches(name, known, 1)
        hint = f"perhaps you meant {close[0]}; " if close else ""
        return self._refusal(node, f"unknown {kind} {name!r}", f"{hint}known: {', '.join(sorted(known))}")

    def _unary(self, node: ast.UnaryOp) -> Term:
        inner = self.read(node.operand)
        if isinstance(node.op, ast.USub):
            return lambda theta: np.negative(inner(theta))
        if isinstance(node.op, ast.UAdd):
            return inner
        if isinstance(node.op, ast.Not):
            return lambda theta: np.logical_not(inner(theta))
        raise self._refusal(node, "this operator is not arithmetic", "use + - * / % **")

    def _binary(self, node: ast.BinOp) -> Term:
        operator = OPERATORS.get(type(node.op))
        if operator is None:
            power = isinstance(node.op, ast.BitXor)
            remedy = "a power is written **" if power else "use + - * / % **"
            raise self._refusal(node, "this operator is not arithmetic", remedy)
        left, right = self.read(node.left), self.read(node.right)
        if isinstance(node.op, ast.Mod):
            self.switches.append(lambda theta: np.sin(np.pi * np.divide(left(theta), right(theta))))
        return lambda theta: operator(np.asarray(left(theta), float), right(theta))

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
        return lambda theta: reduce(np.logical_and, (part(theta) for part in parts))

    def _logic(self, node: ast.BoolOp) -> Term:
        parts = [self.read(value) for value in node.values]
        join = np.logical_and if isinstance(node.op, ast.And) else np.logical_or
        return lambda theta: reduce(join, (part(theta) for part in parts))

    def _choice(self, node: ast.IfExp) -> Term:
        test, yes, no = self.read(node.test), self.read(node.body), self.read(node.orelse)
        return lambda theta: np.where(test(theta), yes(theta), no(theta))

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
        return lambda theta: function(argument(theta))

    def _largest_or_smallest(self, choose: Callable[[Any, Any], Any], arguments: list[Term]) -> Term:
        for i, first in enumerate(arguments):
            self.switches.extend(_joined(np.subtract, first, second) for second in arguments[i + 1 :])
        return lambda theta: reduce(choose, (argument(theta) for argument in arguments))


class _FieldReader(_Reader):
    """Reads a formula of several variables: a term takes their values as rows."""

    def _name(self, node: ast.Name) -> Term:
        if node.id in self.variables:
            row = self.variables.index(node.id)
            return lambda at: at[row]
        return super()._name(node)


def _joined(operator: Callable[[Any, Any], Any], left: Term, right: Term) -> Term:
    return lambda theta: operator(left(theta), right(theta))
