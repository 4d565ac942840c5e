"""The document of a synthesis as a choice of a planetary train: suitable types, how many planets, one set in motion."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any, NamedTuple

from tmmcalc.core.notes import Phrase
from tmmcalc.gears.bounds import single_planet_limits
from tmmcalc.gears.criteria.efficiency import MeshEfficiency
from tmmcalc.gears.facts.gearing import document as gearing_document
from tmmcalc.gears.facts.radial import radial_document
from tmmcalc.gears.gearing import solve_gearing
from tmmcalc.gears.gearingtask import layout_task
from tmmcalc.gears.kinds import from_tooth_ratio, to_tooth_ratio
from tmmcalc.gears.losses import layout_efficiencies, usual_efficiencies
from tmmcalc.gears.network.choice import proposals
from tmmcalc.gears.selection.results import Selection
from tmmcalc.gears.trains import Request, Trains, Variant
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.numbers import number
from tmmcalc.report.rows import check_choice

PLANETS = range(2, 9)  # of the textbook's table 4.7


class ChosenTrain(NamedTuple):
    """The train that criteria chose, as it is driven."""

    selection: Selection
    meshes: MeshEfficiency
    torque: float  # T1 on wheel 1 [N*m]
    source: str  # of T1, in words
    speed: float | None  # of the driver [rad/s]; None: not known
    driven: str = ""  # by whom, in words


def planetary_document(
    result: Trains,
    title: str,
    speed: float | None = None,
    *,
    choose: int = 1,
    chosen: ChosenTrain | None = None,
    power: bool = True,
    internal: bool = True,
    everything: bool = False,
) -> Document:
    """Types for every ratio, limits by the number of planets, the motion of the ``chosen`` train.

    Without one that of set ``choose`` of every variant, with ``speed`` [rad/s] of the driver, 1 rad/s without it. With
    ``everything`` all numbers keep all digits. Raises `UsageError` if no variant has such a set.
    """
    most = max(len(variant.sets) for variant in result.variants)
    if chosen is None:
        check_choice(choose, most, "tooth set")
    requests = [variant.request for variant in result.variants if variant.request.scheme.planetary]
    parts = [*_type_parts(requests, power, internal, everything), *_limit_parts(requests)]
    parts += [radial_document(request, everything) for request in requests if request.scheme.paired]
    if chosen is not None:
        parts.append(_chosen_part(chosen, result.variants[chosen.selection.winner.variant].request))
    else:
        parts += [_variant_part(variant, choose, speed) for variant in result.variants]
    return Document(title, parts=tuple(parts))


def _required(request: Request) -> float | None:
    """Ratio of the speeds of input and output; None where a planetary train has none."""
    kind = "i_1H" if request.kind == "u" else request.kind
    ratio = request.nominal if kind == request.kind else from_tooth_ratio(request.scheme, kind, request.nominal)
    return float(ratio) if ratio else None


def _type_parts(requests: list[Request], power: bool, internal: bool, everything: bool) -> Iterator[Document]:
    """The planetary types that give each of the ratios, the suitable ones first."""
    asked = {(ratio, request.task.planets): None for request in requests if (ratio := _required(request))}
    for ratio, planets in asked:
        usual = MeshEfficiency()
        eta0 = usual.external * usual.internal
        found = proposals(ratio, power, internal, eta0, planets)
        columns: dict[str, list[Any]] = {
            "type": [p.layout for p in found],
            "drives": [p.driver for p in found],
            "i_1H": [_cell(p.i_1h, everything) for p in found],
            "U": [_cell(p.tooth_ratio, everything) for p in found],
            "eta": [_cell(p.efficiency, everything) for p in found],
            "suits": [p.admissible for p in found],
            "why": [p.remark for p in found],
        }
        text = f"{'power' if power else 'kinematic'} drive, internal wheels {'can' if internal else 'cannot'} be cut"
        facts = (
            Fact("ratio", f"{number(ratio, 10)}, input over output", {"ratio": ratio, "planets": planets}),
            Fact("asked for", text, {"power": power, "internal": internal}),
            Fact("efficiency", f"eta_0 = {number(eta0)} of the inverted train, general values", {"eta_0": eta0}),
        )
        heading = f"types for the ratio {number(ratio, 10)} with {planets} planet{'s' if planets > 1 else ''}"
        yield Document(heading, facts, (), View(list(columns), list(columns.values())))


def _cell(value: float | None, everything: bool) -> float | str:
    """A number of any magnitude; blank where there is none."""
    if value is None:
        return ""
    return value if everything else number(value)


def _limit_parts(requests: list[Request]) -> Iterator[Document]:
    """How large U may be for each number of single planets."""
    single = next((request for request in requests if request.scheme.single), None)
    if single is None:
        return
    task = single.task
    gap = task.demands.gap
    if gap is None:
        return
    tips = 2 * task.addendum + gap
    limits = [single_planet_limits(k, sun=task.limits.least, tips=float(tips)) for k in PLANETS]
    u = float(to_tooth_ratio(single.scheme, single.kind, single.nominal))
    columns: dict[str, list[Any]] = {
        "planets": [limit.planets for limit in limits],
        "U rational": ["" if limit.rational is None else limit.rational for limit in limits],
        "U permissible": ["" if limit.permissible is None else limit.permissible for limit in limits],
        "goes in": [limit.permissible is None or u < limit.permissible for limit in limits],
    }
    facts = (
        Fact("tooth ratio", f"U = {number(u, 10)}", {"U": u}),
        Fact("in the table", f"rational: with a sun of {task.limits.least} teeth; permissible: with some sun (4.33)"),
    )
    yield Document("limits of AIbar by the number of planets", facts, (), View(list(columns), list(columns.values())))


def _chosen_part(chosen: ChosenTrain, request: Request) -> Document:
    """The motion of the train that was chosen, at the speed of its motor, under the torque of its teeth."""
    winner, scheme = chosen.selection.winner, request.scheme
    meshes = [chosen.meshes.internal if mesh.internal else chosen.meshes.external for mesh in scheme.meshes]
    driver = "H" if request.kind == "i_H1" else "1"
    task = layout_task(winner.layout, winner.teeth, winner.planets, {driver: chosen.speed or 1.0}, efficiency=meshes)
    told = f"{driver} turns {chosen.driven}" if chosen.driven else f"no speed is given: {driver} turns at 1 rad/s"
    remarks = [told, f"efficiencies of meshes are those of criteria: {_of_meshes(chosen.meshes)}"]
    if driver == "1":
        task = replace(task, torques={"1": chosen.torque})
        remarks.insert(1, f"T1 = {number(chosen.torque)} N*m on wheel 1, {chosen.source}")
    task = replace(task, remarks=tuple(remarks))
    row = f"row {winner.place + 1} of {len(chosen.selection.pool)}"
    return gearing_document(solve_gearing(task), f"{winner.title}: {'/'.join(map(str, winner.teeth))}, {row}")


def _of_meshes(meshes: MeshEfficiency) -> str:
    return f"{meshes.external:g}, of internal ones {meshes.internal:g}"


def _variant_part(variant: Variant, choose: int, speed: float | None) -> Document:
    """The motion of one tooth set; a remark where the variant has none of this number."""
    request, sets = variant.request, variant.sets
    if choose > len(sets):
        none = "note: no tooth set; gears synth says why"
        few = Phrase("note: {sets} tooth sets, none of number {choose}", sets=len(sets), choose=choose)
        return Document(request.title, notes=(few if len(sets) else none,))
    teeth = [int(z) for z in sets.teeth[choose - 1]]
    etas = layout_efficiencies(sets.layout, teeth)
    driver = "H" if request.kind == "i_H1" else "1"
    task = layout_task(sets.layout, teeth, sets.planets, {driver: speed or 1.0}, efficiency=etas)
    remarks = () if speed else (Phrase("no input_speed is given: {driver} turns at 1 rad/s", driver=driver),)
    task = replace(task, remarks=(*remarks, usual_efficiencies()))
    named = "/".join(map(str, teeth))
    return gearing_document(solve_gearing(task), f"{request.title}: {named}, set {choose} of {len(sets)}")
