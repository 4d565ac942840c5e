"""How the shifts of a pair are chosen, in words."""

from __future__ import annotations

from tmmcalc.gears.meshing.task import PairTask
from tmmcalc.report.language import tr, tr_number
from tmmcalc.report.numbers import number


def chosen(task: PairTask) -> str:
    """The rule of the shifts of a pair."""
    rules = {
        "given": tr("The shifts are given."),
        "given_aw": tr("The centre distance is given; the sum of the shifts follows from it."),
        "max_contact_strength": tr("The shifts are those of the largest sum in the blocking contour (point C)."),
        "equal_sliding": tr(
            "The shifts are those of equal specific sliding at the contact ratio {ratio} (point D).",
            ratio=tr_number(number(task.desired)),
        ),
        "max_contact_ratio": tr("The shifts are those of the largest contact ratio in the blocking contour (point E)."),
        "zero": tr("The wheels are cut without shifts."),
        "equal_shift": tr("The shifts are equal in size and opposite in sign."),
        "equal_strength": tr("The shifts are those of the largest sum at which the tooth form factors are equal."),
        "balanced": tr("The shifts are those farthest from all lines of the blocking contour."),
    }
    if task.strategy == "balanced" and task.kind == "rack":
        return tr("The shift of the pinion is the least without undercut, or none.")
    if task.strategy not in ("given_aw", "equal_shift") or task.kind == "rack":
        return rules[task.strategy]
    given = [f"$x_{k}$" for k, shift in enumerate(task.shifts, 1) if shift is not None]
    if given:
        return f"{rules[task.strategy]} {tr('The shift {name} is given.', name=given[0])}"
    splits = {
        "equal_sliding": tr("The sum is divided so that the largest specific sliding of both wheels is equal."),
        "equal_strength": tr("The sum is divided so that the tooth form factors of both wheels are equal."),
        "max_contact_ratio": tr("The sum is divided so that the contact ratio is the largest."),
        "middle": tr("The sum is divided in the middle of what is admissible."),
    }
    return f"{rules[task.strategy]} {splits[task.split]}"
