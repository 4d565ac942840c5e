"""What the synthesis of linkages found as a table ``[mechanism]``."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from tmmcalc.report.rows import CHOOSE, check_choice
from tmmcalc.spec.rewrite import Change, Found

if TYPE_CHECKING:
    from tmmcalc.linkage.room import LinkageTables
    from tmmcalc.linkage.synthesis.results import Synthesis
    from tmmcalc.linkage.tables.mechanism import MechanismTable

_FIRST, _LOADS = "[mechanism", "[[loads]]"  # how the mechanism begins in a ready spec, and its loads after it


def of_synthesis(spec: LinkageTables, result: Synthesis, choose: int | None = None) -> Found:
    """Linkage ``choose``, from 1, by default that of the spec or the best, in the place of what is asked of it.

    The load of a ready spec comes with it where the spec has none. Raises `UsageError` if there is no such linkage.
    """
    assert spec.synthesis is not None
    number, count = choose or spec.synthesis.choose or 1, len(result.designs)
    check_choice(number, count, "solution", "synthesis.choose" if choose is None else CHOOSE)
    design = result.designs[number - 1]
    head, _, mechanism = design.spec.partition(_FIRST)
    mechanism, _, loads = mechanism.partition(_LOADS)
    which = f"linkage {number} of {count}, {design.name}"
    remarks = [line for line in head.splitlines()[1:] if line.startswith("#")]
    lines = [f"# {which}", *remarks, f"{_FIRST}{mechanism.rstrip()}"]
    if loads and not spec.loads:
        lines += ["", f"{_LOADS}{loads.rstrip()}"]
    gone = (Change(("synthesis",)), Change(("mechanism",)))
    alone = replace(result, designs=(design,), among=result.designs)
    return Found(gone, "\n".join(lines) + "\n", which, ("synthesis",), alone)


def outlook() -> dict[str, MechanismTable]:
    """A crank in the place of the linkage that is not found yet: so much as a plan of the stages asks."""
    from tmmcalc.linkage.tables.mechanism import MechanismTable

    crank = {
        "input": {"joint": "O", "speed": 1.0},
        "fixed": {"O": [0.0, 0.0]},
        "links": [{"id": 1, "points": {"O": [0.0, 0.0]}}],
        "joints": [{"name": "O", "kind": "revolute", "links": [0, 1]}],
    }
    return {"mechanism": MechanismTable.model_validate(crank)}
