"""Loads of a grab transloader by case, and the factors of its allowed stresses: tables of the source as data."""

from __future__ import annotations

from typing import NamedTuple


class Load(NamedTuple):
    """A load, and whether it acts in each case: "+" it does, "-" it does not, "?" the source left it blank."""

    meaning: str
    acts: str  # a sign for each of CASES


CASES = {
    "A": "endurance and strength, main loads",
    "B1": "strength, main and additional loads",
    "B2": "strength, main, additional and accidental loads",
    "V1": "out of service, main loads",
    "V2": "out of service, main and accidental loads",
}
LOADS = {
    "dead_weight": Load("dead weight", "+++++"),
    "rated_load": Load("rated load", "+++--"),
    "inertia": Load("inertia in normal operation", "+----"),
    "wind": Load("wind", "-+++-"),
    "equivalent_wind": Load("equivalent wind", "+--??"),
    "track": Load("track gradient, rocking of the crane", "+++++"),
    "drive": Load("largest moments of drives, skidding, their inertia", "-+---"),
    "shock": Load("shock", "--+--"),
    "hurricane": Load("hurricane wind", "---?+"),
    "seismic": Load("seismic", "----+"),
}
OF_WEIGHT = ("dead_weight", "rated_load")  # with a sense of their own; others act in either

VERY_HEAVY = "very heavy"
DUTIES = {"light": 1.0, "medium": 1.1, "heavy": 1.2, VERY_HEAVY: 1.3}  # K2


class Mechanism(NamedTuple):
    """A mechanism: K1 in the cases A, B and V, None where the source has none, and its duty."""

    importance: tuple[float | None, float | None, float | None]
    duty: str


MECHANISMS = {
    "hoist": Mechanism((1.2, 1.1, None), VERY_HEAVY),
    "closing": Mechanism((1.2, 1.1, None), VERY_HEAVY),
    "trolley": Mechanism((1.2, 1.1, None), VERY_HEAVY),
    "slewing": Mechanism((1.2, 1.1, None), "heavy"),
    "luffing": Mechanism((1.4, 1.3, 1.3), "heavy"),
    "rail clamps": Mechanism((1.5, 1.4, 1.3), "light"),
    "bridge": Mechanism((None, None, None), "light"),
    "boom crane": Mechanism((None, None, None), VERY_HEAVY),  # light with conveyors built into the transloader
}
MAKINGS = {"rolled": 1.1, "forged": 1.1, "cast": 1.3}  # K_n against fatigue; 1.0 against static stress
SERIES = (10, 12.5, 16, 20, 25, 32, 40, 50)  # rated capacities [t], GOST 1575-61
PARTS_OF_MASS = {"structure": 0.65, "mechanisms": 0.30, "electrical": 0.05}


def acts(load: str, case: str, blanks: bool) -> bool:
    """Whether a load acts in a case; ``blanks`` is what is held of those that the source left blank.

    >>> acts("wind", "A", True), acts("hurricane", "V1", True), acts("hurricane", "V1", False)
    (False, True, False)
    """
    sign = LOADS[load].acts[list(CASES).index(case)]
    return sign == "+" or (blanks and sign == "?")
