"""The Coriolis acceleration is left out (textbook 2.8.2)."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tmmcalc.core.mistake import OFTEN, Mistake


def _amiss(solve: Callable[..., Any], *given: Any, **upstream: Any) -> Any:
    from tmmcalc.linkage.results import Terms

    return solve(*given, **upstream, terms=Terms(coriolis=0.0))


def _moving_guide(spec: Any) -> bool:
    """Whether a guide is on a moving link."""
    return any(joint.kind == "prismatic" and joint.links[1] for joint in spec.linkage.joints)


MISTAKE = Mistake(
    "the Coriolis acceleration is left out",
    "Look at the slider on the link that turns: are all terms of its acceleration there?",
    OFTEN,
    stages={"kinematics": _amiss},
    applies=_moving_guide,
)
