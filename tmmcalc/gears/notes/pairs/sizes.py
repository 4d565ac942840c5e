"""The circles and the teeth of a wheel, of a pair or alone: their formulas by kind."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import isclose

from tmmcalc.gears.involute.internal.ring import Cutter
from tmmcalc.gears.notes.pairs.lexicon import Told, Wheels
from tmmcalc.report.formula.digits import result_of, value_of
from tmmcalc.report.formula.symbols import canonical
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.formula.tree import Statement, names
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Paragraph, Place
from tmmcalc.report.telling import filled

SECTION = ("m_t = m/cos(beta)", "alpha_t = atan(tan(alpha)/cos(beta))", "beta_b = asin(sin(beta)*cos(alpha))")
CIRCLES = ("r<_i> = m*z<_i>/(2*cos(beta))", "r_b<i> = r<_i>*cos(<t>)")
PITCH = "r_w<i> = r<_i>*a_w/a"
ROOT = "r_f<i> = r<_i> <-> m*(h_a^{*} + c^{*} - x<_i>)"
CUTTER = (
    "inv(alpha_tw0) = inv(<t>) - 2*(x_0 + x<_i>)*tan(alpha)/(z<_i> - z_0)",
    "inv(alpha_tw0) = tan(alpha_tw0) - rad(alpha_tw0)",
    "a_w0 = m*(z<_i> - z_0)*cos(<t>)/(2*cos(beta)*cos(alpha_tw0))",
)
CUTTER_TIP = "r_a0 = m*z_0/(2*cos(beta)) + m*(h_a^{*} + c^{*} + x_0)"
CUT_ROOT = "r_f<i> = a_w0 + r_a0"
LIMIT = (
    "<xmin> = <hl> - z<_i>*sin(<t>)**2/(2*cos(beta))",
    "rho_L<i> = r<_i>*sin(<t>) - m*(<hl> - x<_i>)/sin(<t>)",
)
FORM = "rho_F<i> = sqrt(r_F<i>**2 - r_b<i>**2)"
CUTTER_BASE = "r_b0 = m*z_0*cos(<t>)/(2*cos(beta))"
RING_FORM = "r_F<i> = r<_i> + m*(<hl> - x<_i>)"
CUT_FORM = "rho_F<i> = a_w0*sin(alpha_tw0) + sqrt((r_a0 - rho_0)**2 - r_b0**2) + rho_0"
CUT_RADIUS = "r_F<i> = sqrt(r_b<i>**2 + rho_F<i>**2)"
BETWEEN = "g = a_w*sin(alpha_tw)"
HEIGHT, RING_HEIGHT = "h<_i> = r_a<i> - r_f<i>", "h<_i> = r_f<i> - r_a<i>"
SHORTENED_TIP = "r_a<i> = r<_i> + m*(h_a^{*} + x<_i> - Deltay)"
PLAIN_TIP = "r_a<i> = r<_i> <+> m*(h_a^{*} + x<_i>)"
KEPT_TIP = "r_a1 = r_f2 - a_w - m*c^{*}"  # of a pinion in a ring with a shallow root
CLEAR_TIP = "r_a2 = sqrt(r_b2**2 + (g + <end1>)**2)"  # of a ring that would reach into the fillet of its pinion
THICKNESS = "<sn> = m*(pi/2 + 2*x<_i>*tan(alpha))"
TRANSVERSE = "<st> = <sn>/cos(beta)"
TIP_ANGLE = "alpha_a<i> = acos(r_b<i>/r_a<i>)"
TIP_ARC = "<sta> = 2*r_a<i>*(<st>/(2*r<_i>) <+> inv(<t>) <-> inv(alpha_a<i>))"
TIP_NORMAL = ("beta_a<i> = atan(r_a<i>*tan(beta)/r<_i>)", "<sna> = <sta>*cos(beta_a<i>)")
SAME = 1e-10  # relative difference of a tip circle and its rule that is none


def circles(told: Told) -> Iterator[Block]:
    """The circles of both wheels, of a rack and pinion of the pinion."""
    for wheels in told.shared:
        yield from wheels.lines(*CIRCLES)
        if "a_w" in told.lexicon and abs(told.found.shift_sum) > SAME:
            yield from wheels.lines(PITCH)
    for wheels in told.wheels:
        if told.found.task.kind == "rack":
            yield Paragraph(tr("The rack rolls on the reference circle whatever the shift of the pinion."))
            given = told.found.task.strategy == "given_aw"
            yield from told.lines("x_1 = (H - r_1)/m" if given else "H = r_1 + m*x_1")
        yield from _root(told, wheels)
    if "g" in told.lexicon:
        yield from told.lines(BETWEEN)
    for wheels in told.wheels:
        yield from _tips(told, wheels)
        ring = told.found.sizes[wheels.numbers[0]].kind == "ring"
        yield from wheels.lines(RING_HEIGHT if ring else HEIGHT)


def _root(told: Told, wheels: Wheels) -> Iterator[Block]:
    """The root circle, and where the involute ends above it."""
    task, sizes = told.found.task, [told.found.sizes[k] for k in wheels.numbers]
    if sizes[0].kind == "ring":
        yield from ring_root(wheels, task.cutter)
    else:
        yield from wheels.lines(ROOT)
        yield from limits(wheels, [size.limit or 0.0 for size in sizes])


def limits(wheels: Wheels, curvatures: Sequence[float]) -> Iterator[Block]:
    """The least shift and the limit point of external wheels; of undercut ones where the fillet cuts the involute."""
    yield from wheels.lines(*LIMIT)
    cut = tuple(place for place, each in zip(wheels.places, curvatures, strict=True) if each < 0)
    if cut:
        yield Paragraph(
            tr("Where the radius of curvature is negative the tooth is undercut: its fillet crosses the involute.")
        )
        yield from wheels._replace(places=cut).lines(FORM)


def ring_root(wheels: Wheels, cutter: Cutter | None) -> Iterator[Block]:
    """The root circle of a ring and the end of its involute, by the rack or by its cutter."""
    if cutter is None:
        yield from wheels.lines(ROOT, RING_FORM, FORM)
        return
    yield from wheels.lines(*CUTTER)
    if cutter.tip is None:
        yield from wheels.lines(CUTTER_TIP)
    yield from wheels.lines(CUT_ROOT, CUTTER_BASE, CUT_FORM, CUT_RADIUS)


def _tips(told: Told, wheels: Wheels) -> Iterator[Block]:
    """The tip circle by the rule that gives it, and why it is another than the usual; else it is given."""
    own = [read(wheels.name("r_a<i>")).sides[0]]
    for rule, why in (
        (SHORTENED_TIP, ""),
        (PLAIN_TIP, ""),
        (KEPT_TIP, tr("The tip of the pinion keeps the clearance at the root that the cutter leaves the ring.")),
        (CLEAR_TIP, tr("The tip of the ring ends where it clears the fillet of the pinion.")),
    ):
        formula = read(filled(rule, {**wheels.words, "end1": told.words["end1"]}))
        if [formula.sides[0]] != own or not set(names(formula)) <= set(wheels.places[0].lexicon):
            continue
        if all(_gives(formula, place) for place in wheels.places):
            yield from [Paragraph(why)] * bool(why)
            yield from wheels.lines(filled(rule, {"end1": told.words["end1"]}))
            return
    yield Paragraph(tr("The tip circle is given."))


def _gives(formula: Statement, place: Place) -> bool:
    """Whether a formula gives what the program has."""
    left, right = formula.sides
    result = result_of(left, place.lexicon).value
    assert isinstance(result, float)
    try:
        return isclose(value_of(right, place.lexicon, ""), result, rel_tol=SAME)
    except ValueError:
        return False


def teeth(shared: Sequence[Wheels], wheels: Sequence[Wheels], *, helical: bool) -> Iterator[Block]:
    """The thickness of the teeth on the reference and on the tip circle."""
    for both in shared:
        yield from both.lines(THICKNESS, *(TRANSVERSE,) * helical)
        tipped = [place for place in both.places if canonical(both.name("alpha_a<i>")) in place.lexicon]
        yield from both._replace(places=tuple(tipped)).lines(*[TIP_ANGLE] * bool(tipped))
    for each in wheels:
        if all(canonical(each.name("alpha_a<i>")) in place.lexicon for place in each.places):
            yield from each.lines(TIP_ARC, *TIP_NORMAL * helical)
