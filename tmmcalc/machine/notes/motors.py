"""The characteristic of the motor on the input shaft, its coefficients worked out by the kind of the motor."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import partial

import numpy as np

from tmmcalc.machine.driver import driver_of
from tmmcalc.machine.model import MotorChoice
from tmmcalc.machine.motors.braking import Braking, braking, critical_speed, independent
from tmmcalc.machine.motors.characteristics import Characteristic, Straight
from tmmcalc.machine.motors.direct_current import Series
from tmmcalc.machine.motors.gearing import Reduced
from tmmcalc.machine.motors.model import RPM, CharacteristicKind, Motor, characteristic
from tmmcalc.machine.pictures.characteristic import draw_motor, motor_curves
from tmmcalc.machine.power import Power
from tmmcalc.machine.tables.tasks.machine import to_motion, to_motor
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Datum, Display, Heading, Lexicon, Paragraph, Place
from tmmcalc.report.telling import between, drawn, in_rows, lines, named, tabulated

NEAR, WHOLE = 62.0, 58.0  # heights of the diagrams of the working part and of the whole characteristic [mm]
NAMELESS = "motor"  # what a motor without a name is called
FREQUENCY = 50.0  # of the mains, by which a lag follows from the critical slip [Hz]

RATED = ("omega_N = pi*n_N/(30*u)", "M_N = P_N<eta>/omega_N")
INDUCTION = (*RATED, "omega_c = pi*n_c/(30*u)")
LAWS = {
    "parabolic": (
        (*INDUCTION, "A_M = M_N*omega_c**2/(omega_c**2 - omega_N**2)", "B_M = M_N/(omega_c**2 - omega_N**2)"),
        ("M_d = A_M - B_M*omega**2",),
    ),
    "linear": ((*INDUCTION, "b_M = M_N/(omega_c - omega_N)"), ("M_d = b_M*(omega_c - omega)",)),
    "kloss": (
        (
            *INDUCTION,
            "M_K = lambda_M*M_N",
            "s_N = (n_c - n_N)/n_c",
            "s_K = s_N*(lambda_M + sqrt(lambda_M**2 - 1))",
            "omega_K = omega_c*(1 - s_K)",
            "M_p = 2*M_K*s_K/(1 + s_K**2)",
        ),
        ("M_d = 2*M_K*s*s_K/(s**2 + s_K**2)", "s = 1 - omega/omega_c"),
    ),
    "shunt": (
        (*RATED, "omega_c = U/(k_M*u)", "b_M = k_M**2*u**2<eta>/R_M"),
        ("M_d = b_M*(omega_c - omega)",),
    ),
    "shunt by speeds": ((*INDUCTION, "b_M = M_N/(omega_c - omega_N)"), ("M_d = b_M*(omega_c - omega)",)),
    "series": (
        (*RATED, "r = (1 - sqrt(1 - 4*R_M*P_N/U**2))/2", "beta = c_s/(1 - c_s)", "kappa = (1 - r)*(1 + beta)/omega_N"),
        ("r*j*(1 + beta*j) + kappa*omega*j = 1 + beta*j", "M_d = M_N*(1 + beta)*j**2/(1 + beta*j)"),
    ),
    "series by efficiency": (
        (*RATED, "r = 1 - eta_M", "beta = c_s/(1 - c_s)", "kappa = (1 - r)*(1 + beta)/omega_N"),
        ("r*j*(1 + beta*j) + kappa*omega*j = 1 + beta*j", "M_d = M_N*(1 + beta)*j**2/(1 + beta*j)"),
    ),
    "constant": (RATED, ("M_d = M_N",)),
    "table": ((), ()),
}
"""By the form of the characteristic: the lines of its coefficients, ``<eta>`` for the gears, and the law itself."""


def driven(order: Order) -> tuple[MotorChoice, Motor] | None:
    """The motor that the machine runs under, and how its characteristic is taken; None: none drives."""
    wish, power = to_motor(order.spec), order.results["power"]
    if wish is None or power.duty is None or to_motion(order.spec).positional:
        return None
    return wish, power.duty.motor


def first_told(order: Order, stage: str) -> bool:
    """Whether the chapter begins with this stage, so that it tells of the motor."""
    return next(each for each in ("flywheel", "motion", "transient") if each in order.results) == stage


def of_motor(order: Order, stage: str) -> Iterator[Block]:
    """The characteristic of the motor, at the beginning of the chapter."""
    found = driven(order)
    if found is None or not first_told(order, stage):
        return
    wish, motor = found
    power: Power = order.results["power"]
    assert power.duty is not None
    yield Heading(tr("Characteristic of the motor"), 2)
    yield from of_form(wish.characteristic, motor, power)
    if "motion" in order.results:
        curves = motor_curves(order.results["motion"], power.duty, power.transmission)
        yield Paragraph(tr("The characteristic and its working part are shown in figure {fig:motion_motor}."))
        draw = partial(draw_motor, motor=curves, scaled=True)
        high = NEAR if curves.kloss is None else NEAR + WHOLE
        yield drawn(tr("Characteristic of the motor and its working part"), draw, high, "motion_motor")


def of_form(kind: CharacteristicKind, motor: Motor, power: Power) -> Iterator[Block]:
    """One form of the characteristic: what it is, its coefficients, its law; the rated point stands with the power."""
    assert power.duty is not None
    curve = driver_of(motor, kind, power.duty.ratio, power.line.efficiency).characteristic
    yield Paragraph(_said(kind, motor))
    texts, laws = LAWS[_form(kind, motor)]
    lexicon = named({**motor_data(motor, power), **_coefficients(kind, motor, curve, power)})
    eta = "*eta_u" if power.line.efficiency < 1 else ""
    yield from lines([text for text in texts if text not in RATED], [Place("", lexicon)], {"eta": eta})
    if kind == "table":
        speeds = np.array([speed for speed, _ in motor.points]) / power.duty.ratio
        columns = {"$omega$, rad/s": speeds, "$M_d$, N*m": curve.moment(speeds)}
        labels = [str(k) for k in range(1, len(speeds) + 1)]
        yield tabulated(tr("Points of the characteristic on the input shaft"), columns, labels, head=tr("Point"))
    if laws:
        yield Paragraph(tr("The moment of the motor on the input shaft at the angular velocity $omega$ is"))
    for k, law in enumerate(laws):
        yield Display(read(law), "motor_law" if law.startswith("M_d") else "")
        if kind == "series" and not k:
            yield Paragraph(tr("where $j$ is the current in parts of the rated one; whence the moment"))
    if power.line.efficiency < 1 and kind not in ("constant", "table"):
        yield Paragraph(tr("Where the motor brakes, $eta_u$ divides its moment."))
    if motor.time_constant:
        yield from _lag(motor)


def _form(kind: CharacteristicKind, motor: Motor) -> str:
    if kind == "shunt" and motor.voltage is None and motor.resistance is None and motor.constant is None:
        return "shunt by speeds"
    return "series by efficiency" if kind == "series" and motor.voltage is None and motor.resistance is None else kind


def _said(kind: CharacteristicKind, motor: Motor) -> str:
    """What kind of a motor it is, and what is taken for its characteristic."""
    name = "" if motor.name == NAMELESS else f" {motor.name}"
    return {
        "parabolic": tr(
            "The machine is driven by the induction motor{motor}. The working part of its characteristic is replaced "
            "by a parabola through the rated and the synchronous point.",
            motor=name,
        ),
        "linear": tr(
            "The machine is driven by the motor{motor}. The working part of its characteristic is replaced by a "
            "straight line through the rated point and the point without load.",
            motor=name,
        ),
        "kloss": tr(
            "The machine is driven by the induction motor{motor}. Its whole characteristic is taken by the formula of "
            "Kloss.",
            motor=name,
        ),
        "shunt": tr(
            "The machine is driven by the direct-current motor{motor} with shunt field, whose characteristic is a "
            "straight line.",
            motor=name,
        ),
        "series": tr(
            "The machine is driven by the direct-current motor{motor} with series field. Its characteristic follows "
            "from the circuit of the armature.",
            motor=name,
        ),
        "constant": tr("The machine is driven by the motor{motor} with a constant moment.", motor=name),
        "table": tr("The machine is driven by the motor{motor}, whose characteristic is given by points.", motor=name),
    }[kind]


def motor_data(motor: Motor, power: Power) -> Lexicon:
    """What is known of the motor and of the gears."""
    assert power.duty is not None
    return {**plate(motor, power.duty.ratio), "eta_u": losses(power)}


def plate(motor: Motor, ratio: float | None = None) -> Lexicon:
    """What is known of the motor, and its speed over that of the input shaft."""
    no_load = _no_load(motor, tr("synchronous speed of the motor"), tr("speed of the motor without load"))
    known: dict[str, tuple[float | None, str, str]] = {
        "P_N": (motor.power, "W", tr("rated power of the motor")),
        "n_N": (motor.rated_rpm, "rpm", tr("rated speed of the motor")),
        "n_c": (motor.synchronous_rpm, "rpm", no_load),
        "u": (ratio, "", tr("speed ratio of the motor and the input shaft")),
        "lambda_M": (motor.overload, "", tr("overload factor of the motor")),
        "U": (motor.voltage, "V", tr("voltage of the motor")),
        "R_M": (motor.resistance, "Ohm", tr("resistance of the armature circuit")),
        "k_M": (motor.constant, "V*s/rad", tr("constant of the motor")),
        "c_s": (motor.saturation, "", tr("part of the flux that saturation takes at the rated current")),
        "eta_M": (motor.efficiency, "", tr("efficiency of the motor")),
    }
    return {key: Given(value, *told) for key, (value, *told) in known.items() if value is not None}


def points_of(motor: Motor) -> Iterator[Datum]:
    """What is given of a characteristic by points, on the shaft of the motor."""
    if motor.points:
        speeds, moments = zip(*motor.points, strict=True)
        rpm = tuple(speed * RPM for speed in speeds)
        yield from in_rows(
            Datum(tr("speeds of the motor at the points of its characteristic"), (), rpm, "rpm"),
            Datum(tr("moments of the motor at these points"), (), moments, "N*m"),
        )
        yield Datum(tr("characteristic between its points"), text=between(motor.interpolation))


def called(kind: CharacteristicKind) -> str:
    """A motor by the form of its characteristic, as what drives."""
    return {
        "parabolic": tr("motor, its characteristic a parabola through the rated and the synchronous point"),
        "linear": tr("motor, its characteristic a straight line through the rated point and the point without load"),
        "kloss": tr("motor, its characteristic by the formula of Kloss"),
        "shunt": tr("direct-current motor with shunt field"),
        "series": tr("direct-current motor with series field"),
        "constant": tr("motor with a constant moment"),
        "table": tr("motor, its characteristic by points"),
    }[kind]


def losses(power: Power) -> Given:
    """The efficiency of the gears."""
    return Given(power.line.efficiency, "", tr("efficiency of the gears between the motor and the input shaft"))


def _no_load(motor: Motor, synchronous: str, without_load: str) -> str:
    return synchronous if motor.kind == "induction" else without_load


def _coefficients(kind: CharacteristicKind, motor: Motor, curve: Characteristic, power: Power) -> Lexicon:
    """What the program has found, on the input shaft."""
    assert power.duty is not None
    assert power.rated_moment is not None
    rated = motor.speed / power.duty.ratio
    found = {
        "omega_N": Given(rated, "rad/s", tr("rated angular velocity, reduced to the input shaft")),
        "M_N": Given(power.rated_moment, "N*m", tr("rated moment, reduced to the input shaft")),
    }
    if curve.synchronous is not None:
        said = _no_load(
            motor,
            tr("synchronous angular velocity, reduced to the input shaft"),
            tr("angular velocity without load, reduced to the input shaft"),
        )
        found["omega_c"] = Given(curve.synchronous, "rad/s", said)
    if kind == "parabolic":
        said = tr("coefficient of the parabola")
        found["A_M"] = Given(curve.moment(0.0), "N*m", said)
        found["B_M"] = Given(-curve.slope(rated) / (2 * rated), "N*m*s^2/rad^2", said)
    if kind in ("linear", "shunt"):
        found["b_M"] = Given(-curve.slope(rated), "N*m*s/rad", tr("stiffness of the characteristic"))
    if kind == "kloss":
        assert curve.critical is not None
        found |= {
            "M_K": Given(curve.moment(curve.critical), "N*m", tr("largest moment, reduced to the input shaft")),
            "s_N": Given(motor.nominal_slip, "", tr("rated slip")),
            "s_K": Given(motor.critical_slip, "", tr("critical slip")),
            "omega_K": Given(curve.critical, "rad/s", tr("angular velocity of the largest moment")),
            "M_p": Given(curve.moment(0.0), "N*m", tr("starting moment, reduced to the input shaft")),
        }
    base = curve.base if isinstance(curve, Reduced) else curve
    if isinstance(base, Series):
        ratio = power.duty.ratio if isinstance(curve, Reduced) else 1.0
        found |= {
            "r": Given(base.drop, "", tr("part of the voltage lost in the circuit at the rated current")),
            "beta": Given(base.bend, "", tr("coefficient of saturation")),
            "kappa": Given(base.rate * ratio, "s/rad", tr("rate at which the EMF grows with the angular velocity")),
        }
    return found


def _lag(motor: Motor) -> Iterator[Block]:
    """The electromagnetic lag, by its formula where that is what was taken."""
    yield Paragraph(tr("The moment follows the characteristic with the electromagnetic lag of the motor:"))
    tau = Given(motor.time_constant, "s", tr("electromagnetic time constant"))
    if motor.synchronous is not None and motor.overload is not None:
        slip = Given(motor.critical_slip, "", tr("critical slip"))
        if math.isclose(motor.time_constant, 1 / (2 * math.pi * FREQUENCY * motor.critical_slip), rel_tol=1e-12):
            known = {"tau_e": tau, "f_c": Given(FREQUENCY, "Hz", tr("frequency of the mains")), "s_K": slip}
            yield from lines(("tau_e = 1/(2*pi*f_c*s_K)",), [Place("", named(known))])
    yield Display(read("tau_e*M'_d = M_s - M_d"))
    yield Paragraph(tr("where $M'_d$ is the rate of the moment, $M_s$ the moment by the characteristic."))


def of_braking(motor: Motor, how: Braking) -> Iterator[Block]:
    """The characteristic of a motor that brakes, on its own shaft."""
    curve = braking(motor, how)
    lexicon = {
        "U": Given(motor.voltage or 0.0, "V", tr("voltage of the motor")),
        "R_M": Given(motor.resistance or 0.0, "Ohm", tr("resistance of the armature circuit")),
        "R_a": Given(how.resistance, "Ohm", tr("resistance added to the armature circuit")),
    }
    if isinstance(curve, Straight):
        yield from _straight(motor, how, curve, lexicon)
        return
    assert isinstance(curve, Series)
    own = characteristic(motor, "series")
    assert isinstance(own, Series)
    plugged = how.kind == "plugging"
    yield Paragraph(
        tr("The armature is turned round against the field, so that its EMF and the mains drive the current:")
        if plugged
        else tr("The armature is turned round against the field and closed on a resistor; the motor excites itself:")
    )
    least = critical_speed(curve)
    assert least is not None
    lexicon |= {
        "r": Given(own.drop, "", tr("part of the voltage lost in the circuit at the rated current")),
        "kappa": Given(curve.rate, "s/rad", tr("rate at which the EMF grows with the angular velocity of the motor")),
        "r_a": Given(curve.drop, "", tr("the same with the added resistance")),
        "omega_e": Given(least, "rad/s", tr("angular velocity of the motor above which it excites itself")),
    }
    texts = ("r_a = r*(1 + R_a/R_M)", *(() if plugged else ("omega_e = r_a/kappa",)))
    yield from lines(texts, [Place("", named(lexicon))])
    given = "1 + beta*j" if plugged else "0"
    yield Display(read(f"r_a*j*(1 + beta*j) - kappa*omega*j = {given}"))
    yield Display(read("M_d = -M_N*(1 + beta)*j**2/(1 + beta*j)"))


def _straight(motor: Motor, how: Braking, curve: Straight, lexicon: Lexicon) -> Iterator[Block]:
    """A field that does not hang on the current of the armature: a straight line."""
    yield Paragraph({
        "regenerative": tr("The motor feeds the source: its armature stays connected to the voltage $V$."),
        "dynamic": tr("The armature is closed on a resistor, $V = 0$."),
        "plugging": tr("The armature is turned round, $V = -U$."),
    }[how.kind])  # fmt: skip
    constant, resistance = independent(motor, how)
    texts = ["omega_V = V/k_M", "b_V = k_M**2/(R_M + R_a)"]
    if motor.kind == "series":
        yield from _field_apart(motor, how, lexicon)
        texts.insert(0, "k_M = U*kappa*j_f/(1 + beta*j_f)")
    own = motor.voltage or 0.0
    voltage = {"regenerative": how.voltage or own, "dynamic": 0.0, "plugging": -own}
    lexicon |= {
        "k_M": Given(constant, "V*s/rad", tr("constant of the motor")),
        "R_M": Given(resistance, "Ohm", tr("resistance of the armature circuit")),
        "V": Given(voltage[how.kind], "V", tr("voltage that the armature is connected to")),
        "omega_V": Given(curve.synchronous, "rad/s", tr("angular velocity of the motor at which its moment is zero")),
        "b_V": Given(curve.stiffness, "N*m*s/rad", tr("stiffness of the characteristic")),
    }
    yield from lines(texts, [Place("", named(lexicon))])
    yield Display(read("M_d = b_V*(omega_V - omega)" if curve.synchronous else "M_d = -b_V*omega"))


def _field_apart(motor: Motor, how: Braking, lexicon: Lexicon) -> Iterator[Block]:
    """The field of a series motor on a source of its own."""
    assert how.field is not None
    own = characteristic(motor, "series")
    assert isinstance(own, Series)
    yield Paragraph(tr("The field is fed from a source of its own."))
    lexicon |= {
        "j_f": Given(how.field, "", tr("current of the field in parts of the rated one")),
        "beta": Given(own.bend, "", tr("coefficient of saturation")),
        "kappa": Given(own.rate, "s/rad", tr("rate at which the EMF grows with the angular velocity of the motor")),
    }
