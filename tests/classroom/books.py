"""Keys of classes that tests mark, and the files that their students hand in."""

from __future__ import annotations

import math
from collections.abc import Sequence

from tmmcalc.classroom.model import Item, Key, Keybook, Told


def item(name: str, *also: str, result: str = "", unit: str = "", **more: object) -> Item:
    """An item with the tolerances of ``[class]``."""
    settled: dict[str, object] = {
        "tolerance": 0.01,
        "within": 0.0,
        "plans": 0.03,
        "weight": 1.0,
        "digits": 4,
        "after": (),
        "either_sense": False,
    } | more
    return Item(name=name, also=also, result=result or f"kinematics.{name}", unit=unit, **settled)


PRESS = (
    item("stroke H", "H", "хід", result="kinematics.stroke_D", unit="mm"),
    item("omega_2", "ω2", result="kinematics.omega_2@3", unit="rad/s"),
    item("K", "коефіцієнт K", result="kinematics.K"),
    item("forces.R_A@3", "реакція R_A@3", result="forces.R_A@3", unit="kN"),
    item("forces.R_A@7", result="forces.R_A@7", unit="kN"),
    item("v_D", result="kinematics.vS_D[phi=45 deg]", unit="m/s", either_sense=True),
)
STUDENTS = ("Бондар Іван", "Коваль Олена", "Мельник Петро", "Шевченко Ірина", "Шевчук Олег")
VALUES = (
    (120.5, 3.25, 1.213, 4.512, 6.03, -0.812),
    (131.2, 2.875, 1.301, 3.918, 5.44, -0.745),
    (118.4, 3.012, 1.188, 4.105, 5.91, -0.803),
    (142.7, 2.654, 1.342, 5.233, 7.12, -0.921),
    (127.9, 3.456, 1.255, 4.876, 6.55, -0.866),
)


def press_class(mistakes: Sequence[Told] = (), mistaken: Sequence[Sequence[float]] = ()) -> Keybook:
    """A class of five with six items; ``mistaken`` are ratios of what each mistake gives to what is right."""
    keys = tuple(
        Key(k + 1, name, right, tuple(tuple(a * b for a, b in zip(ratios, right, strict=True)) for ratios in mistaken))
        for k, (name, right) in enumerate(zip(STUDENTS, VALUES, strict=True))
    )
    return Keybook(PRESS, tuple(mistakes), keys)


def nothing(count: int) -> list[float]:
    """A mistake that changes nothing."""
    return [math.nan] * count
