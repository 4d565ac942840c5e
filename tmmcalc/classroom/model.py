"""What is asked of a class, and what is right of each variant: the plain data that all parts of the room share."""

from __future__ import annotations

from tmmcalc.core.records import record

Values = tuple[float, ...]


@record
class Item:
    """A result that every student is asked for."""

    name: str  # in sheets and answers
    also: tuple[str, ...]  # what else it may be called there
    result: str  # its name in the language of results, with its stage
    unit: str  # in which it is asked, empty: none
    tolerance: float  # relative, within which an answer is right
    within: float  # the same absolute, in the unit; the larger of both counts
    plans: float  # relative accuracy of plans
    weight: float  # points
    digits: int  # significant ones, which are asked for
    after: tuple[int, ...]  # items by place, from which it is computed
    either_sense: bool  # its sign is left open
    powers: Values = ()  # with which it follows each of `after`; 0: not told
    meaning: str = ""  # as the assignment says it; empty: as the program does


@record
class Told:
    """A mistake as it is told: to the teacher, and to the student without a number."""

    name: str  # "linkage.coriolis_left_out": its room and file
    title: str
    hint: str
    single: bool  # it is made in one answer; else in a whole solution, whose answers all show it
    common: float = 1.0  # how often it is made beside others


@record
class Key:
    """What is right of a variant, and what comes out where a mistake is made."""

    number: int  # of the variant, from 1
    student: str  # of the roster; empty without one
    values: Values  # (I,) of the items, in their units
    mistaken: tuple[Values, ...]  # (M, I) by mistake; NaN where it changes nothing or gives no number


@record
class Keybook:
    """The keys of a class."""

    items: tuple[Item, ...]
    mistakes: tuple[Told, ...]
    keys: tuple[Key, ...]
    made_of: tuple[str, ...] = ()  # hash of what each key was made of; empty: not told
