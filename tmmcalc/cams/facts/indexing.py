"""The documents of an indexing drive: limits, sizes, profiles, pressure angles, rollers, efficiency."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import degrees

import numpy as np

from tmmcalc.cams.facts.rows import with_rows
from tmmcalc.cams.indexing.columns import indexing_columns
from tmmcalc.cams.indexing.results import LARGEST, Cam, FlankTable, Indexing, PressureReached, SecondCam
from tmmcalc.cams.indexing.rollers import RollerLimit
from tmmcalc.core.quantity import keyed, quantity_of
from tmmcalc.report.document import Document, Fact
from tmmcalc.report.numbers import angle, number
from tmmcalc.report.sizes import quantity

STRAIGHT = 1e-6  # of LARGEST: a radius of a straight piece
HIDDEN = ("source_A", "xw_A", "yw_A", "xw_B", "yw_B", "beta2", "eta_cut")  # columns that people have to ask for


def summary(result: Indexing, title: str) -> Document:
    """Facts and warnings without the table."""
    warnings = tuple(note for note in result.notes if note.startswith("warning"))
    return Document(title, tuple(_facts(result)), warnings)


def document(
    result: Indexing,
    title: str,
    *,
    patterns: Sequence[str] = (),
    rows: Sequence[int] | None = None,
    everything: bool = False,
    where: str = "",
) -> Document:
    """All facts and the table, its columns chosen by ``patterns``, its rows by index; ``everything`` is all in SI.

    ``where`` is the file that has the whole table.
    """
    told, ends = Document(title, tuple(_facts(result)), result.notes), [0.0, degrees(result.step)]
    if result.cam is None:
        return told
    columns = indexing_columns(result)
    if not everything:
        columns = _readable(result.cam, columns, named=bool(patterns))
    return with_rows(told, columns, patterns, rows, ends=ends, everything=everything, example="k,*_B", where=where)


def _readable(cam: Cam, columns: dict[str, np.ndarray], named: bool) -> dict[str, np.ndarray]:
    kept = {header: column for header, column in columns.items() if named or header.partition("[")[0] not in HIDDEN}
    for flank in (cam.a, cam.b):
        told = quantity_of(FlankTable, "bend", flank=flank.name)
        if told.key in kept:
            shown, _ = told.shown("mm")
            kept = {name if name != told.key else shown: column for name, column in kept.items()}
            kept[shown] = _radii(flank)
    return kept


def _radii(flank: FlankTable) -> np.ndarray:
    """Radii of curvature [mm], or the word for a straight piece."""
    bends = flank.bend
    straight = np.abs(bends) > STRAIGHT * LARGEST * np.max(flank.radius)
    cells = ["straight" if flat else 1e3 * bend for bend, flat in zip(bends.tolist(), straight, strict=True)]
    return np.array(cells, object) if straight.any() else 1e3 * bends


def _facts(result: Indexing) -> Iterator[Fact]:
    yield _drive_fact(result)
    yield Fact("law", f"{result.law}, B = {number(result.peak)}", keyed(result, "law", "peak"))
    yield _ratio_fact(result)
    text = f"{_deg(result.step)}, within {_deg(result.step_min)} and {_deg(result.step_max)}"
    yield Fact("step angle", text, keyed(result, "step_min[deg]", "step_max[deg]"))
    values = keyed(result, "base", "start_angle[deg]", "start_pressure[deg]")
    text = f"R0 = {quantity(result.base, 'm')}, delta_0 = {_deg(result.start_angle)}, "
    yield Fact("dwell", f"{text}theta_1m = {_deg(result.start_pressure)}", values)
    if result.cam is not None:
        yield from _cam_facts(result, result.cam)


def _drive_fact(result: Indexing) -> Fact:
    text = f"z2 = {result.rollers} rollers in two rows; the wheel turns by {angle(result.pitch)} deg while the cams "
    rests = _deg(result.dwell) if result.dwells is None else " and ".join(map(_deg, result.dwells))
    text += f"turn by {_deg(result.step)}, and dwells for {rests}"
    values = keyed(result, "rollers", "pitch", "step[deg]", "dwell[deg]", "wheel")
    if result.dwells is not None:
        values |= {f"dwell_{i}[deg]": degrees(rest) for i, rest in enumerate(result.dwells, 1)}
    return Fact("drive", text, values)


def _ratio_fact(result: Indexing) -> Fact:
    limits = result.bounds
    most = "any" if limits.ratio_max is None else number(limits.ratio_max, 6)
    text = f"{number(result.ratio, 6)} ({result.ratio_how}), a = {quantity(result.centres, 'm')}, "
    text += f"l_k = {quantity(result.wheel, 'm')}\nlambda_min = {number(limits.ratio_min, 6)}, lambda_max = {most}"
    values = keyed(result, "ratio", "ratio_how", "centres") | keyed(limits, "ratio_min", "ratio_max")
    values |= keyed(result, "least_centres")
    return Fact("lambda", text, values)


def _cam_facts(result: Indexing, cam: Cam) -> Iterator[Fact]:
    end = cam.handover
    text = (
        f"k_m = {number(end.part, 6)}, R = {quantity(end.radius, 'm')}; B takes over with theta_2 = {_deg(end.angle)}"
    )
    text += f"\nthe printed tables would have {_deg(end.source_angle)}, with +beta' in place of -beta'"
    yield Fact("tip of the lobe", text, keyed(end, "part", "radius", "angle[deg]", "source_angle[deg]"))
    text = f"A ends at k = {number(cam.working_part, 6)}, R = {quantity(cam.working_tip, 'm')}; "
    text += f"B takes over with {_deg(cam.working_angle)}; nearest to O1 {quantity(cam.nearest, 'm')}"
    room = result.wheel_room or 0.0
    text += f"\nabout O2 the lobe leaves {quantity(room, 'm') if room > 0 else 'no room'}"
    values = keyed(cam, "working_part", "working_tip", "working_angle[deg]", "nearest")
    yield Fact("working profile", text, values | keyed(result, "wheel_room"))
    yield from (_pressure_fact(name, each) for name, each in (("run-up", cam.run_up), ("run-out", cam.run_out)))
    text = f"{quantity(cam.bottom, 'm')} at k = 0.5, concave; of the working profile "
    text += quantity((result.roller or 0.0) - cam.bottom, "m")
    yield Fact("bottom of the groove", text, keyed(cam, "bottom"))
    yield _roller_fact(result, cam.roller_limits)
    if result.second is not None:
        yield _second_fact(result, result.second)
    yield _efficiency_fact(result, cam)


def _second_fact(result: Indexing, second: SecondCam) -> Fact:
    """How the cam of the second row differs."""
    text = f"its lobe stands {_deg(second.lag)} behind that of the first"
    if second.turned_over:
        text += "; it is the first cam turned over"
    else:
        text += f"; rollers of the second row r_r2 = {quantity(second.roller, 'm')}\n"
        text += f"A ends at k = {number(second.working_part, 6)}, R = {quantity(second.working_tip, 'm')}; "
        text += f"B takes over with {_deg(second.working_angle)}; nearest to O1 {quantity(second.nearest, 'm')}"
    names = ("roller", "working_part", "working_tip", "working_angle[deg]", "nearest", "lag[deg]", "turned_over")
    return Fact("second cam", text, keyed(second, *names))


def _pressure_fact(name: str, reached: PressureReached) -> Fact:
    text = f"{_deg(reached.largest)} on {reached.flank} at k = {number(reached.part, 4)}, limit {_deg(reached.limit)}"
    values = keyed(reached, "largest[deg]", "part", "limit[deg]", part=name)
    return Fact(f"pressure angle, {name}", text, values)


def _roller_fact(result: Indexing, limits: tuple[RollerLimit, ...]) -> Fact:
    lines = [f"r_r = {quantity(result.roller or 0.0, 'm')} ({result.roller_how}); it has to be below"]
    values = keyed(result, "roller")
    for limit in limits:
        said = "any" if limit.radius is None else quantity(limit.radius, "m")
        place = "" if limit.part is None or limit.radius is None else f" at k = {number(limit.part, 4)}"
        lines.append(f"{said}: {limit.name}{place}")
        values |= keyed(limit, "radius", limit=limit.name)
    return Fact("roller", "\n".join(lines), values)


def _efficiency_fact(result: Indexing, cam: Cam) -> Fact:
    found, (f1, f2) = cam.efficiency, result.frictions
    text = (
        f"mean {number(found.mean_against, 4)} with the load against the motion, {number(found.mean_aiding, 4)} with "
    )
    text += f"the load along it\n{number(found.mean_paper, 4)} against it up to k_m, along it while the wheel runs out"
    text += f"\nf1 = {number(f1, 4)}, f2 = {number(f2, 4)}"
    values = keyed(found, "mean_against", "mean_aiding", "mean_paper", "against_share", "aiding_share")
    values |= keyed(found, "against_a", "against_b", "aiding_a", "aiding_b")
    return Fact("efficiency", text, values | keyed(result, "first_friction", "second_friction"))


def _deg(value: float) -> str:
    return f"{angle(degrees(value))} deg"
