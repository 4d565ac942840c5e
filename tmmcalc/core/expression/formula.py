"""A formula of one variable, or a field of several, read from its text: arithmetic, conditions, a list of functions."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.core.expression.reader import Reader, Term, fault
from tmmcalc.core.expression.tree import NoTreeError, syntax_tree
from tmmcalc.core.expression.words import CONSTANTS
from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.numerics.roots import bracketed
from tmmcalc.core.records import record

SAMPLES = 1024  # of a switch over the range, between which its sign changes are sought
TABLE = "give the diagram as a table or in pieces"
DOMAIN = "keep roots, logarithms and quotients inside their domain, e.g. with max(0, ...) or a condition"

ANGLES = ("theta", "phi")  # two names of one variable


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
        values, bad = _values(self.term, theta, theta.shape)
        if bad is not None:
            at = float(theta[bad])
            degrees = f" rad ({math.degrees(at):.4g} deg)" if self.variables == ANGLES else ""
            raise _undefined(self, f"{self.variables[0]} = {at:.6g}{degrees}")
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
        values, bad = _values(self.term, places, places.shape[1:])
        if bad is not None:
            named = zip(self.variables, places[:, bad].tolist(), strict=True)
            raise _undefined(self, ", ".join(f"{name} = {value:.6g}" for name, value in named))
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
    itself: dict[str, Term] = dict.fromkeys(variables, lambda x: x)
    reader, term = _read(text, itself, constants or {}, where)
    return Formula(reader.text, term, tuple(reader.switches), variables, where)


def parse_field(text: str, variables: tuple[str, ...], where: str) -> Field:
    """Read a formula of several variables that differ, as `parse` reads one of a single variable.

    >>> parse_field("x**2 + y", ("x", "y"), "gap")(np.array([3.0, 1.0]), np.array([1.0, 2.0])).tolist()
    [10.0, 3.0]
    """
    rows = {name: _row(k) for k, name in enumerate(variables)}
    reader, term = _read(text, rows, {}, where)
    return Field(reader.text, term, variables, where)


def _row(k: int) -> Term:
    return lambda places: places[k]


def _read(text: str, variables: Mapping[str, Term], constants: Mapping[str, float], where: str) -> tuple[Reader, Term]:
    first = next(iter(variables))
    try:
        tree = syntax_tree(text, "a formula")
    except NoTreeError as error:
        raise fault(text, str(error), f"write it as in {_example(first)}", where) from None
    deep = TABLE if first in ANGLES else "write it with fewer brackets"
    reader = Reader(text.strip(), {**CONSTANTS, **constants, **variables}, where, deep)
    return reader, reader.read(tree)


def _example(variable: str) -> str:
    return "M0 * (1 + 0.3*sin(2*theta))" if variable in ANGLES else f"1 + 0.3*sin(2*{variable})"


def _values(term: Term, at: Values, shape: tuple[int, ...]) -> tuple[Values, int | None]:
    """Values of a term in this shape, and the first index at which one is not finite."""
    with np.errstate(all="ignore"):
        values = np.array(np.broadcast_to(term(at), shape), float)
    bad = np.flatnonzero(~np.isfinite(values))
    return values, int(bad[0]) if len(bad) else None


def _undefined(of: Formula | Field, place: str) -> UsageError:
    return fault(of.text, f"no finite value at {place}", DOMAIN, of.where)


def _sign_changes(switch: Term, x: Values) -> Values:
    def value(at: Values) -> Values:
        with np.errstate(all="ignore"):
            return np.nan_to_num(np.broadcast_to(np.asarray(switch(at), float), at.shape))

    sampled = np.signbit(value(x))
    k = np.flatnonzero(sampled[1:] != sampled[:-1])
    return bracketed(lambda at, which: value(at), x[k], x[k + 1])
