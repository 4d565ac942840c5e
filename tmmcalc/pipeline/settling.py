"""A stage that settles the spec: what it found takes its place there, and the stages after it read that.

So a linkage that is asked for by what it is to do, `[synthesis]`, may stand in one spec with its motor and flywheel.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from tmmcalc.core.manifest import TABLES
from tmmcalc.core.plan import Plan, plan
from tmmcalc.core.stage import Stage

if TYPE_CHECKING:
    from tmmcalc.project import Spec
    from tmmcalc.spec.rewrite import Found

_APART = ("constraints", "feasibility", "sheets")  # tables on the solutions themselves, which need no mechanism


def settling(
    spec: Any, target: str | Sequence[str] | None, stages: Mapping[str, Stage], skip: Collection[str] = ()
) -> Stage | None:
    """The stage that has to settle a spec before the others can be planned; None if there is none.

    A spec that asks for a linkage alone is about the solutions: the best one is a mechanism where other tables are
    there, or a stage that needs one is the target.
    """
    targets = (target,) if isinstance(target, str) else tuple(target or ())
    for stage in stages.values():
        if not stage.settles or stage.name in skip or targets == (stage.name,) or stage.unwanted(spec) is not None:
            continue
        entry = TABLES[stage.asked[0]]
        if getattr(spec, entry.gives):
            continue
        others = [name for name in TABLES if name not in (entry.name, *_APART) and getattr(spec, name)]
        if others or not {*targets} <= {*plan(spec, target, stages, skip).running}:
            return stage
    return None


def outlook(
    spec: Any, target: str | Sequence[str] | None, stages: Mapping[str, Stage], skip: Collection[str] = ()
) -> Any:
    """The spec as far as a plan asks, also where what settles it is not found yet."""
    stage = settling(spec, target, stages, skip)
    return spec if stage is None else spec.model_copy(update=stage.part("outlook")())


def planned(
    spec: Any,
    target: str | Sequence[str] | None,
    stages: Mapping[str, Stage],
    skip: Collection[str] = (),
    first: Stage | None = None,
) -> Plan:
    """The plan of a spec as `outlook` has it; ``first`` is the stage that has settled it, if that is done already."""
    first = first or settling(spec, target, stages, skip)
    scene = plan(outlook(spec, target, stages, skip), target, stages, skip)
    if first is None:
        return scene
    reason = f"finds the {TABLES[first.asked[0]].gives}"
    steps = (replace(each, runs=True, reason=reason, asked=True) if each.stage == first.name else each
             for each in scene.steps)  # fmt: skip
    return replace(scene, steps=tuple(steps))


def settled(spec: Any, found: Found) -> Spec:
    """The spec with the tables that were found; raises SpecError where the others do not fit them."""
    import tomllib  # late: few specs are settled

    from tmmcalc.project.loader import with_tables

    return with_tables(spec, tomllib.loads(found.tables))
