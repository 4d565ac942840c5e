"""PRP: two sliders that meet in a pin, on lines that stand still or move."""

from __future__ import annotations

from tmmcalc.linkage.notes.group import GroupAt, along_guide, guide_quantities, length
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr
from tmmcalc.report.telling import vector

POSITION = (
    "w_{<a><b>x} = x_{<Q>} - x_{<P>} - h_<b>*sin(gamma_<b>) + h_<a>*sin(gamma_<a>)",
    "w_{<a><b>y} = y_{<Q>} - y_{<P>} + h_<b>*cos(gamma_<b>) - h_<a>*cos(gamma_<a>)",
    "s_<a> = (w_{<a><b>x}*sin(gamma_<b>) - w_{<a><b>y}*cos(gamma_<b>))/sin(gamma_<b> - gamma_<a>)",
    "s_<b> = (w_{<a><b>x}*sin(gamma_<a>) - w_{<a><b>y}*cos(gamma_<a>))/sin(gamma_<b> - gamma_<a>)",
    "x_{<B>} = x_{<P>} + s_<a>*cos(gamma_<a>) - h_<a>*sin(gamma_<a>)",
    "y_{<B>} = y_{<P>} + s_<a>*sin(gamma_<a>) + h_<a>*cos(gamma_<a>)",
)
VELOCITY = (
    "v_{<B>x}^{e<a>} = v_{<P>x} - omega_<f>*(y_{<B>} - y_{<P>})",
    "v_{<B>y}^{e<a>} = v_{<P>y} + omega_<f>*(x_{<B>} - x_{<P>})",
    "v_{<B>x}^{e<b>} = v_{<Q>x} - omega_<g>*(y_{<B>} - y_{<Q>})",
    "v_{<B>y}^{e<b>} = v_{<Q>y} + omega_<g>*(x_{<B>} - x_{<Q>})",
    "v_{<a><f>} = ((v_{<B>x}^{e<b>} - v_{<B>x}^{e<a>})*sin(gamma_<b>)"
    " - (v_{<B>y}^{e<b>} - v_{<B>y}^{e<a>})*cos(gamma_<b>))/sin(gamma_<b> - gamma_<a>)",
    "v_{<b><g>} = ((v_{<B>x}^{e<b>} - v_{<B>x}^{e<a>})*sin(gamma_<a>)"
    " - (v_{<B>y}^{e<b>} - v_{<B>y}^{e<a>})*cos(gamma_<a>))/sin(gamma_<b> - gamma_<a>)",
    "v_{<B>x} = v_{<B>x}^{e<a>} + v_{<a><f>}*cos(gamma_<a>)",
    "v_{<B>y} = v_{<B>y}^{e<a>} + v_{<a><f>}*sin(gamma_<a>)",
)
ACCELERATION = (
    "a_{<B>x}^{e<a>} = a_{<P>x} - eps_<f>*(y_{<B>} - y_{<P>}) - omega_<f>**2*(x_{<B>} - x_{<P>})",
    "a_{<B>y}^{e<a>} = a_{<P>y} + eps_<f>*(x_{<B>} - x_{<P>}) - omega_<f>**2*(y_{<B>} - y_{<P>})",
    "a_{<B>x}^{e<b>} = a_{<Q>x} - eps_<g>*(y_{<B>} - y_{<Q>}) - omega_<g>**2*(x_{<B>} - x_{<Q>})",
    "a_{<B>y}^{e<b>} = a_{<Q>y} + eps_<g>*(x_{<B>} - x_{<Q>}) - omega_<g>**2*(y_{<B>} - y_{<Q>})",
    "g_{<a><b>x} = a_{<B>x}^{e<b>} - a_{<B>x}^{e<a>} - 2*omega_<g>*v_{<b><g>}*sin(gamma_<b>)"
    " + 2*omega_<f>*v_{<a><f>}*sin(gamma_<a>)",
    "g_{<a><b>y} = a_{<B>y}^{e<b>} - a_{<B>y}^{e<a>} + 2*omega_<g>*v_{<b><g>}*cos(gamma_<b>)"
    " - 2*omega_<f>*v_{<a><f>}*cos(gamma_<a>)",
    "a_{<a><f>} = (g_{<a><b>x}*sin(gamma_<b>) - g_{<a><b>y}*cos(gamma_<b>))/sin(gamma_<b> - gamma_<a>)",
    "a_{<b><g>} = (g_{<a><b>x}*sin(gamma_<a>) - g_{<a><b>y}*cos(gamma_<a>))/sin(gamma_<b> - gamma_<a>)",
    "a_{<B>x} = a_{<B>x}^{e<a>} + a_{<a><f>}*cos(gamma_<a>) - 2*omega_<f>*v_{<a><f>}*sin(gamma_<a>)",
    "a_{<B>y} = a_{<B>y}^{e<a>} + a_{<a><f>}*sin(gamma_<a>) + 2*omega_<f>*v_{<a><f>}*cos(gamma_<a>)",
)
REACTIONS = (
    "N_{<a><f>} = -(T_{<a><b>x}*cos(gamma_<b>) + T_{<a><b>y}*sin(gamma_<b>))/sin(gamma_<b> - gamma_<a>)",
    "N_{<b><g>} = (T_{<a><b>x}*cos(gamma_<a>) + T_{<a><b>y}*sin(gamma_<a>))/sin(gamma_<b> - gamma_<a>)",
    "M_{<a><f>}^{<B>} = -M_<a>^{<B>}",
    "M_{<b><g>}^{<B>} = -M_<b>^{<B>}",
    "R_{<a><b>x} = N_{<a><f>}*sin(gamma_<a>) - T_{<a>x}",
    "R_{<a><b>y} = -N_{<a><f>}*cos(gamma_<a>) - T_{<a>y}",
    "R_{<a><b>} = sqrt(R_{<a><b>x}**2 + R_{<a><b>y}**2)",
)
MOMENTS = {"a": "B", "b": "B"}  # the point about which those of a link are taken


def quantities(at: GroupAt) -> dict[str, Given]:
    """Both guides with the coordinates, velocities and accelerations along them."""
    dyad, placed, rates, places = at.dyad, at.placed, at.rates, at.places
    one, two = at.port1, at.port2
    gap = (two.r + 1j * dyad.h2 * two.e) - (one.r + 1j * dyad.h1 * one.e)
    pull = [
        guide.a + (1j * guide.eps - guide.omega**2) * offset + 2j * guide.omega * rate * guide.e
        for guide, offset, rate in ((one, placed.offset1, rates.x), (two, placed.offset2, rates.y))
    ]
    return {
        "h_<a>": length(dyad.h1, tr("offset of the pin from the line of link {link}", link=places["a"])),
        "h_<b>": length(dyad.h2, tr("offset of the pin from the line of link {link}", link=places["b"])),
        **vector("w_{<a><b>%}", complex(gap), "m", tr("projections of the distance of the guides")),
        **vector(
            "g_{<a><b>%}", complex(pull[1] - pull[0]), "m/s^2", tr("projections of the known part of the accelerations")
        ),
        **along_guide("<a>", "<f>", places["a"], float(placed.s1), float(rates.x), float(rates.xx)),
        **along_guide("<b>", "<g>", places["b"], float(placed.s2), float(rates.y), float(rates.yy)),
        **guide_quantities(at, one, placed.offset1, slider="<a>", origin="<P>", mark="{e<a>}"),
        **guide_quantities(at, two, placed.offset2, slider="<b>", origin="<Q>", mark="{e<b>}"),
    }
