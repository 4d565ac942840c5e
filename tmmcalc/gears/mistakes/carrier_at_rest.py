"""The ratio is that of the train with its carrier at rest: i_13^H = 1 - i_1H in place of i_1H (textbook 4.2, 4.19)."""

from __future__ import annotations

from math import isclose, nan

from tmmcalc.core.mistake import OFTEN, Asked, Mistake
from tmmcalc.naming.language import parse


def _reads(asked: Asked) -> float:
    name = parse(asked.name)
    if name.stage == "gearing" and name.what.startswith("i_"):
        return _of_network(asked)
    is_ratio = (name.stage, name.what) in (("criteria", "ratio"), ("train", "i_1H"))
    return 1 - asked.value if is_ratio and _has_carrier(asked.spec) else nan


def _of_network(asked: Asked) -> float:
    """That of a basic train, which alone has one, where a wheel over the carrier is asked for, whatever their names."""
    inverted = asked.another("gearing.i_inverted")
    return inverted if isclose(asked.value, 1 - inverted, rel_tol=1e-12) else nan


def _has_carrier(spec: object) -> bool:
    """Whether the ratio of all layouts among which is sought is that over the carrier; of AII it is over ring 4."""
    from tmmcalc.gears.kinds import kinds_of
    from tmmcalc.gears.layouts import LAYOUTS

    train = getattr(spec, "train", None)
    return train is not None and all("i_1H" in kinds_of(LAYOUTS[each]) for each in train.layout)


MISTAKE = Mistake(
    "the ratio is that of the train with its carrier at rest",
    "Does the carrier stand still here?",
    OFTEN,
    reads=_reads,
)
