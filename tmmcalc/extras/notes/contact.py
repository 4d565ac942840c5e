"""Contact of two elastic bodies: Hertz's ellipse where the gap is a paraboloid, and the pressures on a grid."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial

import numpy as np

from tmmcalc.extras.contact import Contact, ContactTask, settled
from tmmcalc.extras.hertz import Hertz, integrals
from tmmcalc.extras.influence import influence
from tmmcalc.extras.notes.told import course, given
from tmmcalc.extras.pictures.contact import draw_contact
from tmmcalc.extras.tables.contact import ContactTable
from tmmcalc.extras.tables.tasks.contact import to_contact
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.formula.syntax import FormulaError, read
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.manuscript import Block, Datum, Display, Heading, Lexicon, Paragraph, Place, Result, Table, Verbatim
from tmmcalc.report.telling import (
    as_given,
    column,
    column_of,
    data_of,
    drawn,
    lines,
    named,
    numeral,
    plainly,
    tabulated,
)

MM, MEGA = 1e3, 1e6  # formulas hold in N, mm, MPa
MODULUS = "E^{*} = 1/((1 - nu_1**2)/E_1 + (1 - nu_2**2)/E_2)"
ROUND = ("a_x = (3*P*R_x/(4*E^{*}))**(1/3)", "a_y = a_x", "p_0 = 3*P/(2*pi*a_x*a_y)", "delta_H = a_x**2/R_x")
ELLIPSE = (
    "R_<l>/R_<s> = (E_e/(1 - e**2) - K_e)/(K_e - E_e)",
    "a_<l> = (3*P*R_<l>*(K_e - E_e)/(pi*e**2*E^{*}))**(1/3)",
    "a_<s> = a_<l>*sqrt(1 - e**2)",
    "p_0 = 3*P/(2*pi*a_x*a_y)",
    "delta_H = p_0*a_<s>*K_e/E^{*}",
)
GRID = ("c = l/N", "n = 3*N*(N + 1) + 1")
PARABOLOID = "h = x**2/(2*R_x) + y**2/(2*R_y)"
FIGURE = 84.0  # height [mm]


def blocks(order: Order) -> Iterator[Block]:
    """What is given, Hertz's contact, the contact on the grid, both beside each other."""
    result: Contact = order.results["contact"]
    task, table = to_contact(order.spec), order.spec.contact
    assert table is not None
    known = _known(task, table)
    lexicon = named(_quantities(result, task) | known)
    place = Place("", lexicon)
    yield Heading(tr("Contact of two elastic bodies"))
    yield from given(data_of(known), "contact")
    if table.modulus is None:
        yield Paragraph(tr("The composite modulus of elasticity of both bodies:"))
        yield from lines([MODULUS], [place])
    if result.hertz is not None:
        yield from _hertz(result.hertz, task, place)
    yield Heading(tr("Numerical solution of the contact"), 3)
    yield from _grid(result, task, place)
    yield Heading(tr("Pressures"), 3)
    yield from _pressures(result, task)
    yield Result("p_{max}", lexicon["p_max"])
    yield Result("delta", lexicon["delta"])


def data(order: Order) -> Iterator[Block]:
    """The bodies, what presses them together, the gap between them."""
    task, table = to_contact(order.spec), order.spec.contact
    assert table is not None
    yield Paragraph(
        tr(
            "A force presses two elastic bodies together, without friction. Between the unloaded bodies, where they "
            "touch at a point, is the gap $h = x**2/(2*R_x) + y**2/(2*R_y)$. A numerical solution has a grid of "
            "equilateral triangles within a hexagon, whose pressures are linear between the nodes."
        )
        if task.radii is not None
        else tr(
            "A force presses two elastic bodies together, without friction. Between the unloaded bodies is the gap "
            "$h$. A numerical solution has a grid of equilateral triangles within a hexagon, whose pressures are "
            "linear between the nodes."
        )
    )
    yield from data_of(_known(task, table))
    if task.formula:
        written = _readable(task.formula)
        said = tr("gap of the unloaded bodies, all in m")
        yield Datum(said, ("h",), text=task.formula if written is None else f"${written.partition(' = ')[2]}$")
    if task.table is not None:
        yield Datum(
            tr("places of the given gap along $x$; between them runs a bicubic spline"), ("x",), _mm(task.table.x), "mm"
        )
        for y, row in zip(_mm(task.table.y), task.table.h, strict=True):
            yield Datum(tr("gap at these places and at $y$ = {y} mm", y=as_given(y)), ("h",), _mm(row), "mm")


def _mm(values: Sequence[float]) -> tuple[float, ...]:
    return tuple(MM * each for each in values)


def _readable(formula: str) -> str | None:
    """The gap as a formula, if that can be written."""
    try:
        read(f"h = {formula}")
    except FormulaError:
        return None
    return f"h = {formula}"


