"""The chapter on the pendulum-rotor: rod and disc, the rigid rotor, whirl, critical speeds, torsion, motion in time."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.digits import RESULT, Given, significant
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.language import tr, tr_number, tr_unit
from tmmcalc.report.manuscript import Block, Display, Heading, Lexicon, Paragraph, Place, Result, Table
from tmmcalc.report.telling import column_of, lines, named, pictured
from tmmcalc.vibration.notes.rotor import rotor, sections, whole
from tmmcalc.vibration.notes.whirling import campbell, critical, unbalance, whirling
from tmmcalc.vibration.pendulum.results import PendulumResult
from tmmcalc.vibration.pendulum.solve import rigid_body
from tmmcalc.vibration.pendulum.task import PendulumTask
from tmmcalc.vibration.pendulum.torsion import section_inertia, torsion_roots
from tmmcalc.vibration.pictures.pendulum import pieces_of
from tmmcalc.vibration.tables.tasks.vibration import to_pendulum

ROWS = 20  # of the table of the motion


def blocks(order: Order) -> Iterator[Block]:
    """The rotor as a calculation by hand finds it."""
    task, result = to_pendulum(order.spec), order.results["pendulum"]
    pieces = pieces_of(result)
    yield Heading(tr("The pendulum-rotor and its data"), 2)
    yield from sections(task, order.spec.pendulum)
    if result.rigid is not None:
        yield from _rigid(task, result)
    yield from whirling(task, result)
    yield Paragraph(
        tr(
            "Figure {fig:pendulum_modes} shows the mode shapes along the rod, the largest displacement of each being "
            "1; the higher the mode, the more the rod bends."
        )
    )
    yield pictured(pieces["modes"], key="pendulum_modes")
    yield from critical(task, result)
    if result.campbell is not None:
        yield from campbell(result.campbell)
        yield pictured(pieces["campbell"], key="pendulum_campbell")
    if result.deflection is not None:
        yield from unbalance(task, result)
    if len(result.torsion):
        yield from _torsion(task, result)
    if result.swing is not None:
        yield from _swing(task, result)
        yield Paragraph(
            tr(
                "Figure {fig:pendulum_swing} shows the path of the lower end seen from above, against the joint, and "
                "over the time its displacements and the place of the joint."
            )
        )
        yield pictured(pieces["swing"], key="pendulum_swing")


def data(order: Order) -> Iterator[Block]:
    """Rod, disc and joint, the spin, the motion in time."""
    yield from whole(to_pendulum(order.spec), order.spec.pendulum)


def _rigid(task: PendulumTask, result: PendulumResult) -> Iterator[Block]:
    """The frequencies of the rotor if it did not bend."""
    assert result.rigid is not None
    body = rigid_body(task)
    forward, backward = result.rigid
    known = {
        **rotor(task),
        "I_t": Given(body.inertia, "kg*m^2", tr("moment of inertia about a horizontal axis through the joint")),
        "I_p": Given(body.polar, "kg*m^2", tr("moment of inertia about the rod")),
        "K_t": Given(body.stiffness, "N*m/rad", tr("stiffness against a tilt")),
        "omega_f": Given(forward, "rad/s", tr("frequency of the forward whirl of the rigid rotor")),
        "omega_b": Given(backward, "rad/s", tr("frequency of the backward whirl of the rigid rotor")),
        "omega_r": Given(forward, "rad/s", tr("natural frequency of the rigid rotor")),
    }
    yield Heading(tr("The rigid rotor"), 2)
    yield Paragraph(
        tr(
            "If the rod did not bend, the rotor would be a gyroscopic pendulum. Its frequencies are an estimate "
            "of the lowest ones of the elastic rotor:"
        )
    )
    place = [Place("", named(known))]
    yield from lines(
        [
            "I_t = rho*l**3/3 + rho*l*i**2 + m*l**2 + J_d",
            "K_t = g*(rho*l/2 + m)*l + k",
        ],
        place,
    )
    if not task.spin:
        yield from lines(["omega_r = sqrt(K_t/I_t)"], place)
        return
    yield from lines(["I_p = 2*rho*l*i**2 + J_p"], place)
    yield Paragraph(tr("The whirl with the frequency $omega$ satisfies"))
    yield Display(read("I_t*omega**2 - I_p*Omega*omega - K_t = 0"))
    half, root = "I_p*Omega/(2*I_t)", "sqrt((I_p*Omega/(2*I_t))**2 + K_t/I_t)"
    yield from lines([f"omega_f = {half} + {root}", f"omega_b = {root} - {half}"], place)


def _torsion(task: PendulumTask, result: PendulumResult) -> Iterator[Block]:
    """The natural frequencies of torsion."""
    polar, section = task.disc.polar, section_inertia(task)
    yield Heading(tr("Torsion"), 2)
    yield Paragraph(tr("The drive holds the upper end of the rod; its torsion is that of a shaft."))
    known = named(
        {
            **rotor(task),
            "C_p": Given(task.rod.torsion or 0.0, "N*m^2", tr("torsional stiffness of the rod")),
            "j": Given(section, "kg*m", tr("polar moment of inertia of a metre of the rod")),
            "J_p": Given(polar, "kg*m^2", tr("polar moment of inertia of the disc")),
        }
    )
    if not section:
        omega = Given(float(result.torsion[0]), "rad/s", tr("natural frequency of torsion"))
        yield from lines(["omega_1 = sqrt(C_p/(l*J_p))"], [Place("", {**known, "omega_1": omega})])
        return
    inertia = "j = 2*rho*i**2" if task.axisymmetric else "j = rho*(i_x**2 + i_y**2)"
    yield from lines([inertia], [Place("", known)])
    roots = torsion_roots(task, len(result.torsion))
    places = [
        Place(
            "",
            {
                **known,
                "b_i": Given(float(root), "", tr("root of the frequency equation")),
                "omega_i": Given(float(omega), "rad/s", tr("natural frequency of torsion")),
            },
            str(k),
        )
        for k, (root, omega) in enumerate(zip(roots, result.torsion, strict=True), 1)
    ]
    if polar:
        yield Paragraph(tr("Its frequency equation $b*tan(b) = j*l/J_p$ has the roots {roots}.", roots=_listed(roots)))
        for place, k in zip(places, range(1, len(places) + 1), strict=True):
            own = {**place.lexicon, f"b_{k}": place.lexicon["b_i"]._replace(meaning="")}
            yield from lines([f"tan(b_{k}) = j*l/(J_p*b_{k})"], [Place("", own)])
    else:
        yield Paragraph(tr("Its frequency equation $cos(b) = 0$ has the roots {roots}.", roots=_listed(roots)))
    yield from lines(["omega_i = b_i/l*sqrt(C_p/j)"], places)
    first = Given(float(result.torsion[0]) / (2 * math.pi), "Hz", tr("lowest natural frequency of torsion"))
    yield Result("f_t", first)


def _listed(roots: np.ndarray) -> str:
    return "; ".join(tr_number(significant(float(root), RESULT)) for root in roots)


def _swing(task: PendulumTask, result: PendulumResult) -> Iterator[Block]:
    """The motion of the lower end in time."""
    asked, course = task.swing, result.swing
    assert asked is not None
    assert course is not None
    yield Heading(tr("Motion in time"), 2)
    began: Lexicon = named(
        {
            "v_0": Given(float(course.v[0]), "m", tr("displacement of the lower end along $x$ at the beginning")),
            "theta_0": Given(math.degrees(asked.tilt), "deg", tr("tilt of the rod at the beginning")),
            "l": Given(task.rod.length, "m", tr("length of the rod")),
            "v_d": Given(asked.deflection, "m", tr("displacement by the force that bends the rod")),
        }
    )
    yield Paragraph(
        tr("The rotor moves from rest, hanging from the carrier that moves.")
        if not (asked.tilt or asked.deflection or asked.push)
        else tr("The rotor is let go from a deflection; hanging from the carrier that moves it swings.")
        if asked.times
        else tr("The rotor is let go from a deflection.")
    )
    if asked.tilt or asked.deflection:
        yield from lines(["v_0 = l*rad(theta_0) + v_d"], [Place("", began)])
    yield Paragraph(
        tr(
            "Between the times at which the acceleration of the carrier changes the motion is a sum of the whirl "
            "modes about the equilibrium and the whirl of the unbalance. Table {table} has displacements and slopes "
            "of the lower end against the joint, and the place of the joint; energy and work differ by {part} of the "
            "largest energy.",
            table="{tab:pendulum_swing_rows}",
            part=f"${significant(course.balance, 2)}$",
        )
    )
    rows = np.unique(np.linspace(0, len(course.t) - 1, ROWS + 1).round().astype(int))
    columns = {
        f"$t$, {tr_unit('s')}": course.t,
        f"$v$, {tr_unit('mm')}": 1e3 * course.v,
        f"$w$, {tr_unit('mm')}": 1e3 * course.w,
        f"$v_a$, {tr_unit('rad')}": course.slope_v,
        f"$w_a$, {tr_unit('rad')}": course.slope_w,
        f"$x_O$, {tr_unit('m')}": course.carrier_x,
        f"$y_O$, {tr_unit('m')}": course.carrier_y,
        f"$E$, {tr_unit('J')}": course.energy,
    }
    shown = {name: column_of(values[rows]) for name, values in columns.items()}
    caption = tr("Motion of the lower end")
    yield Table(caption, tuple(shown), tuple(zip(*shown.values(), strict=True)), "pendulum_swing_rows")
    far = tr_number(significant(1e3 * course.distance, RESULT))
    at = tr_number(significant(course.distance_at, RESULT))
    slope = tr_number(significant(math.degrees(course.slope), RESULT))
    yield Paragraph(
        tr(
            "The lower end comes at most {far} mm from under the joint, at $t$ = {at} s; its largest slope is "
            "{slope}°.",
            far=far,
            at=at,
            slope=slope,
        )
    )
    yield Result("v_{max}", Given(1e3 * course.distance, "mm", tr("largest distance of the lower end")))
