"""A rolling bearing: its speed and sizes, the frequencies of its defects, crest factors of its vibration."""

from __future__ import annotations

import math
from collections.abc import Iterator

from tmmcalc.extras.bearing import HIGH, SOUND, Bearing, BearingTask
from tmmcalc.extras.notes.told import given
from tmmcalc.extras.tables.bearing import BearingTable
from tmmcalc.extras.tables.tasks.bearing import to_bearing
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Datum, Heading, Lexicon, Paragraph, Place, Result
from tmmcalc.report.telling import data_of, lines, named, plainly, tabulated

MM = 1e3
SIZES = ("D_m = (d_i + d_e)/2", "s = (d_e - d_i)/2")
FREQUENCIES = (
    "f_c = n/2*(1 - d/D_m*cos(phi))",
    "f_e = z*n/2*(1 - d/D_m*cos(phi))",
    "f_i = z*n/2*(1 + d/D_m*cos(phi))",
    "f_b = n*D_m/(2*d)*(1 - (d/D_m*cos(phi))**2)",
)


def blocks(order: Order) -> Iterator[Block]:
    """Speed, sizes, frequencies of the defects; crest factors where there are readings."""
    result: Bearing = order.results["bearing"]
    task, table = to_bearing(order.spec), order.spec.bearing
    assert table is not None
    known = _known(task, table)
    place = Place("", named(known | _quantities(result)))
    yield Heading(tr("Rolling bearing"))
    yield from given(data_of(known), "bearing")
    yield Heading(tr("Speed and sizes"), 3)
    if table.speed is None:
        yield Paragraph(tr("The inner ring turns with the shaft of the wheel, the outer ring stands:"))
        yield from lines(["omega = 2*v/D"], [place])
    else:
        yield Paragraph(tr("The inner ring turns with the shaft, the outer ring stands:"))
    yield from lines(["n = omega/(2*pi)", "v_i = omega*d_i/2"], [place])
    yield Paragraph(tr("The rolling bodies are halfway between the rings; mean diameter and distance of the rings:"))
    yield from lines(SIZES, [place])
    yield Heading(tr("Frequencies of the defects"), 3)
    yield Paragraph(
        tr(
            "The bodies roll without slip, so the cage lags behind the inner ring. A defect of the outer ring is "
            "struck by each of the $z$ bodies in a turn of the cage, one of the inner ring in a turn of the ring "
            "against the cage:"
        )
    )
    yield from lines(FREQUENCIES, [place])
    yield Paragraph(tr("A defect of a rolling body strikes both rings, twice in its turn, with the frequency $2*f_b$."))
    if result.crest:
        yield from _crest(result, task)
    yield from (Result(name, place.lexicon[name]) for name in ("f_e", "f_i", "f_b", "f_c"))


def data(order: Order) -> Iterator[Block]:
    """How the bearing turns, its speed and sizes, the readings."""
    task, table = to_bearing(order.spec), order.spec.bearing
    assert table is not None
    yield Paragraph(
        tr(
            "The inner ring of a rolling bearing turns with its shaft, the outer ring stands. The rolling bodies are "
            "halfway between the rings and roll without slip."
        )
        if table.speed is not None
        else tr(
            "The inner ring of a rolling bearing turns with the shaft of a wheel, the outer ring stands. The rolling "
            "bodies are halfway between the rings and roll without slip."
        )
    )
    yield from data_of(_known(task, table))
    for k, pair in enumerate(zip(task.peak, task.rms, strict=True), 1):
        said = tr("reading {number} of the vibration: peak and root mean square", number=k)
        yield Datum(said, ("A_p", "A_q"), pair)


def _known(task: BearingTask, table: BearingTable) -> Lexicon:
    found = {
        "d_i": Given(MM * task.inner, "mm", tr("diameter of the inner ring")),
        "d_e": Given(MM * task.outer, "mm", tr("diameter of the outer ring")),
        "d": Given(MM * task.roller, "mm", tr("diameter of the rolling bodies")),
        "z": Given(float(task.count), "", tr("number of rolling bodies")),
        "phi": Given(math.degrees(task.angle), "deg", tr("contact angle")),
    }
    if table.speed is not None or table.wheel_speed is None or table.wheel_diameter is None:
        return {"omega": Given(task.omega, "rad/s", tr("angular velocity of the shaft"))} | found
    return {
        "v": Given(table.wheel_speed, "m/s", tr("speed of the rim of the wheel")),
        "D": Given(table.wheel_diameter, "m", tr("diameter of the wheel")),
    } | found


def _quantities(result: Bearing) -> Lexicon:
    return {
        "omega": Given(result.omega, "rad/s", tr("angular velocity of the shaft")),
        "n": Given(result.turns, "1/s", tr("rotational frequency of the shaft")),
        "D_m": Given(2 * MM * result.mean_radius, "mm", tr("mean diameter of the bearing")),
        "s": Given(MM * result.width, "mm", tr("distance of the rings")),
        "v_i": Given(MM * result.raceway_speed, "mm/s", tr("speed of the inner ring at its diameter")),
        "f_c": Given(result.cage, "Hz", tr("frequency of the cage")),
        "f_e": Given(result.outer_race, "Hz", tr("frequency of a defect of the outer ring")),
        "f_i": Given(result.inner_race, "Hz", tr("frequency of a defect of the inner ring")),
        "f_b": Given(result.roller, "Hz", tr("rotational frequency of a rolling body")),
    }


def _crest(result: Bearing, task: BearingTask) -> Iterator[Block]:
    """The crest factor of each reading, and what their course tells."""
    yield Heading(tr("Crest factor of the vibration"), 3)
    yield Paragraph(
        tr(
            "The crest factor is the peak of the vibration over its root mean square. Of a sound bearing it is about "
            "{sound}, above {high} a defect has begun; then the root mean square rises too and the factor falls, which "
            "tells of spreading wear. Its course over the readings tells, not one value:",
            sound=plainly(SOUND),
            high=plainly(HIGH),
        )
    )
    places = [
        Place(
            tr("in reading {number}", number=k),
            named(
                {
                    "k_p": Given(crest, "", tr("crest factor")),
                    "A_p": Given(peak, "", tr("peak of the vibration")),
                    "A_q": Given(rms, "", tr("root mean square of the vibration")),
                }
            ),
        )
        for k, (peak, rms, crest) in enumerate(zip(task.peak, task.rms, result.crest, strict=True), 1)
    ]
    yield from lines(["k_p = A_p/A_q"], places)
    top = max(result.crest)
    labels = [str(k) for k in range(1, len(places) + 1)]
    columns = {"$A_p$": task.peak, "$A_q$": task.rms, "$k_p$": result.crest}
    yield Paragraph(tr("Table {tab:bearing_readings} has the readings with their crest factors."))
    yield tabulated(tr("Readings of the vibration"), columns, labels, head=tr("Reading"), key="bearing_readings")
    if top < HIGH:
        yield Paragraph(tr("The crest factor tells of no defect."))
    elif result.crest[-1] < top:
        yield Paragraph(
            tr(
                "The crest factor has fallen from {top} to {last}: wear spreads, and the bearing is to be replaced.",
                top=plainly(top),
                last=plainly(result.crest[-1]),
            )
        )
    else:
        yield Paragraph(tr("The crest factor has risen to {top}: a defect has begun.", top=plainly(top)))
