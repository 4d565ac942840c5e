"""RRR, textbook (2.8) to (2.17): two links that meet in a pin."""

from __future__ import annotations

from tmmcalc.linkage.notes.group import GroupAt, angle, length
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr

POSITION = (
    "l_{<P><Q>} = sqrt((x_{<Q>} - x_{<P>})**2 + (y_{<Q>} - y_{<P>})**2)",
    "phi_{<P><Q>} = atan2(y_{<Q>} - y_{<P>}, x_{<Q>} - x_{<P>})",
    "psi_<a> = acos((l_<a>**2 + l_{<P><Q>}**2 - l_<b>**2)/(2*l_<a>*l_{<P><Q>}))",
    "phi_<a> = phi_{<P><Q>} <sign> psi_<a>",
    "x_{<B>} = x_{<P>} + l_<a>*cos(phi_<a>)",
    "y_{<B>} = y_{<P>} + l_<a>*sin(phi_<a>)",
    "phi_<b> = atan2(y_{<B>} - y_{<Q>}, x_{<B>} - x_{<Q>})",
)
VELOCITY = (
    "omega_<a> = ((v_{<Q>x} - v_{<P>x})*cos(phi_<b>) + (v_{<Q>y} - v_{<P>y})*sin(phi_<b>))"
    "/(l_<a>*sin(phi_<b> - phi_<a>))",
    "omega_<b> = ((v_{<Q>x} - v_{<P>x})*cos(phi_<a>) + (v_{<Q>y} - v_{<P>y})*sin(phi_<a>))"
    "/(l_<b>*sin(phi_<b> - phi_<a>))",
    "v_{<B>x} = v_{<P>x} - l_<a>*omega_<a>*sin(phi_<a>)",
    "v_{<B>y} = v_{<P>y} + l_<a>*omega_<a>*cos(phi_<a>)",
)
ACCELERATION = (
    "g_{<a><b>x} = a_{<Q>x} - a_{<P>x} + l_<a>*omega_<a>**2*cos(phi_<a>) - l_<b>*omega_<b>**2*cos(phi_<b>)",
    "g_{<a><b>y} = a_{<Q>y} - a_{<P>y} + l_<a>*omega_<a>**2*sin(phi_<a>) - l_<b>*omega_<b>**2*sin(phi_<b>)",
    "eps_<a> = (g_{<a><b>x}*cos(phi_<b>) + g_{<a><b>y}*sin(phi_<b>))/(l_<a>*sin(phi_<b> - phi_<a>))",
    "eps_<b> = (g_{<a><b>x}*cos(phi_<a>) + g_{<a><b>y}*sin(phi_<a>))/(l_<b>*sin(phi_<b> - phi_<a>))",
    "a_{<B>x} = a_{<P>x} - l_<a>*(eps_<a>*sin(phi_<a>) + omega_<a>**2*cos(phi_<a>))",
    "a_{<B>y} = a_{<P>y} + l_<a>*(eps_<a>*cos(phi_<a>) - omega_<a>**2*sin(phi_<a>))",
)
REACTIONS = (
    "R_{<a><f>}^t = M_<a>^{<B>}/l_<a>",
    "R_{<b><g>}^t = M_<b>^{<B>}/l_<b>",
    "R_{<a><f>}^n = (R_{<a><f>}^t*cos(phi_<b> - phi_<a>) + R_{<b><g>}^t + T_{<a><b>y}*cos(phi_<b>)"
    " - T_{<a><b>x}*sin(phi_<b>))/sin(phi_<b> - phi_<a>)",
    "R_{<a><f>x} = R_{<a><f>}^n*cos(phi_<a>) - R_{<a><f>}^t*sin(phi_<a>)",
    "R_{<a><f>y} = R_{<a><f>}^n*sin(phi_<a>) + R_{<a><f>}^t*cos(phi_<a>)",
    "R_{<a><f>} = sqrt(R_{<a><f>x}**2 + R_{<a><f>y}**2)",
    "R_{<b><g>x} = -T_{<a><b>x} - R_{<a><f>x}",
    "R_{<b><g>y} = -T_{<a><b>y} - R_{<a><f>y}",
    "R_{<b><g>} = sqrt(R_{<b><g>x}**2 + R_{<b><g>y}**2)",
    "R_{<a><b>x} = -T_{<a>x} - R_{<a><f>x}",
    "R_{<a><b>y} = -T_{<a>y} - R_{<a><f>y}",
    "R_{<a><b>} = sqrt(R_{<a><b>x}**2 + R_{<a><b>y}**2)",
)
MOMENTS = {"a": "B", "b": "B"}  # the point about which those of a link are taken


def quantities(at: GroupAt) -> dict[str, Given]:
    """Lengths, the line of the outer pins, the angle at the first of them, the known part of the accelerations."""
    a, b = at.placed.a, at.placed.b
    q = a - b
    steady = at.port2.a - at.port1.a + at.rates.x**2 * a - at.rates.y**2 * b
    places = at.places
    return {
        "l_<a>": length(abs(a), tr("length of link {link}", link=places["a"])),
        "l_<b>": length(abs(b), tr("length of link {link}", link=places["b"])),
        "l_{<P><Q>}": length(
            abs(q), tr("distance between points {first} and {second}", first=places["P"], second=places["Q"])
        ),
        "phi_{<P><Q>}": angle(q, tr("angle of the line {first}{second}", first=places["P"], second=places["Q"])),
        "psi_<a>": angle(
            complex((a / q).real, abs((a / q).imag)),
            tr(
                "angle between the line {first}{second} and link {link}",
                first=places["P"],
                second=places["Q"],
                link=places["a"],
            ),
        ),
        "phi_<a>": angle(a, tr("angle of link {link}", link=places["a"])),
        "phi_<b>": angle(b, tr("angle of link {link}", link=places["b"])),
        "g_{<a><b>x}": Given(steady.real, "m/s^2", tr("projections of the known part of the accelerations")),
        "g_{<a><b>y}": Given(steady.imag, "m/s^2", tr("projections of the known part of the accelerations")),
    }
