"""Why a contour or a point of it is not there, in the language in force: the sentences of the results, read back."""

from __future__ import annotations

import re

from tmmcalc.report.language import spoken, tr, tr_name, tr_number

NONE = "C, D, E, balanced, equal strength: "  # no point, for want of a contour
MESH = re.compile(r"no shifts of z = (\S+) give a mesh (without|even with tolerated) undercut")
RATIO = re.compile(
    r"no shifts of z = (\S+) reach the contact ratio (\S+) (without|even with tolerated) undercut; "
    r"the best within the other conditions is (\S+)"
)
SLIDING = re.compile(r"D: no mesh has the contact ratio (\S+) and equal specific sliding")
OUTSIDE = re.compile(
    r"D: equal sliding at the contact ratio (\S+), x1 = (\S+), x2 = (\S+), lies outside the contour: (.+)"
)


def reason_of(text: str) -> str:
    """A reason of the results in the language in force."""
    if spoken() == "en":
        return text
    if text.startswith(NONE):
        return f"{tr('points C, D, E, balanced, equal strength')}: {reason_of(text.removeprefix(NONE))}"
    if found := MESH.fullmatch(text):
        return tr("no shifts of {teeth} give a mesh, {how}", teeth=f"z = {found[1]}", how=_undercut(found[2]))
    if found := RATIO.fullmatch(text):
        values = {"ratio": tr_number(found[2]), "best": tr_number(found[4]), "how": _undercut(found[3])}
        return tr(
            "no shifts of {teeth} reach the contact ratio {ratio}, {how}; the best is {best}",
            teeth=f"z = {found[1]}",
            **values,
        )
    if found := SLIDING.fullmatch(text):
        return tr("D: no mesh has the contact ratio {ratio} and equal specific sliding", ratio=tr_number(found[1]))
    if found := OUTSIDE.fullmatch(text):
        lines = ", ".join(map(tr_name, found[4].split(", ")))
        ratio, place = tr_number(found[1]), tr_number(f"x1 = {found[2]}; x2 = {found[3]}")
        return tr(
            "D: equal sliding at the contact ratio {ratio}, {place}, lies outside the contour: {lines}",
            ratio=ratio,
            place=place,
            lines=lines,
        )
    assert text.startswith("equal strength: "), text
    return tr("equal strength: no admissible shifts give both wheels the same tooth form factor")


def _undercut(said: str) -> str:
    return tr("without undercut") if said == "without" else tr("even with tolerated undercut")
