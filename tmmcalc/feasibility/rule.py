"""A rule that combines named constraints by and, or, not and brackets, read without running it as a program."""

from __future__ import annotations

import ast
from collections.abc import Mapping
from difflib import get_close_matches
from functools import reduce
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.errors import UsageError
from tmmcalc.core.expression.tree import NoTreeError, shown, syntax_tree
from tmmcalc.feasibility.logic import Form, Values, conjunction, disjunction, negation

DEEPEST = 150  # brackets or words within each other
EXAMPLE = 'combine names of constraints by and, or, not and brackets: "stroke and (light or not fast)"'


def names_of(rule: str, where: str = "feasibility.rule") -> list[str]:
    """The names in a rule, each once; raises `UsageError` for what is no rule.

    >>> names_of("stroke and (light or not fast)")
    ['stroke', 'light', 'fast']
    """
    nodes = (node for node in ast.walk(_tree(rule, where)) if isinstance(node, ast.Name))
    return list(dict.fromkeys(node.id for node in sorted(nodes, key=lambda node: (node.lineno, node.col_offset))))


def check_names(rule: str, known: list[str], where: str = "feasibility.rule") -> None:
    """Raise `UsageError` for a name that no constraint has."""
    for name in names_of(rule, where):
        if name not in known:
            near = get_close_matches(name, known, 1)
            guess = f'did you mean "{near[0]}"? ' if near else ""
            raise UsageError(
                f"no constraint is called {name!r}",
                where=where,
                remedy=f"{guess}the constraints are: {', '.join(known)}",
            )


def holds(rule: str, truths: Mapping[str, bool]) -> bool:
    """Whether a rule holds, by Boolean logic."""
    return bool(_truth(_tree(rule, ""), truths))


def failing(rule: str, truths: Mapping[str, bool]) -> list[str]:
    """The constraints for which a rule does not hold, in its order: none if it does.

    >>> failing("stroke and (light or not fast)", {"stroke": True, "light": False, "fast": True})
    ['light', 'fast']
    """
    tree = _tree(rule, "")
    return [] if _truth(tree, truths) else list(dict.fromkeys(_causes(tree, truths)))


def may_hold(rule: str, truths: Mapping[str, NDArray[np.bool_]], shape: tuple[int, ...]) -> NDArray[np.bool_]:
    """Where a rule may still hold, by those constraints whose truth is known (arrays of this shape).

    >>> may_hold("light and (swift or not loud)", {"light": np.array([True, False])}, (2,)).tolist()
    [True, False]
    """
    return _open(_tree(rule, ""), {name: (held, ~held) for name, held in truths.items()}, shape)[0]


def surely_holds(
    rule: str, truths: Mapping[str, tuple[NDArray[np.bool_], NDArray[np.bool_]]], shape: tuple[int, ...]
) -> NDArray[np.bool_]:
    """Where a rule holds, of constraints that surely hold, that surely do not, or of which neither is sure.

    Those that are not known here at all may yet be what suits.

    >>> sure, not_sure = (np.array([True]), np.array([False])), (np.array([False]), np.array([False]))
    >>> surely_holds("light and not loud", {"light": sure, "loud": not_sure}, (1,)).tolist()
    [False]
    """
    return _open(_tree(rule, ""), truths, shape)[0]


def function(rule: str, margins: Mapping[str, Values], form: Form, m: int) -> Values:
    """The function of a rule from those of its constraints: its sign is that of the logic (not on boundaries)."""
    return _function(_tree(rule, ""), margins, form, m)


def _tree(rule: str, where: str) -> ast.expr:
    """The syntax tree, of names, and, or, not alone."""
    try:
        tree = syntax_tree(rule, "a rule")
        _check(tree, 0)
    except NoTreeError as error:
        raise UsageError(f"{shown(rule)}: {error}", where=where, remedy=EXAMPLE) from None
    return tree


def _check(node: ast.expr, depth: int) -> None:
    if depth == DEEPEST:
        raise NoTreeError(f"nested deeper than {DEEPEST} times")
    if isinstance(node, ast.BoolOp):
        for value in node.values:
            _check(value, depth + 1)
    elif isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.Not):
        _check(node.operand, depth + 1)
    elif not isinstance(node, ast.Name):
        raise NoTreeError(f"{shown(ast.unparse(node))} is no name of a constraint")


def _truth(node: Any, truths: Mapping[str, bool]) -> bool:
    if isinstance(node, ast.Name):
        return truths[node.id]
    if isinstance(node, ast.UnaryOp):
        return not _truth(node.operand, truths)
    found = [_truth(value, truths) for value in node.values]
    return all(found) if isinstance(node.op, ast.And) else any(found)


def _open(
    node: Any, truths: Mapping[str, tuple[NDArray[np.bool_], NDArray[np.bool_]]], shape: tuple[int, ...]
) -> tuple[Any, Any]:
    """Where a node is true, and where it is false, by the same of its names: both where nothing is known."""
    if isinstance(node, ast.Name):
        return truths.get(node.id, (np.ones(shape, bool), np.ones(shape, bool)))
    if isinstance(node, ast.UnaryOp):
        yes, no = _open(node.operand, truths, shape)
        return no, yes
    parts = [_open(value, truths, shape) for value in node.values]
    both = np.logical_and.reduce, np.logical_or.reduce
    of_true, of_false = both if isinstance(node.op, ast.And) else both[::-1]
    return of_true([yes for yes, _ in parts]), of_false([no for _, no in parts])


def _causes(node: Any, truths: Mapping[str, bool]) -> list[str]:
    """The names that make a node what it is: the parts that decide it alone or together."""
    if isinstance(node, ast.Name):
        return [node.id]
    if isinstance(node, ast.UnaryOp):
        return _causes(node.operand, truths)
    state = _truth(node, truths)
    return [name for part in node.values if _truth(part, truths) == state for name in _causes(part, truths)]


def _function(node: Any, margins: Mapping[str, Values], form: Form, m: int) -> Values:
    if isinstance(node, ast.Name):
        return margins[node.id]
    if isinstance(node, ast.UnaryOp):
        return negation(_function(node.operand, margins, form, m))
    join = conjunction if isinstance(node.op, ast.And) else disjunction
    return reduce(lambda f, g: join(f, g, form, m), (_function(value, margins, form, m) for value in node.values))
