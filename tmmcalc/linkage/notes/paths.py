"""What the note tells of wanted paths: when a place is the nearest one, the distances, and what they come to."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from tmmcalc.linkage.paths.results import PathDeviation, Paths
from tmmcalc.linkage.pictures.paths import parts, piece_of
from tmmcalc.report.drawing.lettering import point_name
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Display, Heading, Lexicon, Paragraph, Place, Result
from tmmcalc.report.telling import lines, named, pictured, tabulated, titled


def blocks(order: Order) -> Iterator[Block]:
    """Every path with its table, then the picture of all."""
    result: Paths = order.results["paths"]
    for k, (path, rows) in enumerate(parts(result)):
        yield Heading(tr("Path of point {name} beside the wanted one", name=titled(point_name(path.point))), 2)
        yield from _path(result, path, rows, f"paths_{k}")
    yield Paragraph(tr("Figure {fig:paths} shows the mechanism with the paths and the wanted points."))
    yield pictured(piece_of(order), key="paths")


def _path(result: Paths, path: PathDeviation, rows: slice, key: str) -> Iterator[Block]:
    if path.timed:
        yield Paragraph(tr("Every wanted point is compared with the place of the path at its prescribed position."))
    else:
        yield Paragraph(
            tr(
                "Every wanted point $x_i$, $y_i$ is compared with the place $x$, $y$ of the path that is nearest to "
                "it, where the way to the point is normal to the path, or which is an end of the path:"
            )
        )
        yield Display(read("(x - x_i)*x' + (y - y_i)*y' = 0"))
    yield Paragraph(
        tr(
            "Table {table} has all of them; at point {number}, from which the path is the farthest:",
            table=f"{{tab:{key}}}",
            number=path.worst,
        )
    )
    known = _quantities(result, path, rows)
    yield from lines(("Delta = sqrt((x - x_i)**2 + (y - y_i)**2)", "Delta_s = sqrt(S/n)"), [Place("", known)])
    yield Result("Delta_s", known["Delta_s"], place=point_name(path.name) if len(result.paths) > 1 else "")
    phi, wanted, place = result.phi[rows], result.wanted[rows], result.reached[rows]
    columns = {
        **({"$phi$, deg": np.degrees(phi)} if result.turns else {"$s - s_0$, m": phi}),
        "$x_i$, m": wanted.real,
        "$y_i$, m": wanted.imag,
        "$x$, m": place.real,
        "$y$, m": place.imag,
        "$Delta$, m": np.abs(place - wanted),
    }
    labels = [str(k + 1) for k in range(path.count)]
    yield tabulated(tr("Path and wanted points"), columns, labels, head=tr("Point"), key=key)


def _quantities(result: Paths, path: PathDeviation, rows: slice) -> Lexicon:
    """The place that is the farthest off, and the sum over all."""
    k = path.worst - 1
    wanted, place = complex(result.wanted[rows][k]), complex(result.reached[rows][k])
    return named(
        {
            "x_i": Given(wanted.real, "m", tr("abscissa of the wanted point")),
            "y_i": Given(wanted.imag, "m", tr("ordinate of the wanted point")),
            "x": Given(place.real, "m", tr("abscissa of the place of the path")),
            "y": Given(place.imag, "m", tr("ordinate of the place of the path")),
            "Delta": Given(path.largest, "m", tr("distance of the path from the wanted point")),
            "S": Given(path.total, "m^2", tr("sum of the squares of the distances")),
            "n": Given(float(path.count), "", tr("number of points")),
            "Delta_s": Given(math.sqrt(path.total / path.count), "m", tr("root mean square of the distances")),
        }
    )
