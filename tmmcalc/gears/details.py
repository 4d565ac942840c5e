"""What the stages of the room tell by choice: records that no document has by itself, made when they are asked for."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from tmmcalc.gears.chosen.motion import Moving
    from tmmcalc.gears.room import GearTables
    from tmmcalc.gears.sizing import Sized


def of_train(spec: GearTables, results: Mapping[str, Any]) -> Mapping[str, Any]:
    """Conditions, Willis' equations and plans of the train that was chosen, without criteria of the first set."""
    from tmmcalc.gears.chosen.conditions import conditions
    from tmmcalc.gears.chosen.motion import equations, plans_of

    found = next(found for _, found in searched_trains(spec, results, 1))
    assert found.chosen is not None
    return {"conditions": conditions(found.chosen), "willis": equations(found), "plans": plans_of(found)}


def of_gearing(spec: GearTables, results: Mapping[str, Any]) -> Mapping[str, Any]:
    """Willis' equations and plans of a train that is written out; of one by its layout the conditions as well."""
    from tmmcalc.gears.chosen.conditions import conditions
    from tmmcalc.gears.chosen.motion import equations, plans_of, written

    found = written(results["gearing"])
    told = {} if found.chosen is None else {"conditions": conditions(found.chosen)}
    return {**told, "willis": equations(found), "plans": plans_of(found)}


def trains_in_motion(spec: GearTables, results: Mapping[str, Any], number: int) -> Iterator[tuple[str, Moving]]:
    """The train that is written out; else that which was chosen, without criteria set ``number`` of every variant."""
    from tmmcalc.gears.chosen.motion import written

    if spec.gearing is None:
        yield from searched_trains(spec, results, number)
        return
    found = written(results["gearing"])
    yield "written train" if found.chosen is None else found.chosen.title, found


def searched_trains(spec: GearTables, results: Mapping[str, Any], number: int) -> Iterator[tuple[str, Moving]]:
    """The train that criteria chose, without them set ``number`` of every variant, at the speed of its driver."""
    from tmmcalc.gears.chosen.choice import chosen_sets
    from tmmcalc.gears.chosen.motion import moving

    speed = speed_of_driver(spec, results)
    for chosen in chosen_sets(results["train"], results.get("criteria"), number):
        yield chosen.title, moving(chosen, speed)


def speed_of_driver(spec: GearTables, results: Mapping[str, Any]) -> float | None:
    """The speed [rad/s] of what drives the train: that of the motor, else as it is given; None: not known."""
    if "power" in results and results["power"].duty is not None:
        return float(results["power"].duty.motor.speed)
    return None if spec.train is None else spec.train.input_speed


def of_strength(spec: GearTables, results: Mapping[str, Any]) -> Any:
    """Every factor of the train that was chosen; without criteria of the first that is strong enough, or the first."""
    from tmmcalc.gears.strength.chain import strength_factors

    sized, at, _ = sized_train(results)
    return strength_factors(sized.sets, sized.task, at).named


def sized_train(results: Mapping[str, Any], row: int | None = None) -> tuple[Sized, int, int]:
    """The variant, the row among its sets and the number, from 1, of a sized train: by its number, else as chosen.

    Raises `UsageError` if there is no such row, or none at all.
    """
    import numpy as np

    from tmmcalc.core.errors import UsageError

    variants = results["strength"].variants
    starts = np.cumsum([0, *(len(sized.sets) for sized in variants)]).tolist()
    if row is None and "criteria" in results:
        winner, own = results["criteria"].winner, variants[results["criteria"].winner.variant]
        weighed = results["criteria"].variants[winner.variant].sets
        place = int(results["criteria"].pool.row[winner.place])
        same = (own.sets.teeth == weighed.teeth[place]).all(axis=1)
        same &= (own.sets.modules == weighed.modules[place]).all(axis=1)
        at = int(np.flatnonzero(same)[0])
        return own, at, starts[winner.variant] + at + 1
    if row is None:
        strong = np.flatnonzero(np.concatenate([sized.strength.accepted for sized in variants]))
        row = int(strong[0]) + 1 if strong.size else 1
    for sized, start in zip(variants, starts, strict=False):
        if start < row <= start + len(sized.sets):
            return sized, row - start - 1, row
    raise UsageError(
        f"there is no row {row}: {starts[-1]} sets are sized",
        where="--train",
        value=row,
        limit=starts[-1],
        remedy=f"1 to {starts[-1]}, as in strength.csv",
    )


def of_open_pair(spec: GearTables, results: Mapping[str, Any]) -> Mapping[str, Any]:
    """Every factor of the strength of the open pair; nothing without a torque or a material."""
    from tmmcalc.gears.openload import strength_task
    from tmmcalc.gears.openpair import tooth_sets
    from tmmcalc.gears.strength.chain import strength_factors

    found = results["open_pair"]
    if found.strength is None or found.torque is None:
        return {}
    own = strength_task(found.task, found.torque)
    return {"strength": strength_factors(tooth_sets(found.task.open.pair), own, 0).named}


def of_pair(spec: GearTables, results: Mapping[str, Any]) -> Mapping[str, Any]:
    """Every intermediate angle, involute and length of each pair, by the names that --pair knows them by."""
    from tmmcalc.gears.meshing.angles import pair_angles

    found = results["pair"].pairs
    return {pair.task.name or str(k): pair_angles(pair) for k, pair in enumerate(found, 1)}
