"""The documents of the blocking stage: areas, corners, points of interest, where the chosen shifts stand."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

from tmmcalc.core.notes import Phrase, listed
from tmmcalc.core.quantity import Quantity, components, keyed
from tmmcalc.gears.facts.meshes import distinct, places
from tmmcalc.gears.involute.contour.task import LINES
from tmmcalc.gears.meshing.contours import UNBOUNDED, Area, Blocking, ContourLine, ContourPoint, Outline, PairContour
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.numbers import number
from tmmcalc.report.sizes import plain

PLACES = 4  # decimals of a shift that people read
SYMBOLS = "s_na1, s_na2 in modules; theta_1 at the beginning, theta_2 at the end of the contact; Y_F: load at the tip"
SIZES = ("x_1", "x_2", "eps_alpha", "s_na1", "s_na2", "theta_1", "theta_2", "Y_F1", "Y_F2")


def chosen_contours(result: Blocking, name: str | None) -> Blocking:
    """The contours of one pair alone, all for None; raises `UsageError` if there is none of that name."""
    at = places([pair.name for pair in result.pairs], name, "pair")
    return replace(result, pairs=tuple(result.pairs[k] for k in at))


def summary(result: Blocking, title: str) -> Document:
    """Areas, margins and the admissible interval of every pair, without tables."""
    return _document(result, title, tuple(_pair_summary(*each) for each in _titled(result)))


def document(result: Blocking, title: str, *, everything: bool = False) -> Document:
    """All of every contour; with ``everything`` every digit and the boundaries of all in one table."""
    shown = _whole if everything else _part
    document = _document(result, title, tuple(shown(*each) for each in _titled(result)))
    if everything:
        from tmmcalc.gears.meshing.blocking import blocking_columns

        return replace(document, table=plain(blocking_columns(result)))
    return document


def _titled(result: Blocking) -> list[tuple[PairContour, str]]:
    """The contours with their titles, no two alike."""
    names = [f"{f'{pair.name}: ' if pair.name else ''}z = {pair.teeth[0]}/{pair.teeth[1]}" for pair in result.pairs]
    return list(zip(result.pairs, distinct(names), strict=True))


def _document(result: Blocking, title: str, parts: tuple[Document, ...]) -> Document:
    remarks = tuple(Phrase("note: {remark}", remark=remark) for remark in result.remarks)
    if len(parts) == 1:
        return replace(parts[0], title=title, notes=(*remarks, *parts[0].notes))
    return Document(title, (), remarks, parts=parts)


def _pair_summary(pair: PairContour, title: str) -> Document:
    return Document(title, tuple(_facts(pair, title)), tuple(_notes(pair)), name=pair.name)


def _part(pair: PairContour, title: str) -> Document:
    """Facts, then the tables of points and corners."""
    parts = []
    if pair.points:
        legend = tuple(Fact(point.name, point.title) for point in pair.points)
        parts.append(Document("points", (*legend, Fact("in the table", SYMBOLS)), (), _points_view(pair)))
    corners = _corners_view(pair)
    if corners is not None:
        parts.append(Document("corners", table=corners))
    return replace(_pair_summary(pair, title), parts=tuple(parts))


def _whole(pair: PairContour, title: str) -> Document:
    """A contour for programs: points and corners as values."""
    values = {
        "points": {point.name: _point_values(point) for point in pair.points},
        "corners": {kind: _corner_values(area) for kind, area in _areas(pair)},
        "lines": [_line_values(line) for line in pair.lines],
    }
    document = _pair_summary(pair, title)
    return replace(document, facts=(*document.facts, Fact("points and corners", "", values)))


def _line_values(line: ContourLine) -> dict[str, Any]:
    """A line of the picture, with its points, by the numbers of the textbook."""
    return keyed(line, "number", "title", "value", "x1", "x2")


def _areas(pair: PairContour) -> tuple[tuple[str, Area], ...]:
    return ("strict", pair.strict), ("tolerated", pair.tolerated)


def _facts(pair: PairContour, title: str) -> Iterator[Fact]:
    yield Fact("contour of", title, {"z": list(pair.teeth)})
    tips = f"at least {number(pair.thickness)} modules thick" if pair.thickness else "not pointed"
    text = f"eps_alpha at least {number(pair.contact_ratio)}, tips {tips}"
    yield Fact("conditions", text, keyed(pair, "contact_ratio", "thickness"))
    for (kind, area), said in zip(_areas(pair), ("no undercut", "undercut that spares the flank"), strict=True):
        yield Fact(f"{kind} contour", f"{said}: {_area_text(area)}", _area_values(kind, area))
    if pair.points:
        yield _chosen_fact(pair.points[0])
    yield _interval_fact(pair)
    if pair.margins:
        yield _margins_fact(pair)


def _area_text(area: Area) -> str:
    if area.main is None:
        return f"none\n{area.reason}"
    text = f"area {number(area.main.area, 5)}, eps_alpha up to {number(area.best_contact_ratio, 5)}"
    return f"{text}\n{_pieces(area)}" if area.pieces else text


def _pieces(area: Area) -> str:
    """What lies apart from the main region, mostly meshes with a tip circle within its reference circle."""
    count, size = len(area.pieces), sum(piece.area for piece in area.pieces)
    return f"and {count} piece{'s' if count > 1 else ''} apart from it, area {number(size, 3)}"


AREA = Quantity("area_{contour}", "area of the {contour} contour")
BEST = Quantity("eps_alpha_max_{contour}", "largest contact ratio within the {contour} contour")


def _area_values(kind: str, area: Area) -> dict[str, Any]:
    return {
        AREA.of(contour=kind).key: area.main.area if area.main is not None else 0.0,
        f"pieces_{kind}": [piece.area for piece in area.pieces],
        BEST.of(contour=kind).key: area.best_contact_ratio,
    }


def _chosen_fact(point: ContourPoint) -> Fact:
    text = f"x_1 = {number(point.x1, 5)}, x_2 = {number(point.x2, 5)}: {_inside(point)}"
    return Fact("chosen shifts", text, keyed(point, "x1", "x2", "strict", "tolerated"))


def _inside(point: ContourPoint) -> str:
    if point.strict:
        return "within the strict contour"
    return "within the tolerated contour only" if point.tolerated else "outside both contours"


def _interval_fact(pair: PairContour) -> Fact:
    """Admissible x1 at the sum of the chosen shifts."""
    if pair.low is None or pair.high is None:
        return Fact("x_1 at this sum", "none is admissible")
    low, high = number(pair.low, 5), number(pair.high, 5)
    text = f"from {low} ({_line(pair.ends[0])})\nto {high} ({_line(pair.ends[1])})"
    return Fact("x_1 at this sum", text, {"x_1_range": [pair.low, pair.high], "x_1_range_by": list(pair.ends)})


def _line(key: str) -> str:
    """A line in words."""
    return LINES[key][1] if key in LINES else key


UNDERCUT = Quantity("undercut{wheel}", "undercut of wheel {wheel}")
INTERFERENCE = Quantity("interference{wheel}", "interference of wheel {wheel}")
TOLERATED = Quantity("tolerated{wheel}", "tolerated undercut of wheel {wheel}")
MARGINS = (Quantity("thickness{wheel}", "tip thickness of wheel {wheel}"), Quantity("contact_ratio", "contact ratio"))


def _margins_fact(pair: PairContour) -> Fact:
    """What is left to every line, the nearest first; of the two lines of a fillet the one that holds."""
    rows = sorted(((key, margin) for key, margin in pair.margins.items() if _holds(key, pair)), key=lambda row: row[1])
    lines = [f"{_line(key)}: {number(margin, 4, 1.0)}" for key, margin in rows]
    return Fact("margins", "\n".join(lines), {"margins": dict(pair.margins)})


def _holds(key: str, pair: PairContour) -> bool:
    """Interference is that of wheels without undercut, the other line that of undercut ones."""
    wheel = key[-1]
    interference, tolerated, undercut = (each.of(wheel=wheel).key for each in (INTERFERENCE, TOLERATED, UNDERCUT))
    if key not in (interference, tolerated):
        return True
    return (pair.margins.get(undercut, 0.0) < 0) == (key == tolerated)


def _notes(pair: PairContour) -> Iterator[str]:
    if pair.points and not pair.points[0].tolerated:
        yield "warning: the chosen shifts lie outside the blocking contour"
    elif pair.points and not pair.points[0].strict and pair.strict.main is not None:
        yield "note: the chosen shifts lie outside the strict contour: a wheel is undercut"
    for missing in pair.missing:
        yield Phrase("note: {text}", text=missing.text)
    for kind, area in _areas(pair):
        if area.untraced:
            tips = listed([str(3 - wheel) for wheel in reversed(area.untraced)], " or ")
            yield Phrase(
                "note: {kind} contour: parts with tip {tips} inside its reference circle are not outlined",
                kind=kind,
                tips=tips,
            )


def _points_view(pair: PairContour) -> View:
    """Quantities down the page, points across it."""
    columns: list[list[Any]] = [[*SIZES, "a_w, mm", "strict", "tolerated"]]
    for point in pair.points:
        values = _point_values(point)
        unbounded = {key for key, value in _sliding(point).items() if abs(value) > UNBOUNDED}
        cells = [values.get(symbol, "unbounded" if symbol in unbounded else "-") for symbol in SIZES]
        cells = [cell if isinstance(cell, str) else round(cell, PLACES) for cell in (*cells, 1e3 * point.distance)]
        columns.append([*cells, point.strict, point.tolerated])
    return View(["", *(_short(point.name) for point in pair.points)], columns)


def _short(name: str) -> str:
    """A name for the head of a narrow column."""
    return "equal Y_F" if name == "equal strength" else name


def _point_values(point: ContourPoint) -> dict[str, Any]:
    """A point for programs; sliding is left out where a flank would have to begin on its base circle or within."""
    sliding = {key: value for key, value in _sliding(point).items() if 0 < abs(value) <= UNBOUNDED}
    return {
        **keyed(point, "x1", "x2", "contact_ratio"),
        **components(point, "tip_thickness", wheel="12"),
        **sliding,
        **components(point, "form_factors", wheel="12"),
        **keyed(point, "distance", "strict", "tolerated"),
    }


def _sliding(point: ContourPoint) -> dict[str, float]:
    found: dict[str, float] = components(point, "sliding", wheel="12")
    return found


def _corners_view(pair: PairContour) -> View | None:
    """Corners of both contours and the lines that meet in them."""
    found = [(kind, corner) for kind, area in _areas(pair) if area.main is not None for corner in area.main.corners]
    if not found:
        return None
    return View(
        ["contour", "x_1", "x_2", "between"],
        [
            [kind for kind, _ in found],
            [round(corner.x1, 6) for _, corner in found],
            [round(corner.x2, 6) for _, corner in found],
            [f"{_line(corner.lines[0])}; {_line(corner.lines[1])}" for _, corner in found],
        ],
    )


def _corner_values(area: Area) -> list[dict[str, Any]]:
    outlines: tuple[Outline, ...] = () if area.main is None else (area.main,)
    corners = [corner for outline in outlines for corner in outline.corners]
    return [keyed(corner) for corner in corners]
