"""RPR, textbook (2.19), (2.20), (2.60), (2.61): a block on a slotted link, or a rod in an oscillating cylinder."""

from __future__ import annotations

from tmmcalc.linkage.notes.group import GroupAt, angle, length
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr

POSITION = (
    "l_{<Q><P>} = <minus>sqrt((x_{<P>} - x_{<Q>})**2 + (y_{<P>} - y_{<Q>})**2 - h_<b>**2)",
    "phi_<b> = atan2(y_{<end>} - y_{<start>}, x_{<end>} - x_{<start>}) <turn> atan2(h_<b>, <minus>l_{<Q><P>})",
)
VELOCITY = (
    "omega_<b> = ((v_{<P>y} - v_{<Q>y})*cos(phi_<b>) - (v_{<P>x} - v_{<Q>x})*sin(phi_<b>))/l_{<Q><P>}",
    "v_{<a><b>} = (v_{<P>x} - v_{<Q>x})*cos(phi_<b>) + (v_{<P>y} - v_{<Q>y})*sin(phi_<b>) + omega_<b>*h_<b>",
)
ACCELERATION = (
    "a_{<a><b>}^K = 2*omega_<b>*v_{<a><b>}",
    "eps_<b> = ((a_{<P>y} - a_{<Q>y})*cos(phi_<b>) - (a_{<P>x} - a_{<Q>x})*sin(phi_<b>) - a_{<a><b>}^K"
    " + omega_<b>**2*h_<b>)/l_{<Q><P>}",
    "a_{<a><b>} = (a_{<P>x} - a_{<Q>x})*cos(phi_<b>) + (a_{<P>y} - a_{<Q>y})*sin(phi_<b>) + eps_<b>*h_<b>"
    " + omega_<b>**2*l_{<Q><P>}",
)
REACTIONS = (
    "R_{<a><f>}^e = -T_{<a>x}*cos(phi_<b>) - T_{<a>y}*sin(phi_<b>)",
    "R_{<a><f>}^n = (h_<b>*R_{<a><f>}^e - M_{<a><b>}^{<Q>})/l_{<Q><P>}",
    "R_{<a><f>x} = R_{<a><f>}^e*cos(phi_<b>) - R_{<a><f>}^n*sin(phi_<b>)",
    "R_{<a><f>y} = R_{<a><f>}^e*sin(phi_<b>) + R_{<a><f>}^n*cos(phi_<b>)",
    "R_{<a><f>} = sqrt(R_{<a><f>x}**2 + R_{<a><f>y}**2)",
    "N_{<a><b>} = T_{<a>x}*sin(phi_<b>) - T_{<a>y}*cos(phi_<b>) - R_{<a><f>}^n",
    "M_{<a><b>}^{<P>} = -M_<a>^{<P>}",
    "R_{<b><g>x} = -T_{<a><b>x} - R_{<a><f>x}",
    "R_{<b><g>y} = -T_{<a><b>y} - R_{<a><f>y}",
    "R_{<b><g>} = sqrt(R_{<b><g>x}**2 + R_{<b><g>y}**2)",
)
MOMENTS = {"ab": "Q", "a": "P"}  # the point about which those of a link, or of both, are taken


def quantities(at: GroupAt) -> dict[str, Given]:
    """Distance along the slot, offset, the motion along the slot with the Coriolis acceleration."""
    places, rates = at.places, at.rates
    link, pair = places["b"], {"block": places["a"], "link": places["b"]}
    along = tr("distance of {first} and {second} along link {link}", first=places["Q"], second=places["P"], link=link)
    return {
        "l_{<Q><P>}": length(float(at.placed.s), along),
        "h_<b>": length(at.dyad.h, tr("offset of the line of link {link} from its pivot", link=link)),
        "phi_<b>": angle(complex(at.placed.e), tr("angle of link {link}", link=link)),
        "v_{<a><b>}": Given(float(rates.y), "m/s", tr("velocity of link {block} along link {link}", **pair)),
        "a_{<a><b>}": Given(float(rates.yy), "m/s^2", tr("acceleration of link {block} along link {link}", **pair)),
        "a_{<a><b>}^K": Given(
            2 * float(rates.x) * float(rates.y), "m/s^2", tr("Coriolis acceleration of link {block}", **pair)
        ),
    }
