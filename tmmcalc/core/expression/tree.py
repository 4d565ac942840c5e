"""The syntax tree of one expression; what it may hold is for the reader of the tree to say."""

from __future__ import annotations

import ast
import warnings

LONGEST = 2000  # characters of an expression
SHOWN = 60  # of one in a message


class NoTreeError(ValueError):
    """A text that is no expression, or too long for one: what is wrong in words."""


def syntax_tree(text: str, what: str) -> ast.expr:
    """The tree of an expression in Python's grammar, never run; raises `NoTreeError`: not ``what`` at a column."""
    if len(text) > LONGEST:
        raise NoTreeError(f"longer than {LONGEST} characters")
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of the grammar of programs, to people who write none
            return ast.parse(text.strip(), mode="eval").body
    except (SyntaxError, ValueError, RecursionError, MemoryError) as error:
        column = getattr(error, "offset", None)
        raise NoTreeError(f"not {what} at column {column}" if column else f"not {what}") from None


def shown(text: str) -> str:
    """The text in quotes, cut to what a message has room for.

    >>> shown("a + b")
    "'a + b'"
    """
    return repr(text) if len(text) <= SHOWN else repr(text[: SHOWN - 4] + " ...")
