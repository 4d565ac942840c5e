"""The ways to find a cam's spring: which keys each has, and which is taken if none is named."""

from __future__ import annotations

from collections.abc import Container, Mapping
from typing import Literal

SpringMethod = Literal["none", "given", "safety", "preload"]
# method: the keys that it has beside those of the wire
SPRING_KEYS: Mapping[SpringMethod, tuple[str, ...]] = {
    "safety": ("safety", "exact"),
    "given": ("stiffness", "preload"),
    "preload": ("deflection", "least_contact"),
    "none": (),
}
WAYS: tuple[SpringMethod, ...] = ("given", "preload")  # those whose keys say that they are meant, in this order
WIRE_KEYS = ("wire", "coil", "shear_modulus", "shear_stress", "dead_coils")


def spring_method(keys: Container[str]) -> SpringMethod:
    """What the keys that are there belong to.

    >>> spring_method({"stiffness", "preload"}), spring_method({"wire", "coil"})
    ('given', 'safety')
    """
    asked = (method for method in WAYS if any(key in keys for key in SPRING_KEYS[method]))
    return next(asked, "safety")
