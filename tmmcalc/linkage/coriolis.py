"""Kinematics with another part of the Coriolis acceleration, as mistakes have it."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any


def with_coriolis(part: float) -> Callable[..., Any]:
    """What stands in place of the stage where this part of the Coriolis acceleration is taken."""

    def amiss(solve: Callable[..., Any], *given: Any, **upstream: Any) -> Any:
        from tmmcalc.linkage.results import Terms

        return solve(*given, **upstream, terms=Terms(coriolis=part))

    return amiss


def moving_guide(spec: Any) -> bool:
    """Whether a guide is on a moving link, without which there is no such acceleration; of a linkage that is known."""
    joints = () if spec.mechanism is None else spec.mechanism.joints
    return any(joint.kind == "prismatic" and joint.links[1] for joint in joints)
