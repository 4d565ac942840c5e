"""The documents of the profile stage: roll angles and radii of every wheel, the textbook's tables of its flank."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from tmmcalc.core.notes import Phrase
from tmmcalc.core.quantity import components, keyed, table
from tmmcalc.gears.meshing.profiles import ROLLED, Profiles, WheelProfile
from tmmcalc.report.document import Document, Fact
from tmmcalc.report.numbers import number
from tmmcalc.report.sizes import drawn, plain, quantity

if TYPE_CHECKING:
    from tmmcalc.gears.meshing.booktables import BookTable, BookTables

AXES = {
    "tooth": "the axis of the tooth",
    "space": "the axis of the space",
    "pitch": "the flank's point on the operating pitch circle",
    "reference": "the flank's point on the reference circle",
}
TINY = 1e-15  # [m] a distance that rounding alone leaves


def summary(result: Profiles, title: str) -> Document:
    """One row a wheel."""
    wheels = result.wheels
    named = any(wheel.pair for wheel in wheels)
    columns: dict[str, Any] = {"pair": [wheel.pair for wheel in wheels]} if named else {}
    columns |= {
        "wheel": [wheel.wheel for wheel in wheels],
        "z": [wheel.teeth or "rack" for wheel in wheels],
        **table(wheels, WheelProfile, "shift", "root", "form", "tip", "fillet_least_radius"),
        "undercut": ["yes" if wheel.undercut else "no" for wheel in wheels],
    }
    view = drawn({header: np.array(column) for header, column in columns.items()}) if wheels else None
    return Document(title, notes=tuple(_notes(result)), table=view)


def document(
    result: Profiles,
    title: str,
    tables: Sequence[BookTables] = (),
    *,
    wanted: Sequence[str] = (),
    everything: bool = False,
    asked: bool = False,
) -> Document:
    """Facts of every wheel, or of those with the labels ``wanted``, each with its ``tables``.

    With ``everything`` all in SI, and one table of the points of all profiles instead; or, where the textbook's tables
    were ``asked`` for, one table of these.
    """
    shown = tuple(wheel for wheel in result.wheels if not wanted or label_of(wheel) in wanted)
    own = {each.member.label: each for each in tables}
    parts = tuple(_wheel_document(wheel, own.get(label_of(wheel)), everything) for wheel in shown)
    view = None
    if everything:
        from tmmcalc.gears.meshing.tooth import profile_columns  # late: the theory of the teeth

        view = plain(_stacked(tables) if asked else profile_columns(Profiles(shown, ())))
    return Document(title, notes=tuple(_notes(result)), table=view, parts=parts)


def label_of(wheel: WheelProfile) -> str:
    """Both names, as flags have them."""
    return f"{wheel.pair}/{wheel.wheel}" if wheel.pair else wheel.wheel


def _notes(result: Profiles) -> Iterator[str]:
    """What is unusual; a wheel without a profile is a warning."""
    for remark in result.remarks:
        yield Phrase("warning: {remark}", remark=remark)


def _wheel_document(wheel: WheelProfile, tables: BookTables | None, everything: bool) -> Document:
    parts: tuple[Document, ...] = ()
    if tables is not None:
        about = (Phrase("note: X and Y from the base circle, Y through {axis}", axis=AXES[tables.axis]),)
        view = plain if everything else drawn
        parts = (
            Document("main profile", notes=about, table=view(_columns(tables.main, everything))),
            Document(
                "fillet of a circular rounding" if tables.rounded else "fillet",
                notes=(*about, *_rounding_note(tables)),
                table=view(_columns(tables.fillet, everything)),
            ),
        )
    return Document(f"wheel {label_of(wheel)}", tuple(_facts(wheel)), parts=parts)


def _rounding_note(tables: BookTables) -> Iterator[str]:
    """The circle of the textbook, if the fillet of the outline is that of the ellipse."""
    if tables.apart:
        radius = quantity(tables.radius, "m")
        yield Phrase(
            "note: rho_t = {radius} in place of the ellipse across the teeth that rounds the outline", radius=radius
        )


def _columns(table: BookTable, everything: bool) -> dict[str, np.ndarray]:
    """The columns behind the names of the notable points; what is not cut is blank for people."""
    from tmmcalc.gears.meshing.booktables import CUT  # late: the theory of the teeth

    columns = {"point": np.array(table.points)}
    for header, column in table.columns.items():
        blank = not everything and header in CUT and not table.cut.all()
        cells = [value if cut else "" for value, cut in zip(column.tolist(), table.cut.tolist(), strict=True)]
        columns[header] = np.array(cells, object) if blank else column
    return columns | ({"cut": table.cut} if everything else {})


def _stacked(tables: Sequence[BookTables]) -> dict[str, np.ndarray]:
    """All tables in one, one wheel after the other; what a table does not have is empty."""
    from tmmcalc.gears.meshing.booktables import MAIN

    each = [(of.member, name, book) for of in tables for name, book in (("main", of.main), ("fillet", of.fillet))]
    common = {header: header.replace(f"{MAIN}[", "[") for *_, book in each for header in book.columns}
    headers = list(dict.fromkeys(common.values()))
    rows: dict[str, list[Any]] = {header: [] for header in ("pair", "wheel", "table", "point", *headers, "cut")}
    for member, name, book in each:
        count = len(book.points)
        columns = {common[header]: column.tolist() for header, column in book.columns.items()}
        rows["pair"] += [member.pair] * count
        rows["wheel"] += [member.name] * count
        rows["table"] += [name] * count
        rows["point"] += book.points
        rows["cut"] += book.cut.tolist()
        for header in headers:
            rows[header] += columns.get(header, [""] * count)
    if not any(rows["pair"]):
        del rows["pair"]
    return {header: np.array(column, object) for header, column in rows.items()}


def _facts(wheel: WheelProfile) -> Iterator[Fact]:
    """What is known of one wheel."""
    values = keyed(wheel, "kind", "teeth", "shift", "module")
    if wheel.kind == "rack":
        yield Fact("rack", f"m = {quantity(wheel.module, 'm')}", values)
        heights = keyed(wheel, "tip_height", "root_height", "form_height")
        text = (
            f"tip {quantity(wheel.tip, 'm')}, end of the straight flank {quantity(wheel.form, 'm')}, "
            f"root {quantity(wheel.root, 'm')}"
        )
        yield Fact("above the datum line", text, heights)
    else:
        text = f"z = {wheel.teeth}, x = {number(wheel.shift, 6)}, m = {quantity(wheel.module, 'm')}"
        yield Fact("ring" if wheel.kind == "ring" else "wheel", text, values)
        yield from _circle_facts(wheel)
    gap = "0" if wheel.join < TINY else f"{wheel.join:.0e} m"
    yield Fact(
        "fillet",
        f"least radius of curvature {quantity(wheel.fillet_least_radius, 'm')}, distance from the flank {gap}",
        keyed(wheel, "fillet_least_radius", "join"),
    )


def _circle_facts(wheel: WheelProfile) -> Iterator[Fact]:
    radii = keyed(wheel, "tip", "form", "base", "root")
    text = ", ".join(f"{_name(key)} = {quantity(value, 'm')}" for key, value in radii.items())
    yield Fact("radii", text, radii)
    rolls = components(wheel, "rolls", point=ROLLED)
    shown = list(rolls.items()) if wheel.undercut else list(rolls.items())[:-1]  # the form radius is that of L
    said = ", ".join(f"{_name(key)} = {number(value, 6)}" for key, value in shown)
    yield Fact("roll angles", f"{said} rad", rolls)
    yield Fact("half tooth", f"psi = {number(wheel.half_angle, 6)} rad", keyed(wheel, "half_angle"))
    if wheel.kind == "ring":
        return
    yield _order_fact(wheel)
    yield _centre_fact(wheel)
    text = "none: fillet and involute join smoothly at L"
    if wheel.undercut:
        end = float(wheel.roll[wheel.part == "fillet"][-1])
        text = f"yes: the involute begins {quantity(wheel.form - wheel.base, 'm')} above the base circle, "
        text += f"where the fillet cut at phi = {number(end, 6)} rad crosses it"
    yield Fact("undercut", text, keyed(wheel, "undercut"))


def _name(key: str) -> str:
    return key.partition("[")[0]


def _order_fact(wheel: WheelProfile) -> Fact:
    """What is cut one after the other while the rack rolls on (Fig. 4.33); a large shift turns it round."""
    limit, root, *_ = wheel.rolls
    if limit <= root:
        text, order = "involute and fillet from L, the fillet is done at D; the involute alone to A", ["L", "D", "A"]
    else:
        text, order = "the fillet alone from D, is done at L; then the involute alone to A", ["D", "L", "A"]
    return Fact("generation", text, {"order": order})


def _centre_fact(wheel: WheelProfile) -> Fact:
    """S, the centre of the circular tip rounding, in the axes of the rack (4.85)."""
    x, y = wheel.centre
    text = f"x_1S = {quantity(x, 'm')}, y_1S = {quantity(y, 'm')}"
    return Fact("rounding, circular", text, components(wheel, "centre", axis="xy"))
