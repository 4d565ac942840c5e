"""The document of Zhukovsky's lever: every force with its arm and moment, the balance beside the force analysis."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from tmmcalc.core.quantity import Quantity, keyed, table
from tmmcalc.linkage.forces.columns import drive_of
from tmmcalc.linkage.forces.kinetostatics import Statics
from tmmcalc.linkage.forces.results import Forces, side_of
from tmmcalc.linkage.forces.terms import BY_LEVER, OFF_LEVER
from tmmcalc.linkage.lever import Lever, LeverForce, levers, velocity_scale
from tmmcalc.linkage.results import Kinematics
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.numbers import number

POSITION = Quantity("i", "number of the position").key
SHARE = Quantity("{name}_difference[%]", "the same, against the largest {name} of the motion")


def lever_document(
    statics: Statics, kinematics: Kinematics, result: Forces, title: str, rows: Sequence[int]
) -> Document:
    """The levers of rows of the result by their indices, all to one round scale."""
    theta, side = result.theta[rows], np.array([side_of(result, row) for row in rows])
    mu = velocity_scale(statics, kinematics, theta)
    found = levers(statics, kinematics, theta, side, mu)
    facts = [
        Fact("plan", "of velocities, turned by 90 deg clockwise: moments about the pole are powers over its scale"),
        Fact("scale", f"mu_v = {number(mu)} (m/s)/mm", keyed(found[0], "mu")),
        *(_balance(result, result.labels[row], each) for row, each in zip(rows, found, strict=True)),
    ]
    labels = [result.labels[row] for row, each in zip(rows, found, strict=True) for _ in each.forces]
    columns = {POSITION: labels, **table([force for each in found for force in each.forces], LeverForce)}
    return Document(title, tuple(facts), table=View([*columns], [*columns.values()]))


def _balance(result: Forces, label: str, found: Lever) -> Fact:
    """The drive that balances the lever, that of the force analysis, and what they differ by."""
    drive = drive_of(result.turns)
    places = {"name": drive.name, "unit": drive.unit}
    largest = max(abs(extreme.value) for extreme in result.drive_extremes)
    share = 100 * found.difference / largest if largest else 0.0
    text = (
        f"sum of moments {number(found.moment, peak=_peak(found))} N*mm\n"
        f"{drive.name} {number(found.drive, peak=largest)} {drive.unit} by the lever, "
        f"{number(found.kinetostatic, peak=largest)} {drive.unit} by the force analysis\n"
        f"difference {found.difference:.0e} {drive.unit}, {share:.0e} % of the largest"
    )
    values = {
        **keyed(found, "moment"),
        BY_LEVER.of(**places).key: found.drive,
        drive.key: found.kinetostatic,
        OFF_LEVER.of(**places).key: found.difference,
        SHARE.of(**places).key: share,
    }
    return Fact(f"balance in position {label}", text, {f"balance_in_{label}": values})


def _peak(found: Lever) -> float:
    return max((abs(force.moment) for force in found.forces), default=0.0)
