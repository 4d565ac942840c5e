"""Works of driving and resisting forces, efficiency, mean moment and power; the motor, why it is taken, its constants.

The characteristic of the motor stands in the chapter on motion.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

from tmmcalc.machine.driveline import DriveLine
from tmmcalc.machine.judged import START, TEXTBOOK, Judged, rules
from tmmcalc.machine.motors.model import RPM, Motor
from tmmcalc.machine.notes.motors import RATED, losses, motor_data
from tmmcalc.machine.notes.reducing import index_of
from tmmcalc.machine.pictures.words import cause_name
from tmmcalc.machine.power import LOSSES, MotorDuty, Power
from tmmcalc.machine.reduction.results import Contribution, Reduction
from tmmcalc.machine.stages.power import inputs
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr, tr_name
from tmmcalc.report.manuscript import Block, Heading, Lexicon, Paragraph, Place, Result, Table
from tmmcalc.report.telling import column, held, lines, named, plainly

WORKING, ENGINE = "eta = A_c/(A_c + A_F)", "eta = (A_d + A_F)/A_d"  # (3.36), (3.37)
DIGITS = 4  # of the table of motors
COLUMNS = {
    "$P_N$, W": "power",
    "$n_N$, rpm": "rated_rpm",
    "$u$": "ratio",
    "$P_m$/$P_N$": "load",
    "$M_{rms}$/$M_N$": "heating",
    "$M_{max}$/$M_K$": "largest",
}
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
    yield from (Result(key, lexicon[key]) for key in ("eta", "P") if lexicon[key].value)
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


def _work(contribution: Contribution) -> str:
    """The work of a cause; that of friction in the linkage has a name beside that of all friction."""
    index = index_of(contribution)
    return f"A_{{{'Fl' if index == 'F' else index}}}"


def _work_texts(reduction: Reduction) -> Iterator[str]:
    """What drives, what resists, what is lost."""
    loads = [each for each in reduction.contributions if each.kind == "load"]
    lost = [each for each in reduction.contributions if each.kind in LOSSES]
    for name, parts in (
        ("A_d", [each for each in loads if each.work > 0]),
        ("A_c", [each for each in loads if each.work < 0]),
        ("A_F", lost),
    ):
        if len(parts) > 1 or (parts and name != "A_F"):
            yield f"{name} = {' + '.join(map(_work, parts))}"


def _powers(power: Power, reduction: Reduction, rate: str) -> Lexicon:
    line = power.line
    found = {
        "eta": Given(power.efficiency or 0.0, "", tr("efficiency of the machine")),
        "T": Given(power.cycle_time, "s", tr("time of a cycle")),
        rate: Given(reduction.speed, "rad/s", _rate_words(rate)),
        "P": Given(power.mean_power, "W", tr("mean power over a cycle")),
        "M_{dm}": Given(power.mean_moment, "N*m", tr("mean driving moment on the input link")),
        "eta_u": losses(power),
        "P_m": Given(power.motor_power or 0.0, "W", tr("required power of the motor")),
    }
    for part, mark in zip(line.parts, "ro", strict=False):
        name = tr("reducer") if mark == "r" else tr("open pair")
        found[f"eta_{mark}"] = Given(part.efficiency, "", tr("efficiency ({name})", name=name))
    return found


def _rate_words(rate: str) -> str:
    return tr("angular velocity of link {link}", link=rate.partition("_")[2])


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
        yield "eta_u = eta_r*eta_o"
    if power.motor_power:
        yield f"P_m = P{'/eta_u' if power.line.efficiency < 1 else ''}"


def _motor(power: Power, duty: MotorDuty, order: Order, lexicon: Lexicon, rate: str) -> Iterator[Block]:
    """Its data, the condition of its power, the others that were tried, ratio, moments, the characteristic."""
    wish, _, _, _ = inputs(order.spec)
    assert wish is not None
    motor = duty.motor
    yield Heading(tr("Motor"))
    lexicon |= named(_plate(motor, duty, power, rate))
    yield Paragraph(_taken(order, duty))
    if power.motor_power:
        yield held("P_N >= P_m", (motor.power, power.motor_power), "W", holds=motor.power >= power.motor_power)
        yield Result("P_N", lexicon["P_N"], power.motor_power, ">=")
    yield from _tried(duty, wish.reserve)
    place = [Place("", lexicon)]
    if duty.ratio_of:
        yield Paragraph(tr("The ratio of the drive is that of the gear train {name}.", name=duty.ratio_of))
    losing = {"eta": "*eta_u" if power.line.efficiency < 1 else ""}
    yield from lines([*RATED, *_ratio_texts(power.line, rate)], place, losing)
    peak = ["psi_p = M_{cmax}/M_N"] if power.peak_moment else []
    mean = ["psi_m = M_{dm}/M_N"] if power.mean_moment > 0 and not power.balancing else []
    yield from lines([*mean, *peak], place)
    if peak and motor.overload and duty.peak_load > motor.overload and "flywheel" in order.results:
        yield Paragraph(
            tr(
                "The ratio $psi_p$ is above the overload factor {factor} of the motor; the flywheel takes the excess.",
                factor=plainly(motor.overload),
            )
        )
    yield from lines(["J_{R1} = J_R*u**2"], place)


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


def _plate(motor: Motor, duty: MotorDuty, power: Power, rate: str) -> Lexicon:
    """Its data, and what they come to on both shafts."""
    found = {
        **motor_data(motor, power),
        "omega_N": Given(motor.speed / duty.ratio, "rad/s", tr("rated angular velocity, reduced to the input shaft")),
        "M_N": Given(power.rated_moment or 0.0, "N*m", tr("rated moment, reduced to the input shaft")),
        rate.replace("omega", "n"): Given(abs(power.speed) * RPM, "rpm", tr("speed of the crank")),
        "M_{cmax}": Given(power.peak_moment, "N*m", tr("largest reduced moment of resistance")),
        "psi_m": Given(duty.mean_load, "", tr("mean load of the motor")),
        "psi_p": Given(duty.peak_load, "", tr("peak load of the motor")),
        "J_R": Given(motor.inertia or 0.0, "kg*m^2", tr("moment of inertia of the rotor")),
        "J_{R1}": Given(duty.rotor, "kg*m^2", tr("moment of inertia of the rotor reduced to the input link")),
    }
    for part, mark in zip(power.line.with_ratio(duty.ratio), "ro", strict=False):
        name = tr("reducer") if mark == "r" else tr("open pair")
        found[f"u_{mark}"] = Given(part.ratio or 0.0, "", tr("ratio ({name})", name=name))
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
    found = {tr("Motor"): [each.name for each in shown]}
    for name, key in COLUMNS.items():
        head, cells = column(name, [_known(getattr(each, key)) for each in shown], DIGITS)
        found[head] = cells
    found[tr("Verdict")] = [_verdict(each, each.motor == duty.motor, reserve) for each in shown]
    yield Table(tr("Motors considered"), tuple(found), tuple(zip(*found.values(), strict=True)), "power_motors")
    if duty.taken:
        yield Paragraph(tr("What each rule of choice alone would take is in table {tab:power_rules}."))
        head, powers = column("$P_N$, W", [each.power for each in duty.taken], DIGITS)
        rows = zip(
            (_rule_words(each.rule) for each in duty.taken), (each.motor for each in duty.taken), powers, strict=True
        )
        yield Table(tr("Rules of choice"), (tr("Rule"), tr("Motor"), head), tuple(rows), "power_rules")


def _known(value: float | None) -> float:
    return math.nan if value is None else value


def _verdict(each: Judged, taken: bool, reserve: float) -> str:
    """The rule that a motor does not keep; of one that is not taken though it keeps all, that it suffices too."""
    if taken:
        return tr("taken")
    broken = [rule for rule, keeps in rules(reserve).items() if keeps(each) is False and rule != TEXTBOOK]
    if broken:
        return tr("fails: {rule}", rule=_rule_words(broken[0]))
    unknown = each.heating is None
    return tr("its data are incomplete") if unknown else tr("suffices too")


def _rule_words(rule: str) -> str:
    return tr("a start") if rule == START else tr_name(rule)
