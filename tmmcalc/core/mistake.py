"""Mistakes that are known from teaching, made on purpose: what a result is if somebody makes one.

A mistake is a module in the folder ``mistakes`` of a room, with ``MISTAKE``. It says in one of three ways what comes of
it:

    tables   another spec: the tables of the document that are other; the error goes on through all later stages
    stages   another stage: what stands in place of the function of a stage; later stages go on with what it gives
    reads    read off wrongly: what is given in place of one value; nothing else is wrong

and applies by itself where it can be made: another spec that is none, a stage that a scene has not, and a value that
cannot be read so change nothing.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import field
from typing import Any

from tmmcalc.core.records import record

OFTEN, SOMETIMES, SELDOM = 1, 2, 3  # how common a mistake is: of several that fit, the commoner is told first

Document = Mapping[str, Any]  # the tables of a spec as they stand in its text
Tables = dict[str, Any]
Amiss = Callable[..., Any]


@record
class Asked:
    """One value that is asked for, as somebody may read it off wrongly; values are in the unit that is asked for."""

    name: str  # in the language of results, with its stage
    unit: str  # that is asked for; empty: none
    meaning: str
    value: float
    scale: float  # of the unit that is asked for against that of the result
    another: Callable[[str], float]  # the value of another name, scaled alike; NaN where it has none
    spec: Any


@record
class Mistake:
    """A mistake: how it is told, how common it is, and what comes of it, by one of ``tables``, ``stages``, ``reads``.

    ``tables(document, part)``   the tables that are other, {} where it cannot be made
    ``stages[name](solve, *inputs, **upstream)``   the result of a stage, whose own function is ``solve``
    ``reads(asked)``             the value that is given, NaN where it cannot be read so
    ``parts(spec)``              what it may be made in, one at a time, if there are several such places
    ``applies(spec)``            of ``stages``: whether it can be made in a scene that has them
    """

    title: str  # for the teacher
    hint: str  # for the student: where to look, without a number
    common: int
    tables: Callable[[Document, str], Tables] | None = None
    stages: Mapping[str, Amiss] = field(default_factory=dict)
    reads: Callable[[Asked], float] | None = None
    parts: Callable[[Any], Sequence[str]] = lambda spec: ("",)
    applies: Callable[[Any], bool] = lambda spec: True

    @property
    def single(self) -> bool:
        """Whether it is made in one answer; else all answers of a solution show it."""
        return self.reads is not None
