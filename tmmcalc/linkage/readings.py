"""Names of the kinematics that stand beside one another: what is read off in place of what is asked for.

value    velocity  acceleration   first, second transfer function
S_D      vS_D      aS_D           dS_D        ddS_D
angle_3  omega_3   eps_3          dangle_3    ddangle_3
x_B      vx_B      ax_B           dx_B        ddx_B
s_D0     v_D0      a_D0           ds_D0       dds_D0
"""

from __future__ import annotations

import re
from math import nan

from tmmcalc.core.mistake import Asked
from tmmcalc.naming.language import Name, parse

STAGE = "kinematics"
RATE = re.compile(r"(v|a)(S|x|y)_(.+)")
SLIDE = re.compile(r"(v|a)_(.+)")
TURNING = re.compile(r"(omega|eps)_(.+)")
FUNCTION = re.compile(r"(dd?)(S|x|y|s|angle)_(.+)")
LENGTH = re.compile(r"(?:dd?)?(?:S|x|y|s)_.+|stroke_.+")
ORDER = {"v": "d", "a": "dd", "omega": "d", "eps": "dd"}
OUTPUT, ANGLE = {"d": "v", "dd": "a"}, {"d": "omega", "dd": "eps"}


def analogue(name: str) -> str:
    """The transfer function of a velocity or an acceleration; empty for other names.

    >>> import tmmcalc.rooms
    >>> analogue("kinematics.aS_D@3"), analogue("kinematics.omega_2@3"), analogue("kinematics.S_D@3")
    ('kinematics.ddS_D@3', 'kinematics.dangle_2@3', '')
    """
    asked = parse(name)
    if found := RATE.fullmatch(asked.what):
        return _renamed(asked, f"{ORDER[found[1]]}{found[2]}_{found[3]}")
    if found := TURNING.fullmatch(asked.what):
        return _renamed(asked, f"{ORDER[found[1]]}angle_{found[2]}")
    if found := SLIDE.fullmatch(asked.what):
        return _renamed(asked, f"{ORDER[found[1]]}s_{found[2]}")
    return ""


def in_time(name: str) -> str:
    """The velocity or the acceleration of a transfer function; empty for other names.

    >>> import tmmcalc.rooms
    >>> in_time("kinematics.ddS_D@3"), in_time("kinematics.dangle_2@3"), in_time("kinematics.ds_D0@3")
    ('kinematics.aS_D@3', 'kinematics.omega_2@3', 'kinematics.v_D0@3')
    """
    asked = parse(name)
    found = FUNCTION.fullmatch(asked.what)
    if not found:
        return ""
    order, of, what = found.groups()
    if of == "angle":
        return _renamed(asked, f"{ANGLE[order]}_{what}")
    return _renamed(asked, f"{OUTPUT[order]}{'' if of == 's' else of}_{what}")


def other_axis(name: str) -> str:
    """The same projected on the other axis; empty for what is no projection.

    >>> import tmmcalc.rooms
    >>> other_axis("kinematics.vx_B@3"), other_axis("forces.R_A_y@3"), other_axis("kinematics.S_D@3")
    ('kinematics.vy_B@3', 'forces.R_A_x@3', '')
    """
    asked = parse(name)
    if found := re.fullmatch(r"(v|a|dd?|)(x|y)_(.+)", asked.what):
        return _renamed(asked, f"{found[1]}{_other(found[2])}_{found[3]}")
    if found := re.fullmatch(r"(R_.+_)(x|y)", asked.what):
        return _renamed(asked, f"{found[1]}{_other(found[2])}")
    return ""


def other_stroke(name: str) -> str:
    """The angle of the other stroke; empty for what is none.

    >>> import tmmcalc.rooms
    >>> other_stroke("kinematics.working_D"), other_stroke("kinematics.stroke_D")
    ('kinematics.idle_D', '')
    """
    asked = parse(name)
    for one, other in (("working_", "idle_"), ("idle_", "working_")):
        if asked.what.startswith(one):
            return _renamed(asked, other + asked.what.removeprefix(one))
    return ""


def is_acceleration(name: str) -> bool:
    """Whether it names a column that is per second squared."""
    return parse(analogue(name) or "d").what.startswith("dd")


def is_length(name: str) -> bool:
    """Whether it names a column in lengths alone, which the crank's own makes dimensionless."""
    return parse(name).stage == STAGE and LENGTH.fullmatch(parse(name).what) is not None


def speed(asked: Asked) -> float:
    """Speed of the crank [rad/s]; NaN where the input is a slider or has none."""
    given = asked.spec.mechanism.input.speed if asked.spec.mechanism is not None else None
    return float(given) if given else nan


def length_of_crank(asked: Asked) -> float:
    """Length of the crank [m]; NaN without one."""
    from tmmcalc.linkage.chain import Chain
    from tmmcalc.linkage.kinematics import crank_length
    from tmmcalc.linkage.structure import solve_structure
    from tmmcalc.linkage.tables.tasks.mechanism import to_linkage

    mechanism = to_linkage(asked.spec.linkage)
    return crank_length(Chain(mechanism, solve_structure(mechanism), ())) or nan


def _renamed(asked: Name, what: str) -> str:
    return asked._replace(what=what).text


def _other(axis: str) -> str:
    return "y" if axis == "x" else "x"
