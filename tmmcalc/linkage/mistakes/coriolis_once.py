"""The Coriolis acceleration is taken once and not twice (textbook 2.8.2)."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tmmcalc.core.mistake import SOMETIMES, Mistake


def _amiss(solve: Callable[..., Any], *given: Any, **upstream: Any) -> Any:
    from tmmcalc.linkage.results import Terms

    return solve(*given, **upstream, terms=Terms(coriolis=0.5))


def _moving_guide(spec: Any) -> bool:
    """Whether a guide is on a moving link."""
    return any(joint.kind == "prismatic" and joint.links[1] for joint in spec.linkage.joints)


MISTAKE = Mistake(
    "the Coriolis acceleration has 1 in place of 2",
    "Look at the Coriolis acceleration: how is its size made of angular velocity and relative velocity?",
    SOMETIMES,
    stages={"kinematics": _amiss},
    applies=_moving_guide,
)
