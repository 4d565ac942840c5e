"""What is measured on the wheels: span over teeth, constant chord, size over balls or pins."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from tmmcalc.gears.meshing.results import Measures
from tmmcalc.gears.meshing.task import WheelMeasuring
from tmmcalc.gears.notes.pairs.lexicon import Wheels, angle, length, of_index
from tmmcalc.report.formula.digits import Given, significant
from tmmcalc.report.formula.symbols import canonical
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.language import tr, tr_number, tr_unit
from tmmcalc.report.manuscript import Block, Display, Listing, Paragraph, Place
from tmmcalc.report.telling import filled, named, number_of

BASE_PITCH = "p_bn = pi*m*cos(alpha)"
BASE = "s_bn<i> = m*cos(alpha)*(pi/2 + 2*x<_i>*tan(alpha) + z<_i>*inv(<t>))"
REACH = "W<_i>^{*} = 2*sqrt(r_a<i>**2 - r_b<i>**2)"
WIDTH = {"book": "W^{**} = b/sin(beta)", "exact": "W^{**} = b/sin(beta_b)"}
MOST = "z_w<i> <= (W<_i>^{*} - s_bn<i>)/p_bn + 1"
MOST_OF_BOTH = "z_w<i> <= (min(W<_i>^{*}, W^{**}) - s_bn<i>)/p_bn + 1"
SPAN = ("W<_i> = s_bn<i> + (z_w<i> - 1)*p_bn", "rho_W<i> = W<_i>*cos(beta_b)/2")
CHORD = "s_c<i> = m*(pi/2*cos(alpha)**2 + x<_i>*sin(2*alpha))"
HEIGHT, RING_HEIGHT = "h_c<i> = r_a<i> - r<_i> - s_c<i>*tan(alpha)/2", "h_c<i> = r<_i> - r_a<i> - s_c<i>*tan(alpha)/2"
BALLS = (
    "inv(alpha_D<i>) = inv(<t>) <+> D<_i>/(m*z<_i>*cos(alpha)) <-> (pi/2 - 2*x<_i>*tan(alpha))/z<_i>",
    "inv(alpha_D<i>) = tan(alpha_D<i>) - rad(alpha_D<i>)",
    "d_D<i> = 2*r_b<i>/cos(alpha_D<i>)",
)
EVEN, ODD = "M<_i> = d_D<i> <+> D<_i>", "M<_i> = d_D<i>*cos(deg(90)/z<_i>) <+> D<_i>"
FIGURES = 5  # digits of a side of a condition

Row = tuple[Place, Measures, WheelMeasuring]


def quantities(found: Measures) -> dict[str, Given]:
    """The measures of a wheel by names with places for its index."""
    given = {
        "p_bn": length(found.base_pitch, tr("normal base pitch")),
        "s_bn<i>": length(found.base_thickness, tr("normal tooth thickness on the base circle")),
        "s_c<i>": length(found.constant_chord, tr("constant chord")),
        "h_c<i>": length(found.constant_chord_height, tr("height of the tip above the constant chord")),
    }
    if found.spans:
        given["W<_i>^{*}"] = length(found.span_tip, tr("span that reaches the tip circle"))
    if found.span is not None:
        given |= {
            "z_w<i>": Given(float(found.span.teeth), "", tr("number of teeth in the span")),
            "W<_i>": length(found.span.length, tr("span measurement")),
            "rho_W<i>": length(found.span.curvature, tr("radius of curvature where the plates touch")),
        }
    if found.balls is not None:
        given |= {
            "D<_i>": length(found.balls.diameter, tr("diameter of the balls or pins")),
            "alpha_D<i>": angle(found.balls.angle, tr("profile angle at the centre of a ball")),
            "d_D<i>": length(found.balls.centres, tr("diameter of the circle of the centres")),
            "M<_i>": length(found.balls.size, tr("size over the balls or pins")),
        }
    return given


def measured(wheels: Wheels, found: Sequence[Measures], asked: Sequence[WheelMeasuring]) -> Iterator[Block]:
    """All measures of wheels that have their formulas in common."""
    for place, each in zip(wheels.places, found, strict=True):
        place.lexicon.update(named({wheels.name(name): given for name, given in quantities(each).items()}))
    rows = [*zip(wheels.places, found, asked, strict=True)]
    yield from _spans(wheels, [row for row in rows if row[1].spans])
    ring = wheels.words["+"] == "-"
    yield from wheels.lines(CHORD, RING_HEIGHT if ring else HEIGHT)
    yield from _balls(wheels, [row for row in rows if row[1].balls is not None])


def _spans(wheels: Wheels, rows: Sequence[Row]) -> Iterator[Block]:
    """The span over the number of teeth that its limits admit."""
    if not rows:
        return
    wheels = wheels._replace(places=tuple(place for place, _, _ in rows))
    yield from wheels._replace(places=wheels.places[:1]).lines(BASE_PITCH)
    yield from wheels.lines(BASE, REACH)
    _, first, asked = rows[0]
    width = first.span_width if asked.rule == "book" else first.span_width_exact
    if width is not None:
        for place in wheels.places:
            place.lexicon["W^{**}"] = length(width, tr("span that the face width allows"))
        yield from wheels._replace(places=wheels.places[:1]).lines(WIDTH[asked.rule])
    yield Display(read(wheels.name(MOST if width is None else MOST_OF_BOTH)))
    most = ", ".join(f"${_own(wheels, place, 'z_w<i>')} <= {each.span_most}$" for place, each, _ in rows)
    yield Paragraph(tr("For whole numbers of teeth {most}.", most=most))
    chosen = [row for row in rows if row[1].span is not None]
    if not chosen:
        yield Paragraph(tr("No number of teeth is admitted: the span cannot be measured."))
        return
    yield from wheels._replace(places=tuple(place for place, _, _ in chosen)).lines(*SPAN)
    spans = [(place, each) for place, each, _ in chosen if _tip(wheels) in place.lexicon]
    if spans and all(each.span is not None and each.span.valid for _, each in spans):
        relations = "; ".join(_relation(wheels, *span) for span in spans)
        yield Paragraph(tr("The plates touch the usable involute: {relations}.", relations=relations))
    elif spans:
        yield Listing(tuple(_touching(wheels, *span) for span in spans))


def _tip(wheels: Wheels) -> str:
    """The name of the radius of curvature at the tip, which a tip circle within the base circle has not."""
    return canonical(wheels.name("rho_a<i>"))


def _touching(wheels: Wheels, place: Place, found: Measures) -> str:
    """Whether the plates touch the usable involute."""
    assert found.span is not None
    said = _relation(wheels, place, found)
    if found.span.valid:
        return tr("the plates touch the usable involute: {relation}", relation=said)
    low, high = (tr_number(significant(each, FIGURES)) for each in _usable(wheels, place, found))
    told = {"low": low, "high": high, "relation": said}
    return tr("the plates have to touch the usable involute between {low} and {high} mm: {relation}", **told)


def _usable(wheels: Wheels, place: Place, found: Measures) -> tuple[float, float]:
    """The ends of the usable involute, as radii of curvature [mm]."""
    assert found.span is not None
    low = 1e3 * found.span_lowest_active * found.span.curvature / found.span.length
    return low, number_of(place.lexicon, _tip(wheels))


def _relation(wheels: Wheels, place: Place, found: Measures) -> str:
    """The radius of curvature at which the plates touch between the ends of the usable involute."""
    assert found.span is not None
    touch, tip = (_own(wheels, place, name) for name in ("rho_W<i>", "rho_a<i>"))
    own = significant(1e3 * found.span.curvature, FIGURES)
    low, high = (significant(each, FIGURES) for each in _usable(wheels, place, found))
    first = "<" if float(low) < float(own) else ">="
    last = "<" if float(own) < float(high) else ">="
    return f"${low} {first} {touch} = {own} {last} {tip} = {high}$ {tr_unit('mm')}"


def _own(wheels: Wheels, place: Place, name: str) -> str:
    """A name with the number of the wheel."""
    index = place.index or wheels.words["i"]
    return filled(name, of_index(index, wheels.words))


def _balls(wheels: Wheels, rows: Sequence[Row]) -> Iterator[Block]:
    """The size over two balls or pins, or between them in a ring."""
    if not rows:
        return
    pins = rows[0][2].body == "pins"
    text = (
        tr("The size with two pins in opposite spaces:") if pins else tr("The size with two balls in opposite spaces:")
    )
    yield Paragraph(text)
    yield from wheels._replace(places=tuple(place for place, _, _ in rows)).lines(*BALLS)
    for formula in (EVEN, ODD):
        places = tuple(place for place, _, _ in rows if _over(wheels, place, pins=pins) == formula)
        if places:
            yield from wheels._replace(places=places).lines(formula)


def _over(wheels: Wheels, place: Place, *, pins: bool) -> str:
    """The formula of the size: spaces of an odd number of teeth are not opposite, but for pins in a helical wheel."""
    opposite = pins and wheels.words["+"] == "+" and number_of(place.lexicon, "beta") > 0
    return ODD if number_of(place.lexicon, wheels.name("z<_i>")) % 2 and not opposite else EVEN
