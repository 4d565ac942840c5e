"""Works of driving and resisting forces, efficiency, mean moment and power; the motor, why it is taken, its constants.

Constants of a motor are those on its own shaft, speeds in formulas positive along the motion.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from tmmcalc.machine.driveline import DriveLine
from tmmcalc.machine.judged import TEXTBOOK, Judged, rules
from tmmcalc.machine.motors.model import Motor, characteristic
from tmmcalc.machine.notes.reducing import index_of
from tmmcalc.machine.pictures.words import cause_name
from tmmcalc.machine.power import LOSSES, MotorDuty, Power
from tmmcalc.machine.reduction.results import Reduction
from tmmcalc.machine.stages.power import inputs
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.digits import Given, significant
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.language import tr, tr_name
from tmmcalc.report.manuscript import Block, Display, Heading, Lexicon, Paragraph, Place, Table
from tmmcalc.report.telling import column_of, headed, lines, named

RPM = 30 / math.pi
WORKING, ENGINE = "eta = A_c/(A_c + A_F)", "eta = (A_d + A_F)/A_d"  # (3.36), (3.37)
RATED = ("omega_N = pi*n_N/30", "M_N = P_N/omega_N")
FORMS = {  # of a characteristic: lines of its constants, and itself
    "parabolic": (
        ("omega_c = pi*n_c/30", "A_m = M_N*omega_c**2/(omega_c**2 - omega_N**2)", "B_m = M_N/(omega_c**2 - omega_N**2)"),
        "M_m = A_m - B_m*omega_m**2",
    ),
    "linear": (("omega_c = pi*n_c/30", "b_m = M_N/(omega_c - omega_N)"), "M_m = b_m*(omega_c - omega_m)"),
    "kloss": (
        ("omega_c = pi*n_c/30", "s_N = 1 - omega_N/omega_c", "s_K = s_N*(K + sqrt(K**2 - 1))", "M_K = K*M_N"),
        "M_m = 2*M_K*s*s_K/(s**2 + s_K**2)",
    ),
    "shunt": (("omega_c = U/k_m", "b_m = k_m**2/R_m"), "M_m = b_m*(omega_c - omega_m)"),
}
DIGITS = 4  # of the table of motors
NEAR = 0.01  # synchronous speeds that differ less are one


def blocks(order: Order) -> Iterator[Block]:
    """Works, efficiency and power; then the motor, where there is one."""
    power, reduction = order.results["power"], order.results["reduction"]
    yield Heading(tr("Efficiency and power"))
    if power.machine == "idle":
        yield Paragraph(tr("No given force does work over a cycle."))
        return
    kinematics = order.results.get("kinematics")
    rate = f"omega_{1 if kinematics is None else kinematics.structure.input_link}"
    lexicon = named({**_works(power, reduction), **_powers(power, reduction, rate)})
    yield from lines([*_work_texts(reduction), *_power_texts(power, reduction, rate)], [Place("", lexicon)])
    if power.duty is not None:
        yield from _motor(power, power.duty, order, lexicon, rate)


def _works(power: Power, reduction: Reduction) -> Lexicon:
    return {
        **{
            _work(each): Given(each.work, "J", tr("work ({cause})", cause=cause_name(each.name)))
            for each in reduction.contributions
        },
        "A_d": Given(power.driving, "J", tr("work of the driving forces over a cycle")),
        "A_c": Given(power.resisting, "J", tr("work of the resisting forces over a cycle")),
        "A_F": Given(power.losses, "J", tr("work of friction over a cycle")),
    }


def _work(contribution: Any) -> str:
    return f"A_{{{index_of(contribution)}}}"


def _work_texts(reduction: Reduction) -> Iterator[str]:
    """What drives, what resists, what is lost."""
    loads = [each for each in reduction.contributions if each.kind == "load"]
    lost = [each for each in reduction.contributions if each.kind in LOSSES]
    for name, parts in (
        ("A_d", [each for each in loads if each.work > 0]),
        ("A_c", [each for each in loads if each.work < 0]),
        ("A_F", lost),
    ):
        if parts and [_work(each) for each in parts] != [name]:
            yield f"{name} = {' + '.join(map(_work, parts))}"


def _powers(power: Power, reduction: Reduction, rate: str) -> Lexicon:
    line = power.line
    found = {
        "eta": Given(power.efficiency or 0.0, "", tr("efficiency of the machine")),
        "T": Given(power.cycle_time, "s", tr("time of a cycle")),
        rate: Given(reduction.speed, "rad/s", tr("angular velocity of the input link")),
        "P": Given(power.mean_power, "W", tr("mean power over a cycle")),
        "M_{dm}": Given(power.mean_moment, "N*m", tr("mean driving moment on the input link")),
        "eta_g": Given(line.efficiency, "", tr("efficiency of the gears")),
        "P_m": Given(power.motor_power or 0.0, "W", tr("required power of the motor")),
    }
    for part, mark in zip(line.parts, "ro", strict=False):
        name = tr("reducer") if mark == "r" else tr("open pair")
        found[f"eta_{mark}"] = Given(part.efficiency, "", tr("efficiency ({name})", name=name))
    return found


def _power_texts(power: Power, reduction: Reduction, rate: str) -> Iterator[str]:
    """Efficiency by (3.36) or (3.37), the time of a cycle, mean power and moment, what is required of a motor."""
    turns = round(reduction.cycle.period / (2 * math.pi))
    angle = f"{2 * turns}*pi"
    given = power.mean_moment < 0  # the loads leave work over
    if power.efficiency is not None and power.losses:
        yield ENGINE if given else WORKING
    yield f"T = {angle}/{rate if reduction.speed > 0 else f'abs({rate})'}"
    total = "A_d + A_c + A_F"
    if not power.mean_moment:
        return
    yield f"P = ({total})/T" if given else f"P = -({total})/T"
    yield f"M_{{dm}} = -({total})/({angle})"
    if power.line.parts:
        yield "eta_g = eta_r*eta_o"
    if power.motor_power:
        yield f"P_m = P{'/eta_g' if power.line.efficiency < 1 else ''}"


def _motor(power: Power, duty: MotorDuty, order: Order, lexicon: Lexicon, rate: str) -> Iterator[Block]:
    """Its data, the condition of its power, the others that were tried, ratio, moments, the characteristic."""
    wish, _, _, _ = inputs(order.spec)
    assert wish is not None
    motor = duty.motor
    yield Heading(tr("Motor"))
    lexicon |= named(_plate(motor, duty, power, rate))
    yield Paragraph(_taken(order, duty))
    if power.motor_power:
        yield Paragraph(_condition(motor.power, power.motor_power))
    yield from _tried(duty, wish.reserve)
    place = [Place("", lexicon)]
    if duty.ratio_of:
        yield Paragraph(tr("The ratio of the drive is that of the gear train {name}.", name=duty.ratio_of))
    yield from lines([*RATED, *_ratio_texts(power.line, rate)], place)
    peak = ["psi_p = M_p/M_{N1}"] if power.peak_moment else []
    mean = ["psi_m = M_{dm}/M_{N1}"] if power.mean_moment > 0 and not power.balancing else []
    gears = "*eta_g" if power.line.efficiency < 1 else ""
    yield from lines([f"M_{{N1}} = M_N*u{gears}", *mean, *peak, "J_{R1} = J_R*u**2"], place)
    texts, form = FORMS.get(wish.characteristic, ((), ""))
    if wish.characteristic == "shunt" and motor.constant is None:
        texts, form = FORMS["linear"]
    if form:
        yield Paragraph(tr("Constants of the characteristic of the motor on its shaft:"))
        yield from lines(texts, place)
        yield Paragraph(tr("So its moment at the angular velocity $omega_m$ is"))
        yield Display(read(form), "power_motor")
    if wish.characteristic == "kloss":
        yield Paragraph(tr("where $s = 1 - omega_m/omega_c$ is the slip."))


def _taken(order: Order, duty: MotorDuty) -> str:
    """Which motor it is, and where from."""
    if duty.chosen:
        return tr(
            "The motor {name} is taken from the catalogue: of the motors that keep all conditions it has the least "
            "power.",
            name=duty.motor.name,
        )
    if order.spec.motor.name:
        return tr("The motor {name} of the catalogue is given.", name=duty.motor.name)
    return tr("The motor is given by its data.")


def _condition(rated: float, required: float) -> str:
    """Whether the rated power covers the required one, with both sides."""
    relation = ">=" if rated >= required else "<"
    sides = {"rated": significant(rated, 5), "required": significant(required, 5), "relation": relation}
    if rated >= required:
        return tr("$P_N >= P_m$: ${rated} {relation} {required}$ W. The condition holds.", **sides)
    return tr("$P_N >= P_m$: ${rated} {relation} {required}$ W. The condition fails.", **sides)


def _plate(motor: Motor, duty: MotorDuty, power: Power, rate: str) -> Lexicon:
    """Its data, and what they come to on both shafts."""
    speed = abs(power.speed) * RPM
    found = {
        "P_N": Given(motor.power, "W", tr("rated power of the motor")),
        "n_N": Given(motor.rated_rpm, "rpm", tr("rated speed of the motor")),
        "omega_N": Given(motor.speed, "rad/s", tr("rated angular velocity of the motor")),
        "M_N": Given(motor.nominal_moment, "N*m", tr("rated moment of the motor")),
        rate.replace("omega", "n"): Given(speed, "rpm", tr("speed of the input link")),
        "u": Given(duty.ratio, "", tr("ratio of the drive")),
        "M_{N1}": Given(power.rated_moment or 0.0, "N*m", tr("rated moment reduced to the input link")),
        "M_p": Given(power.peak_moment, "N*m", tr("largest reduced moment of resistance")),
        "psi_m": Given(duty.mean_load, "", tr("mean load of the motor")),
        "psi_p": Given(duty.peak_load, "", tr("peak load of the motor")),
        "J_R": Given(motor.inertia or 0.0, "kg*m^2", tr("moment of inertia of the rotor")),
        "J_{R1}": Given(duty.rotor, "kg*m^2", tr("moment of inertia of the rotor reduced to the input link")),
    }
    for part, mark in zip(power.line.with_ratio(duty.ratio), "ro", strict=False):
        name = tr("reducer") if mark == "r" else tr("open pair")
        found[f"u_{mark}"] = Given(part.ratio or 0.0, "", tr("ratio ({name})", name=name))
    return {**found, **_constants(motor)}


def _constants(motor: Motor) -> Lexicon:
    """Constants of the characteristics that its data allow."""
    found: Lexicon = {}
    if motor.voltage is not None and motor.resistance is not None and motor.constant is not None:
        found["U"] = Given(motor.voltage, "V", tr("voltage"))
        found["R_m"] = Given(motor.resistance, "ohm", tr("resistance of the armature circuit"))
        found["k_m"] = Given(motor.constant, "V*s/rad", tr("constant of the motor"))
        line: Any = characteristic(motor, "shunt")
        found["omega_c"] = Given(line.synchronous, "rad/s", tr("angular velocity without load"))
        found["b_m"] = Given(line.stiffness, "N*m*s/rad", tr("stiffness of the characteristic"))
        return found
    if motor.synchronous is None:
        return found
    found["n_c"] = Given(motor.synchronous * RPM, "rpm", tr("synchronous speed"))
    found["omega_c"] = Given(motor.synchronous, "rad/s", tr("synchronous angular velocity"))
    if motor.kind == "induction":
        parabola: Any = characteristic(motor, "parabolic")
        found["A_m"] = Given(parabola.a, "N*m", tr("constant of the parabola"))
        found["B_m"] = Given(parabola.b, "N*m*s^2/rad^2", tr("constant of the parabola"))
    line = characteristic(motor, "linear")
    found["b_m"] = Given(line.stiffness, "N*m*s/rad", tr("stiffness of the characteristic"))
    if motor.overload is not None and motor.kind == "induction":
        kloss: Any = characteristic(motor, "kloss")
        found["s_N"] = Given(motor.nominal_slip, "", tr("rated slip"))
        found["K"] = Given(motor.overload, "", tr("overload factor"))
        found["s_K"] = Given(motor.critical_slip, "", tr("critical slip"))
        found["M_K"] = Given(kloss.peak, "N*m", tr("largest moment of the motor"))
    return found


def _ratio_texts(line: DriveLine, rate: str) -> list[str]:
    """The ratio by the speeds where it is not given, by the parts where there are two."""
    if line.parts:
        return ["u = u_r*u_o"]
    return [f"u = n_N/{rate.replace('omega', 'n')}"] if line.ratio is None else []


def _tried(duty: MotorDuty, reserve: float) -> Iterator[Block]:
    """The motors of the same synchronous speed from the next smaller power on, and what each rule would take."""
    if not duty.judged:
        return
    weaker = max((each.power for each in duty.judged if each.load > 1), default=0.0)
    own = duty.motor.synchronous
    shown = [
        each
        for each in duty.judged
        if each.power >= weaker
        and (own is None or each.motor.synchronous is None or abs(each.motor.synchronous / own - 1) < NEAR)
    ]
    said = tr(
        "Table {tab:power_motors} has the motors of this synchronous speed that were considered: required power over "
        "the rated one, root mean square moment over the rated one and largest moment over the break-down one in the "
        "steady motion."
    )
    yield Paragraph(said)
    head = (tr("Motor"), "$P_N$, W", "$n_N$, rpm", "$u$", "$P_m/P_N$", "$M_{rms}/M_N$", "$M_{max}/M_K$")
    keys = ("power", "rated_rpm", "ratio", "load", "heating", "largest")
    numbers = [column_of([_known(getattr(each, key)) for each in shown], DIGITS) for key in keys]
    verdicts = [_verdict(each, each.motor == duty.motor, reserve) for each in shown]
    cells = zip([each.name for each in shown], *numbers, verdicts, strict=True)
    yield Table(tr("Motors considered"), (*map(headed, head), tr("Verdict")), tuple(cells), "power_motors")
    if duty.taken:
        yield Paragraph(tr("Each rule of choice alone would take:"))
        rows = tuple((tr_name(each.rule), each.motor, column_of([each.power], DIGITS)[0]) for each in duty.taken)
        yield Table(tr("Rules of choice"), (tr("Rule"), tr("Motor"), headed("$P_N$, W")), rows, "power_rules")


def _known(value: float | None) -> float:
    return math.nan if value is None else value


def _verdict(each: Judged, taken: bool, reserve: float) -> str:
    """The rule that a motor does not keep; of one that is not taken though it keeps all, that it suffices too."""
    if taken:
        return tr("taken")
    broken = [rule for rule, keeps in rules(reserve).items() if keeps(each) is False and rule != TEXTBOOK]
    if broken:
        return tr("fails: {rule}", rule=tr_name(broken[0]))
    unknown = each.heating is None
    return tr("its data are incomplete") if unknown else tr("suffices too")