def _known(task: ContactTask, table: ContactTable) -> Lexicon:
    found = {"P": Given(task.load, "N", tr("force that presses the bodies together"))}
    if table.modulus is not None:
        found["E^{*}"] = Given(task.modulus / MEGA, "MPa", tr("composite modulus of elasticity"))
    else:
        for k, young in enumerate(table.young, 1):
            found[f"E_{k}"] = Given(young / MEGA, "MPa", tr("modulus of elasticity of body {body}", body=k))
        for k, poisson in enumerate(table.poisson, 1):
            found[f"nu_{k}"] = Given(poisson, "", tr("Poisson's ratio of body {body}", body=k))
    if task.radii is not None:
        for axis, radius in zip("xy", task.radii, strict=True):
            found[f"R_{axis}"] = Given(MM * radius, "mm", tr("relative radius in plane {plane}", plane=f"{axis}z"))
    found["N"] = Given(float(task.cells), "", tr("steps of the grid from its middle to a corner"))
    if task.size is not None:
        found["l"] = Given(MM * task.size, "mm", tr("distance from the middle of the grid to a corner"))
    return found


def _quantities(result: Contact, task: ContactTask) -> Lexicon:
    return {
        "E^{*}": Given(task.modulus / MEGA, "MPa", tr("composite modulus of elasticity")),
        "l": Given(MM * result.step * task.cells, "mm", tr("distance from the middle of the grid to a corner")),
        "c": Given(MM * result.step, "mm", tr("step of the grid")),
        "n": Given(float(len(result.x)), "", tr("number of nodes")),
        "n_c": Given(float(result.touching), "", tr("number of nodes in contact")),
        "A": Given(MM**2 * result.area, "mm^2", tr("area of contact")),
        "S_p": Given(float(result.pressure.sum()) / MEGA, "MPa", tr("sum of the pressures of all nodes")),
        "p_{max}": Given(result.peak / MEGA, "MPa", tr("largest contact pressure")),
        "delta": Given(MM * result.approach, "mm", tr("approach of the bodies")),
    }


def _hertz(found: Hertz, task: ContactTask, place: Place) -> Iterator[Block]:
    """The ellipse of contact in closed form."""
    assert task.radii is not None
    yield Heading(tr("Contact by Hertz"), 3)
    place.lexicon.update(named(_of_hertz(found)))
    if task.radii[0] == task.radii[1]:
        yield Paragraph(
            tr("The gap is the same in all directions, so the contact is a circle. Its radius, pressure and approach:")
        )
        yield from lines(ROUND, [place])
        return
    yield Paragraph(
        tr(
            "The contact is an ellipse. Its eccentricity $e$ is that at which the ratio of the radii follows from "
            "complete elliptic integrals; it is found numerically. Half-axes, pressure and approach follow from it:"
        )
    )
    axes = {"l": "x", "s": "y"} if task.radii[0] > task.radii[1] else {"l": "y", "s": "x"}
    yield from lines(ELLIPSE, [place], axes)


def _of_hertz(found: Hertz) -> Lexicon:
    integral = integrals(found)
    return {
        "a_x": Given(MM * found.along_x, "mm", tr("half-axis of the contact along $x$")),
        "a_y": Given(MM * found.along_y, "mm", tr("half-axis of the contact along $y$")),
        "e": Given(integral.eccentricity, "", tr("eccentricity of the ellipse of contact")),
        "K_e": Given(integral.first, "", tr("complete elliptic integral of the first kind")),
        "E_e": Given(integral.second, "", tr("complete elliptic integral of the second kind")),
        "p_0": Given(found.peak / MEGA, "MPa", tr("largest pressure by Hertz")),
        "delta_H": Given(MM * found.approach, "mm", tr("approach by Hertz")),
    }


def _grid(result: Contact, task: ContactTask, place: Place) -> Iterator[Block]:
    """The equations of the nodes, and what they hold at two of them."""
    yield Paragraph(
        tr(
            "The surface is covered by a grid of equilateral triangles within a hexagon; between its nodes the "
            "pressure is linear. Step and number of the nodes:"
        )
    )
    yield from lines(GRID, [place])
    yield Paragraph(tr("The settlement of node $i$ under the pressures of all nodes:"))
    yield Display(read("u_i = c/(pi*E^{*})*sum(w_{i,k}*p_k, k)"))
    own, beside = influence(np.array([0, 1]), np.array([0, 0])).tolist()
    yield Paragraph(
        tr(
            "The coefficients $w_{i,k}$ are integrals of the inverse distance, with which the pressure at node $k$ "
            "acts on node $i$: $w_{i,i}$ = {own}, between neighbours {beside}. Where the bodies touch, settlement "
            "and gap $h$ together are the approach, $u_i + h_i = delta$, and $p_i > 0$; elsewhere $u_i + h_i > "
            "delta$ and $p_i = 0$. The nodes in contact are found by passes: those that would pull are left out, "
            "those that would overlap are taken in. After {passes} passes nothing changes any more.",
            own=f"${numeral(own)}$",
            beside=f"${numeral(beside)}$",
            passes=result.passes,
        )
    )
    yield Paragraph(tr("The pressures balance the force, and the nodes in contact have this area:"))
    yield from lines(["P = sqrt(3)/2*c**2*S_p", "A = sqrt(3)/2*c**2*n_c"], [place])
    yield from _gap(result, task)
    yield Paragraph(
        tr(
            "On a grid of half as many steps the largest pressure is {pressure} % off, the approach {approach} %.",
            pressure=f"${numeral(100 * result.peak_change, 2)}$",
            approach=f"${numeral(100 * result.approach_change, 2)}$",
        )
    )


