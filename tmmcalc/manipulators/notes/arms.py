"""Joints and gripper at a row: the inverse problem of each arm, and the direct one (2.100 to 2.103)."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.manipulators.notes.told import Told
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Heading, Paragraph

BASE = (
    "psi = atan2(y, x)",
    "r = sqrt(x**2 + y**2)",
    "v_r = v_x*cos(psi) + v_y*sin(psi)",
    "omega_1 = (v_y*cos(psi) - v_x*sin(psi))/r",
    "a_r = a_x*cos(psi) + a_y*sin(psi) + r*omega_1**2",
    "eps_1 = (a_y*cos(psi) - a_x*sin(psi) - 2*v_r*omega_1)/r",
)
INVERSE = {
    "spherical": (
        "l_3 = sqrt(<r>**2 + (<z> - H)**2)",
        "phi_2 = atan2(<z> - H, <r>)",
        "v_3 = v_<r>*cos(phi_2) + v_<z>*sin(phi_2)",
        "omega_2 = (v_<z>*cos(phi_2) - v_<r>*sin(phi_2))/l_3",
        "a_3 = a_<r>*cos(phi_2) + a_<z>*sin(phi_2) + l_3*omega_2**2",
        "eps_2 = (a_<z>*cos(phi_2) - a_<r>*sin(phi_2) - 2*v_3*omega_2)/l_3",
    ),
    "cylindrical": ("h = <z> - H", "v_h = v_<z>", "a_h = a_<z>"),
    "angular": (
        "l = sqrt(<r>**2 + (<z> - H)**2)",
        "phi_2 = atan2(<z> - H, <r>) <e> acos((l_a**2 + l**2 - l_b**2)/(2*l_a*l))",
        "phi_3 = atan2(<z> - H - l_a*sin(phi_2), <r> - l_a*cos(phi_2))",
        "gamma = phi_3 - phi_2",
        "omega_2 = (v_<r>*cos(phi_3) + v_<z>*sin(phi_3))/(l_a*sin(gamma))",
        "omega_3 = -(v_<r>*cos(phi_2) + v_<z>*sin(phi_2))/(l_b*sin(gamma))",
        "eps_2 = (a_<r>*cos(phi_3) + a_<z>*sin(phi_3) + l_a*omega_2**2*cos(gamma) + l_b*omega_3**2)/(l_a*sin(gamma))",
        "eps_3 = -(a_<r>*cos(phi_2) + a_<z>*sin(phi_2) + l_a*omega_2**2 + l_b*omega_3**2*cos(gamma))/(l_b*sin(gamma))",
    ),
}
REACH = ("r = x", "v_r = v_x", "a_r = a_x")  # of a cylindrical arm without a base, the other way too
DIRECT = {
    "spherical": (
        "<r> = l_3*cos(phi_2)",
        "<z> = H + l_3*sin(phi_2)",
        "v_<r> = v_3*cos(phi_2) - l_3*omega_2*sin(phi_2)",
        "v_<z> = v_3*sin(phi_2) + l_3*omega_2*cos(phi_2)",
        "a_<r> = (a_3 - l_3*omega_2**2)*cos(phi_2) - (l_3*eps_2 + 2*v_3*omega_2)*sin(phi_2)",
        "a_<z> = (a_3 - l_3*omega_2**2)*sin(phi_2) + (l_3*eps_2 + 2*v_3*omega_2)*cos(phi_2)",
    ),
    "cylindrical": ("<z> = H + h", "v_<z> = v_h", "a_<z> = a_h"),
    "angular": (
        "<r> = l_a*cos(phi_2) + l_b*cos(phi_3)",
        "<z> = H + l_a*sin(phi_2) + l_b*sin(phi_3)",
        "v_<r> = -l_a*omega_2*sin(phi_2) - l_b*omega_3*sin(phi_3)",
        "v_<z> = l_a*omega_2*cos(phi_2) + l_b*omega_3*cos(phi_3)",
        "a_<r> = -l_a*(eps_2*sin(phi_2) + omega_2**2*cos(phi_2)) - l_b*(eps_3*sin(phi_3) + omega_3**2*cos(phi_3))",
        "a_<z> = l_a*(eps_2*cos(phi_2) - omega_2**2*sin(phi_2)) + l_b*(eps_3*cos(phi_3) - omega_3**2*sin(phi_3))",
        "gamma = phi_3 - phi_2",
    ),
}
TURNED = (
    "x = r*cos(psi)",
    "y = r*sin(psi)",
    "v_x = v_r*cos(psi) - r*omega_1*sin(psi)",
    "v_y = v_r*sin(psi) + r*omega_1*cos(psi)",
    "a_x = (a_r - r*omega_1**2)*cos(psi) - (r*eps_1 + 2*v_r*omega_1)*sin(psi)",
    "a_y = (a_r - r*omega_1**2)*sin(psi) + (r*eps_1 + 2*v_r*omega_1)*cos(psi)",
)
ELBOW = ("x_E = l_a*cos(phi_2)", "y_E = H + l_a*sin(phi_2)")
TURNED_ELBOW = ("x_E = l_a*cos(phi_2)*cos(psi)", "y_E = l_a*cos(phi_2)*sin(psi)", "z_E = H + l_a*sin(phi_2)")


def inverse(told: Told) -> Iterator[Block]:
    """The joints that lead the gripper, at the shown rows."""
    arm = told.arm
    yield Heading(tr("Inverse problem: joint coordinates"), 2)
    if arm.spatial:
        yield Paragraph(tr("The turning base and the distance of the gripper from its axis:"))
        yield from told.lines(BASE, told.rows, {}, None)
    yield Paragraph(_said(told))
    reach = REACH if arm.kind == "cylindrical" and not arm.spatial else ()
    words = {"e": "+" if arm.elbow > 0 else "-"}
    yield from told.lines((*reach, *INVERSE[arm.kind]), told.rows, {}, words)
    yield from _elbow(told)


def direct(told: Told) -> Iterator[Block]:
    """The gripper that the joints lead, at the shown rows."""
    arm = told.arm
    yield Heading(tr("Direct problem: motion of the gripper"), 2)
    yield Paragraph(_said(told))
    reach = (
        () if arm.kind != "cylindrical" or arm.spatial else tuple(" = ".join(each.split(" = ")[::-1]) for each in REACH)
    )
    yield from told.lines((*reach, *DIRECT[arm.kind]), told.rows, {}, None)
    yield from _elbow(told)
    if arm.spatial:
        yield Paragraph(tr("The base turns the plane of the arm:"))
        yield from told.lines(TURNED, told.rows, {}, None)


def _said(told: Told) -> str:
    """What the coordinates of the arm in its plane are."""
    return {
        "spherical": tr("The arm in its vertical plane, extension and angle with their derivatives:"),
        "cylindrical": tr("The arm in its vertical plane, height and reach with their derivatives:"),
        "angular": tr("The two arms in their vertical plane, with the angle of the elbow and the rates:"),
    }[told.arm.kind]


def _elbow(told: Told) -> Iterator[Block]:
    """The place of the elbow."""
    if told.arm.kind == "angular":
        yield Paragraph(tr("The place of the elbow:"))
        yield from told.lines(TURNED_ELBOW if told.arm.spatial else ELBOW, told.rows, {}, None)
