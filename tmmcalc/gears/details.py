"""What the stages of the room tell by choice: records that no document has by itself, made when they are asked for."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from tmmcalc.gears.chosen.motion import Moving
    from tmmcalc.gears.room import GearTables


def of_train(spec: GearTables, results: Mapping[str, Any]) -> Mapping[str, Any]:
    """Conditions, Willis' equations and plans of the train that was chosen, without criteria of the first set."""
    from tmmcalc.gears.chosen.conditions import conditions
    from tmmcalc.gears.chosen.motion import equations, plans_of

    found = next(found for _, found in _of_search(spec, results, 1))
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
        yield from _of_search(spec, results, number)
        return
    found = written(results["gearing"])
    yield "written train" if found.chosen is None else found.chosen.title, found


def _of_search(spec: GearTables, results: Mapping[str, Any], number: int) -> Iterator[tuple[str, Moving]]:
    from tmmcalc.gears.chosen.choice import chosen_sets
    from tmmcalc.gears.chosen.motion import moving

    speed = None if spec.train is None else spec.train.input_speed
    if "power" in results and results["power"].duty is not None:
        speed = results["power"].duty.motor.speed
    for chosen in chosen_sets(results["train"], results.get("criteria"), number):
        yield chosen.title, moving(chosen, speed)
