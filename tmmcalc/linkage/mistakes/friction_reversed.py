"""Friction acts in the wrong sense: it helps."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from tmmcalc.core.mistake import SOMETIMES, Mistake


def _amiss(solve: Callable[..., Any], mechanism: Any, loading: Any, *given: Any, **upstream: Any) -> Any:
    return solve(mechanism, replace(loading, friction_sense="along"), *given, **upstream)


def _rubs(spec: Any) -> bool:
    return spec.mechanism is not None and any(joint.friction for joint in spec.mechanism.joints)


MISTAKE = Mistake(
    "friction acts in the wrong sense",
    "Look at the sense of the relative motion in every pair that rubs: which way does friction act?",
    SOMETIMES,
    stages={"forces": _amiss, "reduction": _amiss},
    applies=_rubs,
)
