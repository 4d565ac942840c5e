"""Fall of a ball: what drives it, its speed by Bessel functions, its largest speed, its stop, its way.

Behind a stop the ball is driven upwards: the same functions with constants of their own.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from functools import partial

import numpy as np

from tmmcalc.extras.ballspeed import Fall, constants, drag_ratio, kinds, parts_of_speed
from tmmcalc.extras.falling_ball import Ball, BallTask, Moment, acceleration, fall_of, rise_of
from tmmcalc.extras.notes.told import course, given
from tmmcalc.extras.pictures.falling_ball import draw_ball
from tmmcalc.extras.tables.tasks.falling_ball import to_ball
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.manuscript import Block, Datum, Display, Heading, Lexicon, Paragraph, Place, Result
from tmmcalc.report.telling import data_of, drawn, lines, named, plainly

PLAIN = 300.0  # argument up to which Bessel functions are told as they are; of larger ones over their exponentials
FADED = "*exp(-2*(eta - <b>))"
ARGUMENT = "eta_0 = 2*sqrt(alpha*<g>/r_0)/lambda"
CONSTANTS = {  # whether the ball is driven on, or braked
    True: (
        "C = 2*<g>*K_<n>^{*} + lambda*v_0*eta_0*K_<m>^{*}",
        "D = 2*<g>*I_<n>^{*} - lambda*v_0*eta_0*I_<m>^{*}",
    ),
    False: (
        "C = lambda*v_0*eta_0*Y_<m>^{*} - 2*<g>*Y_<n>^{*}",
        "D = 2*<g>*J_<n>^{*} - lambda*v_0*eta_0*J_<m>^{*}",
    ),
}
PARTS = {
    True: ("X = C*I_<n> - D*K_<n><q>", "Z = C*I_<m> + D*K_<m><q>"),
    False: ("X = C*J_<n> + D*Y_<n>", "Z = C*J_<m> + D*Y_<m>"),
}
SPEED = "v = 2*<g>*X/(lambda*eta*Z)"
FREE = ("k = alpha*v_0/(lambda*r_0)", "v = v_0/(1 + k*(exp(lambda*t) - 1))")
WAY = "S = r_0*k/(alpha*(k - 1))*ln(1 + (k - 1)*(1 - exp(-lambda*t)))"
EVEN_WAY = "S = r_0/alpha*(1 - exp(-lambda*t))"
WHOLE, EVEN_WHOLE = "S_m = r_0*k/(alpha*(k - 1))*ln(k)", "S_m = r_0/alpha"
FIGURE = 120.0  # height [mm]


def blocks(order: Order) -> Iterator[Block]:
    """What drives the ball, its speed, where it is fastest and stops, its way, the course of the fall."""
    result: Ball = order.results["falling_ball"]
    task = to_ball(order.spec)
    fall = fall_of(task)
    known = _known(task)
    lexicon = named(known | _quantities(result, fall))
    yield Heading(tr("Fall of a ball whose radius decreases"))
    yield from given(data_of(known), "ball")
    yield Heading(tr("Equation of motion"), 3)
    yield from _equation(task, fall, Place("", lexicon))
    if not fall.drive and not fall.initial:
        yield Paragraph(tr("Nothing moves the ball: it stays where it is."))
        return
    middle = len(result.t) // 2
    shown = result.asked or (Moment(*(float(each[middle]) for each in (result.t, result.v, result.way))),)
    stop = math.inf if result.stop is None else result.stop.t
    yield Heading(tr("Speed of the ball"), 3)
    if not fall.drive:
        yield from _without_drive(task, fall, shown, lexicon)
    else:
        yield from _falling(task, fall, [each for each in shown if each.t <= stop], lexicon)
    if result.fastest is not None:
        yield from _fastest(result.fastest, task, lexicon)
    if result.stop is not None:
        yield from _stop(result, result.stop, task, fall, lexicon)
        yield from _risen(task, fall, [each for each in shown if each.t > stop], lexicon, stop)
    yield Heading(tr("Course of the fall"), 3)
    yield from _way(result, fall, lexicon)
    yield from _course(result)


def data(order: Order) -> Iterator[Block]:
    """The ball, what moves it, the times that are asked for."""
    task = to_ball(order.spec)
    yield Paragraph(
        tr(
            "A ball falls, its radius decreases as $r = r_0*exp(-lambda*t)$. The drag decelerates it by "
            "$alpha*v**2/r$. The mass that separates accelerates or decelerates it by $3*lambda*V$. The speed $v$ "
            "is positive downwards, so is the way $S$ from the beginning."
        )
        if task.relative != 0
        else tr(
            "A ball falls, its radius decreases as $r = r_0*exp(-lambda*t)$. The drag decelerates it by "
            "$alpha*v**2/r$. The speed $v$ is positive downwards, so is the way $S$ from the beginning."
        )
    )
    yield from data_of(_known(task))
    if task.relative is None:
        said = tr("relative speed of the mass that separates")
        yield Datum(said, ("V",), text=tr("that of the ball, $V = v$"))
    if task.relative != 0:
        said = tr("reaction of the mass that separates")
        yield Datum(said, text=tr("it accelerates the fall") if task.sign > 0 else tr("it brakes the fall"))
    if task.times:
        yield Datum(tr("times at which speed and way are sought"), ("t",), task.times, "s")
    if task.duration is not None:
        yield Datum(tr("time up to which the motion is sought"), ("t_e",), (task.duration,), "s")


def _word(task: BallTask) -> str:
    """The driving acceleration in formulas: where the reaction has no part in it that of free fall itself."""
    return "g_1" if task.relative else "g"


def _sign(task: BallTask) -> str:
    return "+" if task.sign > 0 else "-"


def _known(task: BallTask) -> Lexicon:
    found = {
        "r_0": Given(task.radius, "m", tr("radius at the beginning")),
        "alpha": Given(task.drag, "", tr("coefficient of drag")),
        "lambda": Given(task.decay, "1/s", tr("decay of the radius")),
        "g": Given(task.gravity, "m/s^2", tr("free-fall acceleration")),
        "v_0": Given(task.initial, "m/s", tr("speed at the beginning")),
    }
    if task.relative:
        found["V"] = Given(task.relative, "m/s", tr("relative speed of the mass that separates"))
    return found


def _quantities(result: Ball, fall: Fall) -> Lexicon:
    return {
        "g_1": Given(result.drive, "m/s^2", tr("driving acceleration")),
        "eta_0": Given(result.argument, "", tr("argument of the Bessel functions at the beginning")),
        "k": Given(drag_ratio(fall), "", tr("ratio of the drag at the beginning")),
    }


def _equation(task: BallTask, fall: Fall, place: Place) -> Iterator[Block]:
    """The equation of the case, and the driving acceleration."""
    yield Paragraph(
        tr(
            "The radius decreases as $r = r_0*exp(-lambda*t)$. Weight, drag and the reaction of the mass that "
            "separates move the ball; the speed is positive downwards:"
        )
    )
    if task.relative is None:
        yield Display(read(f"v' = g - alpha/r*v**2 {_sign(task)} 3*lambda*v"))
        yield Paragraph(
            tr("The mass that separates has no speed of its own; its reaction accelerates the ball.")
            if task.sign > 0
            else tr("The mass that separates has no speed of its own; its reaction brakes the ball.")
        )
        return
    yield Display(read(f"v' = {_word(task)} - alpha/r*v**2"))
    if task.relative:
        yield Paragraph(
            tr("The reaction of the mass that separates at a constant relative speed accelerates the ball:")
            if task.sign > 0
            else tr("The reaction of the mass that separates at a constant relative speed brakes the ball:")
        )
        if fall.drive:
            yield from lines([f"g_1 = g {_sign(task)} 3*lambda*V"], [place])
        else:
            yield Paragraph(tr("It balances the weight, $g_1 = g - 3*lambda*V = 0$, so that drag alone acts."))


def _at(task: BallTask, moment: Moment, lexicon: Lexicon) -> Place:
    """An instant with radius, speed and acceleration."""
    at, v = np.array([moment.t]), np.array([moment.v])
    found = {
        "t": Given(moment.t, "s", tr("time")),
        "r": Given(task.radius * math.exp(-task.decay * moment.t), "m", tr("radius at this time")),
        "v": Given(moment.v, "m/s", tr("speed downwards")),
        "v'": Given(float(acceleration(task, at, v)[0]), "m/s^2", tr("acceleration downwards")),
        "S": Given(moment.way, "m", tr("way from the beginning, downwards")),
    }
    return Place(tr("at t = {time}", time=f"{plainly(moment.t)} {tr_unit('s')}"), lexicon | named(found))


def _without_drive(task: BallTask, fall: Fall, shown: Sequence[Moment], lexicon: Lexicon) -> Iterator[Block]:
    """Speed and way of a ball on which nothing but drag acts."""
    places = [_at(task, each, lexicon) for each in shown]
    yield Paragraph(tr("Without a driving acceleration speed and way have simple closed forms:"))
    yield from lines([FREE[0]], [Place("", lexicon)])
    yield from lines([FREE[1], WAY if drag_ratio(fall) != 1 else EVEN_WAY, *_slope(task)], places)


def _slope(task: BallTask, drag: str = "-") -> tuple[str, ...]:
    """Radius and acceleration; behind a stop the drag acts downwards."""
    own = f" {_sign(task)} 3*lambda*v" if task.relative is None else ""
    return "r = r_0*exp(-lambda*t)", f"v' = {_word(task)} {drag} alpha/r*v**2{own}"


def _falling(task: BallTask, fall: Fall, before: Sequence[Moment], lexicon: Lexicon) -> Iterator[Block]:
    """The speed from the beginning on, up to a stop."""
    n, m = fall.orders
    yield Paragraph(
        tr("The speed follows from modified Bessel functions $I$, $K$ of the orders {n} and {m}.", n=n, m=m)
        if fall.drive > 0
        else tr("The speed follows from Bessel functions $J$, $Y$ of the orders {n} and {m}.", n=n, m=m)
    )
    yield Paragraph(tr("Their argument at the beginning, and the constants by which the speed begins with $v_0$:"))
    yield from _driven(task, fall, before, lexicon)


def _driven(
    task: BallTask, fall: Fall, moments: Sequence[Moment], lexicon: Lexicon, begun: float = 0.0
) -> Iterator[Block]:
    """The speed by Bessel functions: up to a stop, or behind it upwards, from the time ``begun`` on."""
    (n, m), driven, rises = fall.orders, fall.drive > 0, begun > 0 or fall_of(task).drive < 0 < fall.drive
    latest = max([each.t for each in moments], default=begun)
    large = driven and float(fall.argument(np.array([latest - begun]))[0]) > PLAIN
    if large:
        yield Paragraph(tr("The functions $I$ are taken over $exp(eta)$, the functions $K$ times $exp(eta)$."))
    size = _word(task) if driven and not rises else f"abs({_word(task)})"
    words = {"q": FADED if large else "", "g": size, "n": str(n), "m": str(m), "b": "eta_s" if rises else "eta_0"}
    known = lexicon | named({**_constants(fall, large=large), **_functions(fall, 0.0, "^{*}", large=large)})
    if rises:
        known |= {"v_0": Given(0.0), "eta_s": Given(float(fall.argument(np.zeros(1))[0]), "", _at_stop())}
    yield from lines([*([] if rises else [ARGUMENT]), *CONSTANTS[driven]], [Place("", known)], words)
    places = []
    for moment in moments:
        place = _at(task, moment, known)
        place.lexicon.update(named(_functions(fall, moment.t - begun, "", large=large)))
        above, below = parts_of_speed(fall, moment.t - begun, scaled=large)
        place.lexicon["X"] = Given(above, "", tr("numerator of the speed"))
        place.lexicon["Z"] = Given(below, "", tr("denominator of the speed"))
        places.append(place)
    if places:
        yield Paragraph(tr("Argument, speed, radius and acceleration:"))
        speed = SPEED.replace("v = ", "v = -") if rises else SPEED
        yield from lines(
            ["eta = eta_0*exp(lambda*t/2)", *PARTS[driven], speed, *_slope(task, "+" if rises else "-")], places, words
        )


def _at_stop() -> str:
    return tr("argument of the Bessel functions at the stop")


def _constants(fall: Fall, *, large: bool) -> Lexicon:
    """C and D as they stand beside functions that are plain or over their exponentials."""
    c, d = (float(each[0]) for each in constants(fall))
    size = 0.0 if large or fall.drive < 0 else float(fall.argument(np.zeros(1))[0])
    said = tr("constant of the speed")
    return {"C": Given(c * math.exp(-size), "m/s^2", said), "D": Given(d * math.exp(size), "m/s^2", said)}


def _functions(fall: Fall, t: float, mark: str, *, large: bool) -> Lexicon:
    """The Bessel functions at a time; those of the beginning have a mark."""
    eta = fall.argument(np.array([t]))
    size = 0.0 if large or fall.drive < 0 else float(eta[0])
    found = {} if mark else {"eta": Given(float(eta[0]), "", tr("argument of the Bessel functions"))}
    letters = ("I", "K") if fall.drive > 0 else ("J", "Y")
    for letter, kind, power in zip(letters, kinds(fall), (size, -size), strict=True):
        for order in fall.orders:
            value = float(kind(order, eta)[0]) * math.exp(power)
            said = tr("Bessel function of this argument") if not mark else tr("Bessel function at the beginning")
            found[f"{letter}_{order}{mark}"] = Given(value, "", said)
    return found


def _fastest(at: Moment, task: BallTask, lexicon: Lexicon) -> Iterator[Block]:
    """Where the acceleration is nothing."""
    yield Heading(tr("Largest speed of the ball"), 3)
    yield Paragraph(
        tr(
            "The speed is largest where $v' = 0$, at $t$ = {time} s, which is found numerically. There it is given "
            "by the radius alone:",
            time=plainly(at.t),
        )
    )
    place = _at(task, at, lexicon)
    place.lexicon["v"] = Given(at.v, "m/s", tr("largest speed"))
    own = f"v = r*(sqrt(9*lambda**2 + 4*alpha*g/r) {_sign(task)} 3*lambda)/(2*alpha)"
    text = own if task.relative is None else f"v = sqrt({_word(task)}*r/alpha)"
    yield from lines(["r = r_0*exp(-lambda*t)", text], [place])
    yield Result("v_{max}", place.lexicon["v"])


def _stop(result: Ball, stop: Moment, task: BallTask, fall: Fall, lexicon: Lexicon) -> Iterator[Block]:
    """When the ball stops, and how far it has fallen."""
    if not stop.t:
        yield Paragraph(tr("The reaction is above the weight, so the ball rises from the beginning."))
        return
    yield Heading(tr("Stop of the ball"), 3)
    yield Paragraph(
        tr("The ball stops where the numerator of the speed is nothing; the argument $eta_s$ is found numerically:")
    )
    found = {
        **_constants(fall, large=False),
        **_functions(fall, stop.t, "", large=False),
        "eta_s": Given(result.stop_argument or 0.0, "", _at_stop()),
        "t_s": Given(stop.t, "s", tr("time of the stop")),
        "S_s": Given(stop.way, "m", tr("way to the stop")),
    }
    place = Place("", lexicon | named(found))
    yield from lines(["-Y_0/J_0 = C/D", "t_s = 2/lambda*ln(eta_s/eta_0)"], [place])
    yield Paragraph(tr("Until then it has fallen by {way} m.", way=plainly(stop.way)))
    yield Result("t_s", place.lexicon["t_s"])
    yield Result("S_s", place.lexicon["S_s"])


def _risen(task: BallTask, fall: Fall, after: Sequence[Moment], lexicon: Lexicon, stop: float) -> Iterator[Block]:
    """The speed upwards, behind the stop."""
    if after:
        yield Paragraph(
            tr(
                "Behind the stop the ball is driven upwards, with modified Bessel functions $I$, $K$; marked ones are "
                "those at the stop:"
            )
        )
        yield from _driven(task, rise_of(fall, stop), after, lexicon, stop)


def _way(result: Ball, fall: Fall, lexicon: Lexicon) -> Iterator[Block]:
    """The way, and the way that the ball never exceeds."""
    yield Paragraph(tr("The way is the integral of the speed over the time, which is worked out numerically."))
    if result.total is None:
        return
    whole = named({"S_m": Given(result.total, "m", tr("way that the ball never exceeds"))})
    if not fall.drive:
        yield Paragraph(tr("The ball never exceeds this way:"))
        text = WHOLE if drag_ratio(fall) != 1 else EVEN_WHOLE
        yield from lines([text], [Place("", lexicon | whole)])
    else:
        yield Paragraph(tr("Until nothing of it is left the ball falls by {way} m.", way=plainly(result.total)))
    yield Result("S_m", whole["S_m"])


def _course(result: Ball) -> Iterator[Block]:
    """The table and the diagram."""
    yield Paragraph(tr("The fall over the time is in table {tab:ball_course} and in figure {fig:ball}."))
    columns = {
        "$t$, s": result.t,
        "$r$, m": result.radius,
        "$v$, m/s": result.v,
        "$v'$, m/s^2": result.a,
        "$S$, m": result.way,
    }
    yield drawn(tr("Speed and way of the ball"), partial(draw_ball, result=result), FIGURE, "ball")
    yield course(tr("Fall of the ball over the time"), columns, "ball_course")
