"""RRP, textbook (2.2) to (2.6): a rod and a slider on a line that stands still or moves."""

from __future__ import annotations

from tmmcalc.linkage.notes.group import GroupAt, along_guide, angle, guide_quantities, length
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr

POSITION = (
    "U_<a> = (h_<b> + (y_{<Q>} - y_{<P>})*cos(gamma_<b>) - (x_{<Q>} - x_{<P>})*sin(gamma_<b>))/l_<a>",
    "phi_<a> = gamma_<b> <left>asin(U_<a>)",
    "x_{<B>} = x_{<P>} + l_<a>*cos(phi_<a>)",
    "y_{<B>} = y_{<P>} + l_<a>*sin(phi_<a>)",
    "s_<b> = (x_{<B>} - x_{<Q>})*cos(gamma_<b>) + (y_{<B>} - y_{<Q>})*sin(gamma_<b>)",
)
VELOCITY = (
    "v_{<B>x}^e = v_{<Q>x} - omega_<g>*(y_{<B>} - y_{<Q>})",
    "v_{<B>y}^e = v_{<Q>y} + omega_<g>*(x_{<B>} - x_{<Q>})",
    "omega_<a> = ((v_{<B>y}^e - v_{<P>y})*cos(gamma_<b>) - (v_{<B>x}^e - v_{<P>x})*sin(gamma_<b>))"
    "/(l_<a>*cos(phi_<a> - gamma_<b>))",
    "v_{<b><g>} = (v_{<P>x} - v_{<B>x}^e)*cos(gamma_<b>) + (v_{<P>y} - v_{<B>y}^e)*sin(gamma_<b>)"
    " - l_<a>*omega_<a>*sin(phi_<a> - gamma_<b>)",
    "v_{<B>x} = v_{<B>x}^e + v_{<b><g>}*cos(gamma_<b>)",
    "v_{<B>y} = v_{<B>y}^e + v_{<b><g>}*sin(gamma_<b>)",
)
ACCELERATION = (
    "a_{<B>x}^e = a_{<Q>x} - eps_<g>*(y_{<B>} - y_{<Q>}) - omega_<g>**2*(x_{<B>} - x_{<Q>})",
    "a_{<B>y}^e = a_{<Q>y} + eps_<g>*(x_{<B>} - x_{<Q>}) - omega_<g>**2*(y_{<B>} - y_{<Q>})",
    "eps_<a> = ((a_{<B>y}^e - a_{<P>y})*cos(gamma_<b>) - (a_{<B>x}^e - a_{<P>x})*sin(gamma_<b>)"
    " + 2*omega_<g>*v_{<b><g>} + l_<a>*omega_<a>**2*sin(phi_<a> - gamma_<b>))/(l_<a>*cos(phi_<a> - gamma_<b>))",
    "a_{<b><g>} = (a_{<P>x} - a_{<B>x}^e)*cos(gamma_<b>) + (a_{<P>y} - a_{<B>y}^e)*sin(gamma_<b>)"
    " - l_<a>*eps_<a>*sin(phi_<a> - gamma_<b>) - l_<a>*omega_<a>**2*cos(phi_<a> - gamma_<b>)",
    "a_{<B>x} = a_{<B>x}^e + a_{<b><g>}*cos(gamma_<b>) - 2*omega_<g>*v_{<b><g>}*sin(gamma_<b>)",
    "a_{<B>y} = a_{<B>y}^e + a_{<b><g>}*sin(gamma_<b>) + 2*omega_<g>*v_{<b><g>}*cos(gamma_<b>)",
)
REACTIONS = (
    "R_{<a><f>}^t = M_<a>^{<B>}/l_<a>",
    "R_{<a><f>}^n = (R_{<a><f>}^t*sin(phi_<a> - gamma_<b>) - T_{<a><b>x}*cos(gamma_<b>) - T_{<a><b>y}*sin(gamma_<b>))"
    "/cos(phi_<a> - gamma_<b>)",
    "R_{<a><f>x} = R_{<a><f>}^n*cos(phi_<a>) - R_{<a><f>}^t*sin(phi_<a>)",
    "R_{<a><f>y} = R_{<a><f>}^n*sin(phi_<a>) + R_{<a><f>}^t*cos(phi_<a>)",
    "R_{<a><f>} = sqrt(R_{<a><f>x}**2 + R_{<a><f>y}**2)",
    "N_{<b><g>} = (T_{<a><b>x} + R_{<a><f>x})*sin(gamma_<b>) - (T_{<a><b>y} + R_{<a><f>y})*cos(gamma_<b>)",
    "M_{<b><g>}^{<B>} = -M_<b>^{<B>}",
    "R_{<a><b>x} = -T_{<a>x} - R_{<a><f>x}",
    "R_{<a><b>y} = -T_{<a>y} - R_{<a><f>y}",
    "R_{<a><b>} = sqrt(R_{<a><b>x}**2 + R_{<a><b>y}**2)",
)
MOMENTS = {"a": "B", "b": "B"}  # the point about which those of a link are taken


def quantities(at: GroupAt) -> dict[str, Given]:
    """Length and offset, the sine of the angle between rod and guide, the motion along and with the guide."""
    a, places = at.placed.a, at.places
    return {
        "l_<a>": length(abs(a), tr("length of link {link}", link=places["a"])),
        "h_<b>": length(at.dyad.h, tr("offset of the pin from the line of link {link}", link=places["b"])),
        "U_<a>": Given(
            float(at.placed.across / at.dyad.l),
            "",
            tr("sine of the angle between link {link} and the guide", link=places["a"]),
        ),
        "phi_<a>": angle(a, tr("angle of link {link}", link=places["a"])),
        **along_guide("<b>", "<g>", places["b"], float(at.placed.s), float(at.rates.y), float(at.rates.yy)),
        **guide_quantities(at, at.port2, at.placed.offset, slider="<b>", origin="<Q>", mark="e"),
    }
