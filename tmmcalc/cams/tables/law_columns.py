"""The two columns of a file with a law of motion, by their names: the place in the phase and what is given of it."""

from __future__ import annotations

from collections.abc import Sequence

NO_HEADER = ("k", "s")  # what a file without a header holds
PLACES = {"k", "phi", "theta", "angle", "x", "i", "t", "n"}
VALUES = {
    "points": {"s", "ds", "h", "y", "psi", "dpsi", "beta", "lift", "displacement"},
    "acceleration": {"a", "s2", "s''", "y2", "y''", "psi2", "psi''", "acceleration"},
}


def law_columns(names: Sequence[str]) -> tuple[tuple[int, int], str] | None:
    """Where the place and the value stand among two names, and the key of the value; None if the names do not say.

    >>> law_columns(("k", "s")), law_columns(("S", "phi")), law_columns(("k", "a")), law_columns(("k", "v"))
    (((0, 1), 'points'), ((1, 0), 'points'), ((0, 1), 'acceleration'), None)
    """
    for order in ((0, 1), (1, 0)):
        place, value = (names[number].lower() for number in order)
        for key, known in VALUES.items():
            if place in PLACES and value in known:
                return order, key
    return None
