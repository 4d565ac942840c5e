"""Quantities of constraints in words: what a column of a stage is, with its letter, and what of it is asked."""

from __future__ import annotations

import re
from collections.abc import Mapping

from tmmcalc.core.notes import Phrase
from tmmcalc.feasibility.judge import ASKED
from tmmcalc.report.drawing.lettering import point_name
from tmmcalc.report.language import tr, tr_name
from tmmcalc.report.telling import titled


def worded(quantity: str) -> str:
    """The quantity of a constraint as a person says it; one without words by its name, as the spec has it."""
    if not isinstance(quantity, Phrase):
        return tr_name(quantity)
    stage, column = str(quantity.values["stage"]), str(quantity.values["column"])
    named = _named(stage, column)
    if not named:
        return _broken(tr_name(quantity))
    of = next((key for key, template in ASKED.items() if template == quantity.template), "")
    asked = {
        "max": tr("the largest value"),
        "min": tr("the least value"),
        "range": tr("the range"),
        "mean": tr("the mean value"),
        "size": tr("the largest magnitude"),
        "first": tr("the first value"),
        "last": tr("the last value"),
        "rms": tr("the root mean square"),
    }.get("" if stage == "synthesis" else of, "")
    return f"{named}: {asked}" if asked else named


def _named(stage: str, column: str) -> str:
    """A column in words with its letter; empty where there are none."""
    link, point, pin = "{link}", "{point}", "{pin}"
    words: Mapping[str, tuple[tuple[str, str, str], ...]] = {
        "kinematics": (
            (r"omega_(\w+)", tr("angular velocity of link {link}", link=link), "omega_<>"),
            (r"eps_(\w+)", tr("angular acceleration of link {link}", link=link), "eps_<>"),
            (r"angle_(\w+)", tr("angle of link {link}", link=link), "phi_<>"),
            (r"stroke_(\w+)", tr("stroke of {point}", point=point), "h_<>"),
            (r"K_(\w+)", tr("ratio of the times of the strokes of {point}", point=point), "K_<>"),
        ),
        "forces": (
            (r"R_([A-Za-z]\w*)", tr("reaction in pair {pin}", pin=pin), "R_<>"),
            (r"M_drive", tr("balancing moment"), "M_d"),
        ),
        "synthesis": (
            (r"transmission_min", tr_name("least transmission angle"), "mu_m"),
            (r"([a-zA-Z])", tr("size of the linkage"), "<>"),
        ),
    }
    for pattern, said, letter in words.get(stage, ()):
        if found := re.fullmatch(pattern, column):
            name = found[1] if found.groups() else ""
            of_point = titled(point_name(name)) if name else ""
            place = {link: name, point: of_point, pin: of_point}
            for key, put in place.items():
                said = said.replace(key, put)
            symbol = letter.replace("<>", f"{{{name}}}" if "_" in letter else name)
            return f"{said} ${symbol}$"
    return ""


def _broken(name: str) -> str:
    """A name with places where a line of a narrow column may end."""
    return name.replace("_", "_\u200b")
