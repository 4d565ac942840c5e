"""RPP: a pivoted block on a slider that itself slides on a line that stands still or moves."""

from __future__ import annotations

from tmmcalc.linkage.notes.group import GroupAt, along_guide, angle, guide_quantities, length
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr
from tmmcalc.report.telling import vector

POSITION = (
    "w_{<a><b>x} = x_{<P>} - x_{<Q>} + h_<b>*sin(gamma_<b>) + h_<a>*sin(gamma_<b> + delta_<b>)",
    "w_{<a><b>y} = y_{<P>} - y_{<Q>} - h_<b>*cos(gamma_<b>) - h_<a>*cos(gamma_<b> + delta_<b>)",
    "s_<b> = (w_{<a><b>x}*sin(gamma_<b> + delta_<b>) - w_{<a><b>y}*cos(gamma_<b> + delta_<b>))/sin(delta_<b>)",
    "s_<a> = (w_{<a><b>y}*cos(gamma_<b>) - w_{<a><b>x}*sin(gamma_<b>))/sin(delta_<b>)",
)
VELOCITY = (
    "v_{<P>x}^r = v_{<P>x} - v_{<Q>x} + omega_<g>*(y_{<P>} - y_{<Q>})",
    "v_{<P>y}^r = v_{<P>y} - v_{<Q>y} - omega_<g>*(x_{<P>} - x_{<Q>})",
    "v_{<b><g>} = (v_{<P>x}^r*sin(gamma_<b> + delta_<b>) - v_{<P>y}^r*cos(gamma_<b> + delta_<b>))/sin(delta_<b>)",
    "v_{<a><b>} = (v_{<P>y}^r*cos(gamma_<b>) - v_{<P>x}^r*sin(gamma_<b>))/sin(delta_<b>)",
)
ACCELERATION = (
    "a_{<P>x}^r = a_{<P>x} - a_{<Q>x} + eps_<g>*(y_{<P>} - y_{<Q>}) + omega_<g>**2*(x_{<P>} - x_{<Q>})"
    " + 2*omega_<g>*v_{<P>y}^r",
    "a_{<P>y}^r = a_{<P>y} - a_{<Q>y} - eps_<g>*(x_{<P>} - x_{<Q>}) + omega_<g>**2*(y_{<P>} - y_{<Q>})"
    " - 2*omega_<g>*v_{<P>x}^r",
    "a_{<b><g>} = (a_{<P>x}^r*sin(gamma_<b> + delta_<b>) - a_{<P>y}^r*cos(gamma_<b> + delta_<b>))/sin(delta_<b>)",
    "a_{<a><b>} = (a_{<P>y}^r*cos(gamma_<b>) - a_{<P>x}^r*sin(gamma_<b>))/sin(delta_<b>)",
)
REACTIONS = (
    "R_{<a><f>}^I = -T_{<a><b>x}*cos(gamma_<b>) - T_{<a><b>y}*sin(gamma_<b>)",
    "R_{<a><f>}^{II} = -T_{<a>x}*cos(gamma_<b> + delta_<b>) - T_{<a>y}*sin(gamma_<b> + delta_<b>)",
    "R_{<a><f>x} = (R_{<a><f>}^I*sin(gamma_<b> + delta_<b>) - R_{<a><f>}^{II}*sin(gamma_<b>))/sin(delta_<b>)",
    "R_{<a><f>y} = (R_{<a><f>}^{II}*cos(gamma_<b>) - R_{<a><f>}^I*cos(gamma_<b> + delta_<b>))/sin(delta_<b>)",
    "R_{<a><f>} = sqrt(R_{<a><f>x}**2 + R_{<a><f>y}**2)",
    "N_{<b><g>} = (T_{<a><b>x} + R_{<a><f>x})*sin(gamma_<b>) - (T_{<a><b>y} + R_{<a><f>y})*cos(gamma_<b>)",
    "N_{<a><b>} = (T_{<a>x} + R_{<a><f>x})*sin(gamma_<b> + delta_<b>)"
    " - (T_{<a>y} + R_{<a><f>y})*cos(gamma_<b> + delta_<b>)",
    "M_{<a><b>}^{<P>} = -M_<a>^{<P>}",
)
MOMENTS = {"a": "P"}  # the point about which those of a link are taken


def quantities(at: GroupAt) -> dict[str, Given]:
    """The guide and the inner line, coordinates and rates along both; the motion of the pin against the guide."""
    dyad, placed, rates, places = at.dyad, at.placed, at.rates, at.places
    guide = at.port2
    sliding = rates.x * placed.e1 + rates.y * placed.e2
    rising = rates.xx * placed.e1 + rates.yy * placed.e2
    offset = placed.offset - 1j * dyad.h1 * placed.e1 - 1j * dyad.h2 * placed.e2
    against = tr("projections of the velocity of {point} against link {link}", point=places["P"], link=places["g"])
    beyond = tr("projections of the acceleration of {point} against link {link}", point=places["P"], link=places["g"])
    return {
        "h_<b>": length(dyad.h1, tr("offset of the line of link {link} from the guide", link=places["b"])),
        "h_<a>": length(
            dyad.h2, tr("offset of {point} from the line of link {link}", point=places["P"], link=places["b"])
        ),
        "delta_<b>": angle(dyad.d, tr("angle between the lines of link {link}", link=places["b"])),
        **vector(
            "w_{<a><b>%}",
            complex(offset),
            "m",
            tr("projections of the way from the guide to the pin without the offsets"),
        ),
        **vector("v_{<P>%}^r", complex(sliding), "m/s", against),
        **vector("a_{<P>%}^r", complex(rising), "m/s^2", beyond),
        **along_guide("<b>", "<g>", places["b"], float(placed.s1), float(rates.x), float(rates.xx)),
        **along_guide("<a>", "<b>", places["a"], float(placed.s2), float(rates.y), float(rates.yy)),
        **guide_quantities(at, guide, complex(placed.offset), slider="<b>", origin="<Q>", mark="e"),
    }
