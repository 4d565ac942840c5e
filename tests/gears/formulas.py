"""Formulas with numbers worked out by Python itself, which shares nothing with the code that wrote them."""

from __future__ import annotations

import ast
import math
import operator
from typing import Any

FUNCTIONS = {
    **{name: getattr(math, name) for name in ("sin", "cos", "tan", "asin", "acos", "atan", "gcd", "floor", "ceil")},
    "abs": abs,
    "min": min,
    "max": max,
}
OPERATORS: dict[type, Any] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.Pow: operator.pow,
    ast.USub: operator.neg,
}


def worked(text: str) -> float:
    """The value of an arithmetic text; names that are left are a fault."""
    return float(_worked(ast.parse(text.strip(), mode="eval").body))


def _worked(node: ast.expr) -> Any:
    if isinstance(node, ast.Constant):
        return node.value
    if isinstance(node, ast.Name) and node.id == "pi":
        return math.pi
    if isinstance(node, ast.UnaryOp):
        return OPERATORS[type(node.op)](_worked(node.operand))
    if isinstance(node, ast.BinOp):
        return OPERATORS[type(node.op)](_worked(node.left), _worked(node.right))
    assert isinstance(node, ast.Call)
    assert isinstance(node.func, ast.Name)
    return FUNCTIONS[node.func.id](*map(_worked, node.args))
