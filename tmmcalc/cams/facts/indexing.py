"""The documents of an indexing drive: limits, sizes, profiles, pressure angles, rollers, efficiency."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import degrees
from typing import Any

import numpy as np

from tmmcalc.cams.facts.rows import with_rows
from tmmcalc.cams.indexing.columns import indexing_columns
from tmmcalc.cams.indexing.results import LARGEST, Cam, FlankTable, Indexing, PressureReached
from tmmcalc.cams.indexing.rollers import RollerLimit
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
        header = f"rho_{flank.name}[m]"
        if header in kept:
            cells = _radii(flank)
            kept = {name if name != header else f"rho_{flank.name}[mm]": column for name, column in kept.items()}
            kept[f"rho_{flank.name}[mm]"] = cells
    return kept


def _radii(flank: FlankTable) -> np.ndarray:
    """Radii of curvature [mm], or the word for a straight piece."""
    bends = flank.bend
    straight = np.abs(bends) > STRAIGHT * LARGEST * np.max(flank.radius)
    cells = ["straight" if flat else 1e3 * bend for bend, flat in zip(bends.tolist(), straight, strict=True)]
    return np.array(cells, object) if straight.any() else 1e3 * bends


def _facts(result: Indexing) -> Iterator[Fact]:
    yield _drive_fact(result)
    yield _law_fact(result)
    yield _ratio_fact(result)
    yield _step_fact(result)
    values = {
        "R0[m]": result.base,
        "delta_0[deg]": degrees(result.start_angle),
        "theta_1m[deg]": degrees(result.start_pressure),
    }
    text = f"R0 = {quantity(result.base, 'm')}, delta_0 = {_deg(result.start_angle)}, "
    yield Fact("dwell", f"{text}theta_1m = {_deg(result.start_pressure)}", values)
    if result.cam is not None:
        yield from _cam_facts(result, result.cam)


def _drive_fact(result: Indexing) -> Fact:
    pitch = 360 / result.rollers
    text = f"z2 = {result.rollers} rollers in two rows; the wheel turns by {angle(pitch)} deg while the cams turn by "
    text += f"{_deg(result.step)}, and dwells for {_deg(result.dwell)}"
    values = {
        "rollers": result.rollers,
        "pitch[deg]": pitch,
        "phi_p[deg]": degrees(result.step),
        "dwell[deg]": degrees(result.dwell),
        "l_k[m]": result.wheel,
    }
    return Fact("drive", text, values)


def _law_fact(result: Indexing) -> Fact:
    return Fact("law", f"{result.law}, B = {number(result.peak)}", {"law": result.law, "B": result.peak})


def _ratio_fact(result: Indexing) -> Fact:
    limits = result.bounds
    most = "any" if limits.ratio_max is None else number(limits.ratio_max, 6)
    text = f"{number(result.ratio, 6)} ({result.ratio_how}), a = {quantity(result.centres, 'm')}, "
    text += f"l_k = {quantity(result.wheel, 'm')}\nlambda_min = {number(limits.ratio_min, 6)}, lambda_max = {most}"
    values: dict[str, Any] = {
        "lambda": result.ratio,
        "lambda_how": result.ratio_how,
        "a[m]": result.centres,
        "lambda_min": limits.ratio_min,
        "lambda_max": limits.ratio_max,
        "a_min[m]": limits.ratio_min * result.wheel,
    }
    return Fact("lambda", text, values)


def _step_fact(result: Indexing) -> Fact:
    low, high = result.bounds.step_min or 0.0, result.bounds.step_max or 0.0
    values = {"phi_p_min[deg]": degrees(low), "phi_p_max[deg]": degrees(high)}
    return Fact("step angle", f"{_deg(result.step)}, within {_deg(low)} and {_deg(high)}", values)


def _cam_facts(result: Indexing, cam: Cam) -> Iterator[Fact]:
    end = cam.handover
    text = (
        f"k_m = {number(end.part, 6)}, R = {quantity(end.radius, 'm')}; B takes over with theta_2 = {_deg(end.angle)}"
    )
    text += f"\nthe printed tables would have {_deg(end.source_angle)}, with +beta' in place of -beta'"
    values = {
        "k_m": end.part,
        "R_m[m]": end.radius,
        "theta2[deg]": degrees(end.angle),
        "theta2_source[deg]": degrees(end.source_angle),
    }
    yield Fact("tip of the lobe", text, values)
    text = f"A ends at k = {number(cam.working_part, 6)}, R = {quantity(cam.working_tip, 'm')}; "
    text += f"B takes over with {_deg(cam.working_angle)}; nearest to O1 {quantity(cam.nearest, 'm')}"
    room = result.wheel_room or 0.0
    text += f"\nabout O2 the lobe leaves {quantity(room, 'm') if room > 0 else 'no room'}"
    values = {
        "k_w": cam.working_part,
        "R_w[m]": cam.working_tip,
        "theta2_working[deg]": degrees(cam.working_angle),
        "r_min[m]": cam.nearest,
        "wheel_room[m]": room,
    }
    yield Fact("working profile", text, values)
    yield from (_pressure_fact(name, each) for name, each in (("run-up", cam.run_up), ("run-out", cam.run_out)))
    text = f"{quantity(cam.bottom, 'm')} at k = 0.5, concave; of the working profile "
    text += quantity((result.roller or 0.0) - cam.bottom, "m")
    yield Fact("bottom of the groove", text, {"rho_B_mid[m]": cam.bottom})
    yield _roller_fact(result, cam.roller_limits)
    yield _efficiency_fact(result, cam)


def _pressure_fact(name: str, reached: PressureReached) -> Fact:
    text = f"{_deg(reached.largest)} on {reached.flank} at k = {number(reached.part, 4)}, limit {_deg(reached.limit)}"
    values = {
        f"{name}_max[deg]": degrees(reached.largest),
        f"{name}_at_k": reached.part,
        "limit[deg]": degrees(reached.limit),
    }
    return Fact(f"pressure angle, {name}", text, values)


def _roller_fact(result: Indexing, limits: tuple[RollerLimit, ...]) -> Fact:
    lines = [f"r_r = {quantity(result.roller or 0.0, 'm')} ({result.roller_how}); it has to be below"]
    values: dict[str, Any] = {"r_r[m]": result.roller}
    for limit in limits:
        said = "any" if limit.radius is None else quantity(limit.radius, "m")
        place = "" if limit.part is None or limit.radius is None else f" at k = {number(limit.part, 4)}"
        lines.append(f"{said}: {limit.name}{place}")
        values[f"r_max: {limit.name}[m]"] = limit.radius
    return Fact("roller", "\n".join(lines), values)


def _efficiency_fact(result: Indexing, cam: Cam) -> Fact:
    found, (f1, f2) = cam.efficiency, result.frictions
    text = (
        f"mean {number(found.mean_against, 4)} with the load against the motion, {number(found.mean_aiding, 4)} with "
    )
    text += f"the load along it\n{number(found.mean_paper, 4)} against it up to k_m, along it while the wheel runs out"
    text += f"\nf1 = {number(f1, 4)}, f2 = {number(f2, 4)}"
    values = {
        "eta_against": found.mean_against,
        "eta_aiding": found.mean_aiding,
        "eta_mixed": found.mean_paper,
        "cut_off_against": found.against_share,
        "cut_off_aiding": found.aiding_share,
        "f1": f1,
        "f2": f2,
    }
    return Fact("efficiency", text, values)


def _deg(value: float) -> str:
    return f"{angle(degrees(value))} deg"
