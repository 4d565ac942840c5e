"""The ways to find a cam's spring: which keys each has, and which is taken if none is named."""

from __future__ import annotations

from collections.abc import Container

# method: the keys that it has beside those of the wire
SPRING_KEYS = {
    "safety": ("safety", "exact"),
    "given": ("stiffness", "preload"),
    "preload": ("deflection", "least_contact"),
    "none": (),
}
WIRE_KEYS = ("wire", "coil", "shear_modulus", "shear_stress", "dead_coils")


def spring_method(keys: Container[str]) -> str:
    """What the keys that are there belong to.

    >>> spring_method({"stiffness", "preload"}), spring_method({"wire", "coil"})
    ('given', 'safety')
    """
    return next(
        (method for method in ("given", "preload") if any(key in keys for key in SPRING_KEYS[method])), "safety"
    )
