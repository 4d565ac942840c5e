"""What is typeset of a formula: letters, numbers, signs, fractions, roots, brackets, indices; no format is known."""

from __future__ import annotations

from typing import NamedTuple


class Letter(NamedTuple):
    """A single letter of a quantity, italic unless it is a capital Greek one."""

    text: str


class Word(NamedTuple):
    """Upright letters: a function, an index, a unit."""

    text: str


class Digits(NamedTuple):
    """A number as it is printed, with a decimal point; its minus sign is a true one."""

    text: str


class Sign(NamedTuple):
    """An operator or a relation; ``main`` ones stand between the terms or the sides of a whole line."""

    text: str
    main: bool = False
    leads: bool = False  # a minus before the first term


class Gap(NamedTuple):
    """A thin space, between factors."""


class Row(NamedTuple):
    """Boxes one after another."""

    boxes: tuple[Box, ...]


class Fraction(NamedTuple):
    """One over another."""

    over: Box
    under: Box


class Root(NamedTuple):
    """A root: a square one, or of a degree."""

    inner: Box
    degree: Box | None = None


class Marked(NamedTuple):
    """A number with a sign right after it: degrees."""

    inner: Box
    mark: str


class Script(NamedTuple):
    """A box with an index, an upper index, primes."""

    base: Box
    lower: Box | None = None
    upper: Box | None = None
    primes: int = 0


class Fenced(NamedTuple):
    """A box in brackets that are as high as it is."""

    inner: Box
    opening: str = "("
    closing: str = ")"


class Big(NamedTuple):
    """A sign with an index below it, before what it is over: a sum."""

    sign: str
    lower: Box
    body: Box


class Arrowed(NamedTuple):
    """A vector: a box under an arrow."""

    inner: Box


Box = Letter | Word | Digits | Sign | Gap | Row | Fraction | Root | Marked | Script | Fenced | Big | Arrowed


def inner(box: Box) -> tuple[Box, ...]:
    """The boxes of which one is made."""
    match box:
        case Row(boxes):
            return boxes
        case Fraction(over, under):
            return over, under
        case Root(each) | Marked(each) | Fenced(each) | Arrowed(each):
            return (each,)
        case Big(_, lower, body):
            return lower, body
        case Script(base, lower, upper):
            return tuple(each for each in (base, lower, upper) if each is not None)
        case _:
            return ()
