"""The open pair of gears on the crank: ratio, efficiency, inertia, torques, forces in the mesh, stresses."""

from __future__ import annotations

from collections.abc import Iterator
from math import atan

from tmmcalc.gears.meshing.results import MeshPair
from tmmcalc.gears.notes.pairs.lexicon import angle, length
from tmmcalc.gears.openload import BY_SIZES, OpenLoad
from tmmcalc.gears.strength.results import Strength
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.digits import RESULT, Given, significant
from tmmcalc.report.language import tr, tr_name, tr_unit
from tmmcalc.report.manuscript import Block, Heading, Lexicon, Listing, Paragraph, Place
from tmmcalc.report.telling import lines, named

RATIO = "u = z_2/z_1"
INERTIA = "J_ab = J_a*u**2 + J_b"
TORQUE = "T_a = T_b/u"
FORCES = (
    "F_t = 1000*T_b/r_w2",
    "F_r = F_t*tan(alpha_tw)",
    "beta_w = atan(tan(beta)*r_w2/r_2)",
    "F_a = F_t*tan(beta_w)",
    "F_n = sqrt(F_t**2 + F_r**2)",
)
STRESSES = (("contact", "sigma_H", "sigma_HP"), ("bending", "sigma_F", "sigma_FP"))


def blocks(order: Order) -> Iterator[Block]:
    """What it is to the drive, and what loads its teeth."""
    found: OpenLoad = order.results["open_pair"]
    pair = next(each for each in order.results["pair"].pairs if each.task == found.task.open.pair)
    place = Place("", named(_quantities(found, pair)))
    yield Heading(tr("Open pair on the crank"))
    yield Paragraph(tr("Pinion a stands on the output shaft of the reducer, gear b on the crank."))
    yield from lines((RATIO,), (place,))
    efficiency, origin = f"$eta = {significant(found.efficiency, RESULT)}$", tr_name(found.efficiency_of)
    yield Paragraph(tr("The efficiency of the pair is {efficiency} ({origin}).", efficiency=efficiency, origin=origin))
    if found.inertia_of == BY_SIZES:
        yield Paragraph(tr("The moments of inertia of the wheels are those of their sizes; reduced to the crank"))
        yield from lines((INERTIA,), (place,))
    else:
        given = f"$J_ab = {significant(found.inertia, RESULT)}$ {tr_unit('kg*m^2')}"
        yield Paragraph(
            tr("The moment of inertia of the pair reduced to the crank is given, {inertia}.", inertia=given)
        )
    if found.torque is None:
        yield Paragraph(tr("Nothing loads the crank: the forces in the mesh are not known."))
        return
    yield Paragraph(tr("The gear bears the largest moment on the crank; losses are neglected."))
    yield from lines((TORQUE, *FORCES), (place,))
    if found.strength is not None:
        yield from _stresses(found.strength)


def _stresses(found: Strength) -> Iterator[Block]:
    """Stresses at the given module and face width beside the permissible ones."""
    yield Paragraph(tr("Stresses of the teeth at the given module and face width:"))
    items = []
    for kind, letter, limit in STRESSES:
        stress, most = (float(getattr(found, name)[0, 0]) / 1e6 for name in (f"{kind}_stress", f"permissible_{kind}"))
        sign, said = ("<=", tr("the condition holds")) if stress <= most else (">", tr("the condition fails"))
        sides = f"${letter} = {significant(stress, RESULT)} {sign} {limit} = {significant(most, RESULT)}$"
        items.append(f"{sides} {tr_unit('MPa')}, {said}")
    yield Listing(tuple(items))


def _quantities(found: OpenLoad, pair: MeshPair) -> Lexicon:
    """The pair by its wheels 1 and 2, its torques by pinion a and gear b."""
    task, gear = pair.task, pair.sizes[1]
    inertia = tr("moment of inertia of the pinion"), tr("moment of inertia of the gear")
    quantities = {
        "z_1": Given(float(task.teeth[0]), "", tr("number of teeth")),
        "z_2": Given(float(task.teeth[1]), "", tr("number of teeth")),
        "u": Given(found.ratio, "", tr("ratio of the open pair")),
        "J_a": Given(found.pinion_inertia, "kg*m^2", inertia[0]),
        "J_b": Given(found.gear_inertia, "kg*m^2", inertia[1]),
        "J_ab": Given(found.inertia, "kg*m^2", tr("moment of inertia of the pair reduced to the crank")),
        "r_2": length(gear.reference, tr("reference radius")),
        "r_w2": length(found.radius, tr("pitch radius")),
        "beta": angle(abs(task.helix), tr("helix angle")),
        "alpha_tw": angle(found.angle, tr("operating pressure angle")),
        "beta_w": angle(atan(abs(found.lead)), tr("helix angle on the pitch circle")),
    }
    if found.torque is None or found.pinion_torque is None or found.tangential is None:
        return quantities
    assert found.radial is not None
    assert found.axial is not None
    assert found.across is not None
    return quantities | {
        "T_b": Given(found.torque, "N*m", tr("largest torque on gear b")),
        "T_a": Given(found.pinion_torque, "N*m", tr("largest torque on pinion a")),
        "F_t": Given(found.tangential, "N", tr("tangential force in the mesh")),
        "F_r": Given(found.radial, "N", tr("radial force in the mesh")),
        "F_a": Given(abs(found.axial), "N", tr("axial force in the mesh")),
        "F_n": Given(found.across, "N", tr("force in the mesh in the transverse plane")),
    }