def _gap(result: Contact, task: ContactTask) -> Iterator[Block]:
    """The gap, and the settlement that it leaves, at the node of the largest pressure and at a corner of the grid."""
    unit, factor = ("m", 1.0) if task.formula else ("mm", MM)
    settlement = settled(task, result)
    formulas = [PARABOLOID] if task.radii is not None else []
    if task.formula:
        written = _readable(task.formula)
        if written is not None:
            formulas = [written]
        else:
            yield Paragraph(tr("The gap of the unloaded bodies is given by this formula, in m:"))
            yield Verbatim(task.formula)
    elif task.table is not None:
        yield from _gap_table(task)
    places = []
    for node, said in (
        (int(np.argmax(result.pressure)), tr("at the node of the largest pressure")),
        (int(np.argmax(result.x + result.y)), tr("at a corner of the grid")),
    ):
        lexicon: Lexicon = {
            "x": Given(factor * float(result.x[node]), unit, tr("coordinates of the node")),
            "y": Given(factor * float(result.y[node]), unit, tr("coordinates of the node")),
            "h": Given(factor * float(result.gap[node]), unit, tr("gap of the unloaded bodies")),
            "u": Given(factor * float(settlement[node]), unit, tr("settlement")),
            "s": Given(factor * float(result.opening[node]), unit, tr("opening that is left")),
            "delta": Given(factor * result.approach, unit, tr("approach of the bodies")),
        }
        if task.radii is not None:
            for axis, radius in zip("xy", task.radii, strict=True):
                meaning = tr("relative radius in plane {plane}", plane=f"{axis}z")
                lexicon[f"R_{axis}"] = Given(factor * radius, unit, meaning)
        places.append(Place(said, named(lexicon)))
    yield Paragraph(tr("The gap, and the settlement with what is left of the gap:"))
    yield from lines([*formulas, "u = delta - h + s"], places)


def _gap_table(task: ContactTask) -> Iterator[Block]:
    """The gap as it is given at the nodes of a rectangle."""
    found = task.table
    assert found is not None
    yield Paragraph(tr("The gap is given at points, table {tab:contact_gap}; between them runs a bicubic spline."))
    heads = [f"$x$ = ${numeral(MM * x)}$" for x in found.x]
    cells = MM * np.array(found.h)
    columns = {f"{head}, mm": cells[:, k] for k, head in enumerate(heads)}
    head, labels = column("$y$, mm", MM * np.array(found.y))
    yield tabulated(tr("Given gap, mm"), columns, labels, head=head, key="contact_gap")


def _pressures(result: Contact, task: ContactTask) -> Iterator[Block]:
    """The largest pressure, the field, the axis of x; Hertz beside them."""
    at = {"x": f"${numeral(MM * result.peak_x)}$", "y": f"${numeral(MM * result.peak_y)}$"}
    yield Paragraph(
        tr(
            "The largest pressure is at $x$ = {x} mm, $y$ = {y} mm. Pressures on the axis of x are in table "
            "{tab:contact_axis}, the field is in figure {fig:contact}.",
            **at,
        )
    )
    axis = np.flatnonzero(np.abs(result.y) < result.step / 4)
    axis = axis[np.argsort(result.x[axis])]
    columns = {
        "$x$, mm": MM * result.x[axis],
        "$h$, mm": MM * result.gap[axis],
        "$p$, MPa": result.pressure[axis] / MEGA,
    }
    smooth = result.hertz
    if smooth is not None:
        part = np.maximum(1 - (result.x[axis] / smooth.along_x) ** 2, 0.0)
        columns["$p_H$, MPa"] = smooth.peak * np.sqrt(part) / MEGA
    columns["$s$, mm"] = MM * result.opening[axis]
    yield drawn(tr("Pressures in the contact"), partial(draw_contact, result=result), FIGURE, "contact")
    yield course(tr("Pressures on the axis of x"), columns, "contact_axis")
    if smooth is not None:
        yield Paragraph(tr("Table {tab:contact_both} compares the numerical solution with that by Hertz."))
        yield _beside(result, smooth)


def _beside(result: Contact, smooth: Hertz) -> Table:
    """Both solutions, with their difference."""
    pairs = (
        (tr("largest contact pressure"), "MPa", result.peak / MEGA, smooth.peak / MEGA),
        (tr("approach of the bodies"), "mm", MM * result.approach, MM * smooth.approach),
    )
    rows = []
    for what, unit, one, other in pairs:
        cells = (column_of([each])[0] for each in (one, other))
        rows.append((f"{what}, {tr_unit(unit)}", *cells, plainly(100 * (one / other - 1), 2)))
    head = tr("Quantity"), tr("Numerically"), tr("By Hertz"), tr("Difference, %")
    return Table(tr("The contact by both ways"), head, tuple(rows), "contact_both")
