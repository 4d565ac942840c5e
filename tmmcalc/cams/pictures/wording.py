"""Words of the cams' pictures in the language in force: senses, walls, sizes, designs, constraints."""

from __future__ import annotations

from math import degrees

from tmmcalc.cams.follower import Follower
from tmmcalc.cams.profile.results import WallName
from tmmcalc.cams.synthesis.results import Design
from tmmcalc.report.drawing.lettering import minus
from tmmcalc.report.language import tr, tr_name, tr_unit
from tmmcalc.report.numbers import number


def sense_of(follower: Follower) -> str:
    """The sense in which the cam turns."""
    return tr("clockwise") if follower.sense > 0 else tr("counter-clockwise")


def wall_name(name: WallName) -> str:
    """A curve of the profile."""
    names = {
        "inner": tr("working profile"),
        "outer": tr("second wall"),
        "tool": tr("tool path"),
        "outer tool": tr("second tool path"),
    }
    return names[name]


def mm(value: float, digits: int = 5) -> str:
    """A length [m] in mm, without its unit."""
    return minus(number(1e3 * value + 0.0, digits))


def deg(value: float, digits: int = 5) -> str:
    """An angle [rad] in degrees, with their sign; what is less than a hundred-thousandth is zero."""
    return f"{minus(number(float(f'{degrees(value):.5f}') + 0.0, digits))}°"


def phase_name(kind: str) -> str:
    """A phase of the motion."""
    return {"high dwell": tr("far dwell"), "low dwell": tr("near dwell")}.get(kind) or tr_name(kind)


def limit_name(kind: str) -> str:
    """The permissible pressure angle of a phase: of a rise or of a return."""
    return "$θ_{Pc}$" if kind == "return" else "$θ_P$"


def design_name(design: Design, sense: int) -> str:
    """A design of the synthesis; at a given offset with this, in the user's sense."""
    names = {
        "least base circle": tr("Least base circle"),
        "least base circle and S0": tr("Least base circle and $S_0$"),
        "least base circle and l0": tr("Least base circle and $l_0$"),
        "least start distance": tr("Least $S_0$"),
        "least centre distance": tr("Least centre distance"),
        "textbook": tr("Textbook"),
        "textbook (5.44)": tr("Textbook, approximately"),
        "textbook (5.50, 5.51)": tr("Textbook, approximately"),
    }
    if design.name in names:
        return names[design.name]
    head = design.name.partition(", ")[0]
    return f"{names[head]}, $e$ = {mm(sense * design.offset, 6)} {tr_unit('mm')}"


def constraint_name(number_of: int) -> str:
    """A constraint of the optimal design by its number in the textbook's table 5.5, of a rocker up to 11."""
    names = {
        1: tr("closure of the pair"),
        2: tr("roller without slip"),
        3: tr("no undercut"),
        4: tr("concave parts"),
        5: tr("roller on its pin"),
        6: tr("shaft strength"),
        7: tr("bending of the stem"),
        8: tr("pressure in the guide"),
        9: tr("contact stress"),
        10: tr("pressure angle of the cam"),
        11: tr("room at the pivot"),
    }
    return names[number_of]
