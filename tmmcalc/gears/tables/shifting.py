"""The ways to choose the shifts of a pair: which a kind of pair has, and which is taken if none is named."""

from __future__ import annotations

from collections.abc import Container

STRATEGIES = (
    "given",
    "given_aw",
    "max_contact_strength",
    "equal_sliding",
    "max_contact_ratio",
    "zero",
    "equal_shift",
    "equal_strength",
    "balanced",
)
SPLITS = ("equal_sliding", "equal_strength", "max_contact_ratio", "middle")
OF_KIND = {
    "external": STRATEGIES,
    "internal": ("given", "given_aw", "zero", "equal_shift", "balanced"),
    "rack": ("given", "zero", "balanced"),
}


def usual_strategy(keys: Container[str], kind: str, of_train: bool) -> str:
    """What follows from the keys that are there; a train has its centre distances.

    >>> usual_strategy({"x1", "x2"}, "external", False), usual_strategy({"x1", "centre_distance"}, "internal", False)
    ('given', 'given_aw')
    """
    if "x1" in keys and ("x2" in keys or kind == "rack"):
        return "given"
    if of_train or ("centre_distance" in keys and kind != "rack"):
        return "given_aw"
    return "balanced" if kind == "external" else "zero"
