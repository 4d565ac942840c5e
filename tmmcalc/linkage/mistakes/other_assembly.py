"""One group is on its other assembly variant (textbook 2.5)."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

from tmmcalc.core.mistake import OFTEN, Mistake


def _amiss(solve: Callable[..., Any], mechanism: Any, *given: Any, part: str, **upstream: Any) -> Any:
    right = solve(mechanism, *given, **upstream)
    from tmmcalc.linkage.model import Assembly

    signs = {group.links: right.variants[group.name] for group in right.structure.groups}
    signs |= {group.links: -signs[group.links] for group in right.structure.groups if _named(group) == part}
    return solve(replace(mechanism, assembly=Assembly(variants=signs)), *given, **upstream)


def _groups(spec: Any) -> Sequence[str]:
    """The dyads with two assembly variants; none where a higher group is beside them."""
    from tmmcalc.linkage.dyads import ONE_ASSEMBLY
    from tmmcalc.linkage.structure import solve_structure
    from tmmcalc.linkage.tables.tasks.mechanism import to_linkage

    groups = solve_structure(to_linkage(spec.linkage)).groups
    if not all(group.kind for group in groups):
        return ()
    return [_named(group) for group in groups if group.kind not in ONE_ASSEMBLY]


def _named(group: Any) -> str:
    return "-".join(map(str, group.links))


MISTAKE = Mistake(
    "the other assembly variant of the group",
    "Compare your scheme with that of the task: is every joint on the right side?",
    OFTEN,
    stages={"kinematics": _amiss},
    parts=_groups,
    applies=lambda spec: spec.mechanism is not None,
)
