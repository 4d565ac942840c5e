"""The flywheels of stacked variants under their motors: the searches of all, whose trials are run together."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from tmmcalc.batch.stacked_machine import Machine, given_of, machines_without, regime_of_one
from tmmcalc.core.numerics.alike import Rows
from tmmcalc.machine.flywheel.comparison import comparison_with
from tmmcalc.machine.flywheel.required import ample, result_of, searched
from tmmcalc.machine.flywheel.results import Trial
from tmmcalc.machine.flywheel.search import Model
from tmmcalc.machine.flywheel.solve import solve_flywheel
from tmmcalc.machine.stacked.figures import figures
from tmmcalc.machine.stacked.regimes import Machines, regimes
from tmmcalc.machine.stacked.searches import replayed
from tmmcalc.machine.stages import flywheel

if TYPE_CHECKING:
    from tmmcalc.core.numerics.panels import Values
    from tmmcalc.core.numerics.roots import Indices
    from tmmcalc.linkage.stacked.scene import Block
    from tmmcalc.machine.flywheel.results import Flywheel, RequiredInertia
    from tmmcalc.machine.stacked.reduction import Cycles

Found = Mapping[str, Any]  # results by stage, reduction and power among them
Sought = tuple[Trial, Trial, list[Trial]]  # with the inertia at hand, with the least that does, all


def flywheels_of_each(
    block: Block, variants: Indices, machine: Machine, cycles: Cycles, results: Sequence[Found | None], key: str
) -> list[Flywheel | None]:
    """The flywheels of some variants (v,), each by itself; None where a motion is not clear, or without ``results``."""
    rows = Rows(machine)
    given = [given_of("flywheel", rows(int(v)), key) for v in variants]
    there = [k for k, found in enumerate(results) if found is not None]
    asked = {k: flywheel.asked(given[k], results[k] or {}) for k in there}
    bare = machines_without(block, variants, machine, cycles)

    def motions(which: Indices, inertia: Values) -> Values:
        found = regimes(bare.at(np.array(there)[which], inertia))
        return np.where(found.clear, figures(found)["delta"], np.nan)

    sought = dict(zip(there, replayed([_search(given[k], asked[k], results[k]) for k in there], motions), strict=True))
    required = _required(bare, given, asked, results, {k: found for k, found in sought.items() if found is not None})
    return [
        _flywheel(given[k], asked[k], results[k], required[k]) if k in required else None for k in range(len(variants))
    ]


def _search(given: Any, asked: flywheel.Asked, found: Found | None) -> Callable[[Model], Sought]:
    """The search for the least inertia of a variant."""
    assert found is not None
    cycle, delta, at_hand = found["reduction"].cycle, given[0].delta, asked.at_hand.total
    start = ample(cycle, delta, at_hand)

    def search(model: Model) -> Sought:
        trials = [Trial(start, model(start))]
        return *searched(model, delta, at_hand, trials), trials

    return search


def _required(
    bare: Machines,
    given: Sequence[Any],
    asked: Mapping[int, flywheel.Asked],
    results: Sequence[Found | None],
    sought: Mapping[int, Sought],
) -> dict[int, RequiredInertia]:
    """What the searches found, with the motion of each, of those that are clear."""
    if not sought:
        return {}
    which = np.array(list(sought))
    motions = regimes(bare.at(which, np.array([root.inertia for _, root, _ in sought.values()])))
    required = {}
    for row, (k, (first, root, trials)) in enumerate(sought.items()):
        own, driver = results[k], asked[k].driver
        if motions.clear[row] and own is not None and driver is not None:
            regime = regime_of_one(row, own["reduction"].cycle, root.inertia, driver, motions)
            required[k] = result_of(first, root, regime, trials, None, given[k][0].delta)
    return required


def _flywheel(given: Any, asked: flywheel.Asked, found: Found | None, required: RequiredInertia) -> Flywheel:
    """All methods beside the true flywheel; a sweep is asked by names, so none is tried under the motor."""
    assert found is not None
    cycle, delta, at_hand = found["reduction"].cycle, given[0].delta, asked.at_hand.total
    return solve_flywheel(flywheel.task(*given, **found), comparison_with(cycle, at_hand, delta, required))
