"""From the table ``[pair]`` to the pairs that the gear room solves."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from tmmcalc.core.errors import UsageError
from tmmcalc.gears.involute.internal.ring import Cutter
from tmmcalc.gears.involute.quality.verdicts import QualityLimits
from tmmcalc.gears.involute.rack import RACKS, Rack
from tmmcalc.gears.layouts.open_pair import GEAR_NAME, PINION_NAME
from tmmcalc.gears.meshing.task import NEITHER, Measuring, PairsTask, PairTask
from tmmcalc.gears.tables.shifting import usual_strategy

if TYPE_CHECKING:
    from tmmcalc.gears.room import GearTables
    from tmmcalc.gears.tables.open_pair import OpenPairTable
    from tmmcalc.gears.tables.pair import PairKeys, PairTable
    from tmmcalc.gears.tables.teeth import CutterTable

Given = dict[str, Any]  # what the keys of one pair say

_RACK = {"pressure_angle": "angle", "addendum": "addendum", "clearance": "clearance", "tip_radius": "tip_radius"}
_LIMITS = {
    "contact_ratio_min": "contact_ratio",
    "contact_ratio_wanted": "contact_ratio_wanted",
    "tip_thickness_min": "tip_thickness",
    "tip_thickness_wanted": "tip_thickness_wanted",
    "sliding_max": "sliding",
    "pressure_max": "pressure",
}
# keys whose values the task takes as they are
_PLAIN = {
    "name": "name",
    "kind": "kind",
    "split": "split",
    "centre_distance": "distance",
    "desired_contact_ratio": "desired",
    "face_width": "face_width",
    "fillet": "fillet",
}
OF_TRAIN = 1.0  # stands in for the module that strength gives


def to_pairs(spec: GearTables) -> PairsTask:
    """The pairs of the spec, the open pair on the crank last; raises `UsageError` if it has none."""
    on_crank = None if spec.open_pair is None else open_task(spec.open_pair)
    if spec.pair is None and on_crank is not None:
        return PairsTask(on_crank=on_crank)
    table = _table(spec)
    general = _given(table)
    if table.of_train:
        rack = _rack_of_train(spec)
        own = {mesh.mesh or "": _task({**general, **_given(mesh)}, rack, True, table.refuse) for mesh in table.meshes}
        return PairsTask(usual=_task(general, rack, True, table.refuse), own=own, on_crank=on_crank)
    every = [{**general, **_given(mesh)} for mesh in table.meshes] or [general]
    names = _names([given.get("name") for given in every], on_crank is not None)
    named = ({**given, "name": name} for given, name in zip(every, names, strict=True))
    pairs = tuple(_task(given, Rack(), False, table.refuse) for given in named)
    return PairsTask(pairs, on_crank=on_crank, beside_train=spec.train is not None)


def open_task(table: OpenPairTable) -> PairTask:
    """The open pair on the crank, with wheels of names that no train has."""
    given = {"name": "open pair", **_given(table)}
    return replace(_task(given, Rack(), False, True), wheels=(PINION_NAME, GEAR_NAME))


def profile_points(spec: GearTables) -> int:
    """Points of each curve of a tooth profile; raises `UsageError` if the spec has no pairs."""
    if spec.pair is None and spec.open_pair is not None:
        from tmmcalc.gears.tables.teeth import POINTS

        return POINTS
    return _table(spec).points


def _table(spec: GearTables) -> PairTable:
    if spec.pair is None:
        raise UsageError("the spec has no [pair]", remedy='add [pair] with teeth = [14, 17] and module = "5 mm"')
    return spec.pair


def _given(table: PairKeys) -> Given:
    from tmmcalc.gears.tables.pair import PairKeys

    every = {key: getattr(table, key) for key in PairKeys.model_fields}
    return {key: value for key, value in every.items() if value is not None}


def _rack_of_train(spec: GearTables) -> Rack:
    """The rack for which the numbers of teeth were found."""
    train = spec.train
    return Rack() if train is None else Rack(train.pressure_angle, float(train.addendum))


def _task(given: Given, rack: Rack, of_train: bool, refuse: bool) -> PairTask:
    """One pair; of a train without its teeth and its module, and with the external kind until the mesh is known."""
    module = given.get("module", OF_TRAIN)
    named = {name: given[key] for key, name in _PLAIN.items() if key in given}
    return PairTask(
        teeth=_teeth(given),
        module=module,
        helix=abs(given.get("helix_angle", 0.0)),
        rack=rack_of(given, rack),
        strategy=_strategy(given, of_train),
        shifts=(given.get("x1"), given.get("x2")),
        strict=given.get("undercut") != "tolerated",
        limits=_limits(given),
        refuse=refuse,
        tips=_halves(given.get("tip_diameters")),
        cutter=cutter_of(given["cutter"], module) if "cutter" in given else None,
        measuring=_measuring(given),
        **named,
    )


def _teeth(given: Given) -> tuple[int, int]:
    """z1 and z2; 0 for what a rack has not, and for what the train gives."""
    first, second = [*given.get("teeth", ()), 0, 0][:2]
    return first, second


def rack_of(given: Given, usual: Rack) -> Rack:
    """The rack by its name, with what is given in place of its own."""
    chosen = RACKS[given["rack"]] if "rack" in given else usual
    return replace(chosen, **{name: given[key] for key, name in _RACK.items() if key in given})


def _strategy(given: Given, of_train: bool) -> Any:
    """What is asked for, or what follows from the values that are there."""
    return given.get("strategy") or usual_strategy(given, given.get("kind", "external"), of_train)


def _limits(given: Given) -> QualityLimits:
    named = {name: given[key] for key, name in _LIMITS.items() if key in given}
    if "angle_range" in given:
        named["angles"] = tuple(given["angle_range"])
    return QualityLimits(undercut=given.get("undercut") != "none", **named)


def _halves(diameters: list[float] | None) -> tuple[float | None, float | None]:
    first, second = _two(diameters)
    return None if first is None else first / 2, None if second is None else second / 2


def _two(values: list[Any] | None) -> tuple[Any, Any]:
    """Values of the first wheel and of the second, None where there is none."""
    first, second = [*(values or NEITHER), None][:2]
    return first, second


def cutter_of(table: CutterTable, module: float) -> Cutter:
    """The cutter of a ring of this module [m], in modules."""
    tip = None if table.tip_diameter is None else table.tip_diameter / 2 / module
    return Cutter(table.teeth, table.shift, table.rounding, tip)


def _measuring(given: Given) -> Measuring:
    usual = Measuring()
    return Measuring(
        span_teeth=_two(given.get("span_teeth")),
        balls=_two(given.get("ball_diameters")),
        body=given.get("measure_over", usual.body),
        rule=given.get("face_width_rule", usual.rule),
    )


def _names(names: Sequence[str | None], beside: bool) -> list[str]:
    """Pairs by their number in the spec; a single one, with none ``beside`` it, needs no name."""
    several = beside or len(names) > 1
    return [name or f"pair {i}" for i, name in enumerate(names, 1)] if several else [names[0] or ""]
