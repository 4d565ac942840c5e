"""The counterweights of a linkage: every scheme with its weights, masses on links, what they leave of what shakes."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import partial

import numpy as np

from tmmcalc.machine.balance.redistribution import Redistribution
from tmmcalc.machine.balance.schemes import RotatingWeight
from tmmcalc.machine.balance.solve import Balancing, Scheme
from tmmcalc.machine.balance.weights import Weight
from tmmcalc.machine.pictures.balance import draw_shaking
from tmmcalc.machine.pictures.words import scheme_name
from tmmcalc.report.formula.digits import Given, significant
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.manuscript import Block, Display, Heading, Lexicon, Paragraph, Place, Result, Table
from tmmcalc.report.numbers import NOISE
from tmmcalc.report.printing import printed_as
from tmmcalc.report.telling import drawn, lines, named, number_of, tabulated, vector

MARKS = {"least squares": "1", "minimax": "m", "lanchester": "L", "lanchester 2": "LL", "given": "z"}
HIGH = 112.0  # of the picture [mm]


def balanced(result: Balancing, link: int) -> Iterator[Block]:
    """Every scheme with its weights, counterweights on links, and what is left."""
    if not result.schemes and result.redistribution is None:
        return
    yield Heading(tr("Balancing of the shaking force"))
    place, told = Place("", _means(result, link)), set[str]()
    yield Result("R_q", place.lexicon["R_q"])
    for scheme in result.schemes:
        name = scheme_name(scheme.name)
        yield Heading(name[0].upper() + name[1:], 3)
        yield from _scheme(result, scheme, place, f"omega_{link}", told)
    if result.redistribution is not None:
        yield from _on_links(result.redistribution)
    yield from _left_table(result)
    draw = partial(draw_shaking, result=result)
    yield drawn(tr("Shaking force before and after balancing"), draw, HIGH, "balance_left")


def _means(result: Balancing, link: int) -> Lexicon:
    """Speed and acceleration of the crank, means and harmonics of the force, what is chosen of the weights."""
    found = result.shaking
    mean = tr("mean projection of the shaking force on the axis of the crank")
    quantities = {
        f"omega_{link}": Given(found.speed, "rad/s", tr("angular velocity of link {link}", link=link)),
        f"eps_{link}": Given(found.acceleration, "rad/s^2", tr("angular acceleration of link {link}", link=link)),
        "R_q": Given(found.size.rms, "N", tr("root mean square of the shaking force over a turn")),
        "X_0": Given(found.mean_along, "N", mean),
        "Y_0": Given(found.mean_across, "N", mean),
    }
    for k in (-1, 2, -2):
        said = tr("projections of the harmonic of the shaking force of order {order}", order=signed(k))
        quantities |= vector(f"C_{{{k},%}}", found.series.coefficient(k), "N", said)
        size = tr("size of the harmonic of the shaking force of order {order}", order=signed(k))
        quantities[f"C_{{{k}}}"] = Given(abs(found.series.coefficient(k)), "N", size)
    if result.radius is not None:
        quantities["r_U"] = Given(result.radius, "m", tr("radius of the weights"))
    if result.mass is not None:
        quantities["m_w"] = Given(result.mass, "kg", tr("mass of each weight"))
    return named(quantities)


def signed(order: int) -> str:
    """A number with a true minus."""
    return str(order).replace("-", "−")


def _scheme(result: Balancing, scheme: Scheme, place: Place, rate: str, told: set[str]) -> Iterator[Block]:
    """What it is for, its weights but those that are ``told``, the root mean square of what is left."""
    balance, mark = scheme.balance, MARKS[scheme.name]
    yield Paragraph(_goal(scheme.name))
    if not scheme.weights:
        yield Paragraph(tr("There is nothing of it to balance."))
        return
    if scheme.name == "given":
        yield _given_table(scheme)
    elif scheme.name == "least squares":
        yield Display(read("X_0 = sum(R_{x1,i}, i)/n"), "balance_mean")
        yield Display(read("Y_0 = sum(R_{y1,i}, i)/n"))
        yield Paragraph(_mean_words(result))
    known = []
    for weight, made in zip(balance.weights, scheme.weights, strict=True):
        if scheme.name == "given" or not weight.moment:
            continue
        index = mark if scheme.name == "minimax" else str(weight.order)
        if index in told:
            known.append(f"$U_{{{index}}}$")
            continue
        told.add(index)
        yield from _weight_lines(result, index, weight, made, place, rate)
    if known:
        yield Paragraph(tr("The other weights are known already: {weights}.", weights=", ".join(known)))
    if scheme.name != "given" and balance.ratio is not None:
        said = tr("root mean square of the shaking force that is left")
        place.lexicon.update(named({f"D_{mark}": Given(balance.after.rms, "N", said)}))
        yield from lines([f"D_{mark} = sqrt({_left_terms(scheme)})"], [place])
        yield Result(f"D_{mark}", place.lexicon[f"D_{mark}"], place=scheme_name(scheme.name))


def _goal(name: str) -> str:
    return {
        "least squares": tr(
            "In the axes of the crank the force of a counterweight on the crank stands still. The mean square of what "
            "is left is least where it is opposite to the mean of the hodograph over the $n$ positions of a turn:"
        ),
        "minimax": tr(
            "The largest force that a counterweight on the crank leaves is least where it moves the centre $O_2$ of "
            "the smallest circle around the hodograph ($X_m$, $Y_m$) into the origin:"
        ),
        "lanchester": tr(
            "Two weights that turn at the speed of the crank, with it and against it, take away both harmonics of the "
            "first order:"
        ),
        "lanchester 2": tr(
            "Two pairs of weights that turn at the speed of the crank and twice as fast, with it and against it, take "
            "away the harmonics of the first and the second order:"
        ),
        "given": tr("The weights are given:"),
    }[name]


def _mean_words(result: Balancing) -> str:
    """The means over the positions."""
    unit, factor = printed_as("N")
    mean = complex(np.mean(result.shaking.turned[:-1]))
    x, y = (part * factor if abs(part) > NOISE * result.shaking.scale else 0.0 for part in (mean.real, mean.imag))
    numbers = {"x": significant(x, 5), "y": significant(y, 5), "unit": tr_unit(unit)}
    return tr(
        "The positions give $X_0 = {x}$ {unit}, $Y_0 = {y}$ {unit}; the means over the whole turn are used.", **numbers
    )


def _weight_lines(
    result: Balancing, index: str, weight: RotatingWeight, made: Weight, place: Place, rate: str
) -> Iterator[Block]:
    """Static moment, direction and mass of a weight, from the part of the force that it meets."""
    k, lexicon, eps = weight.order, place.lexicon, rate.replace("omega", "eps")
    x, y = ("X_0", "Y_0") if k == 1 else (f"C_{{{k},x}}", f"C_{{{k},y}}")
    if index == MARKS["minimax"]:
        x, y = f"X_{index}", f"Y_{index}"
        centre = -weight.amplitude(result.shaking.speed, result.shaking.acceleration)
        said = tr("coordinate of the centre of the smallest circle")
        lexicon |= named({x: Given(centre.real, "N", said), y: Given(centre.imag, "N", said)})
    words = {"order": signed(k)}
    lexicon |= named(
        {
            f"U_{{{index}}}": Given(weight.size, "kg*m", tr("static moment of the weight of order {order}", **words)),
            f"psi_{{{index}}}": Given(math.degrees(made.angle), "deg", _angle_words(k)),
            f"m_{{w,{index}}}": Given(made.mass, "kg", tr("mass of this weight")),
            f"r_{{w,{index}}}": Given(made.radius, "m", tr("radius of this weight")),
        }
    )
    straight = abs(number_of(lexicon, y)) <= NOISE * result.shaking.scale
    size = f"abs({x})" if straight else f"sqrt({x}**2 + {y}**2)"
    square, turn = f"{rate}**2" if abs(k) == 1 else f"({abs(k)}*{rate})**2", ""
    if result.shaking.acceleration:
        turn = f" + atan2({'-' if k < 0 else ''}{eps}, {abs(k)}*{rate}**2)"
        square = f"sqrt({square}**2 + ({abs(k)}*{eps})**2)"
    made_of = f"m_{{w,{index}}} = U_{{{index}}}/r_U"
    if result.radius is None:
        made_of = f"r_{{w,{index}}} = U_{{{index}}}/m_w"
    yield from lines([f"U_{{{index}}} = {size}/{square}"], [place])
    if straight and not turn:
        yield Paragraph(_side_words(k, opposite=number_of(lexicon, x) > 0))
    else:
        yield from lines([f"psi_{{{index}}} = atan2(-{y}, -{x}){turn}"], [place])
    yield from lines([made_of], [place])


def _side_words(order: int, *, opposite: bool) -> str:
    """Where a weight stands that lies on the line of the crank."""
    if order == 1:
        return (
            tr("The weight is opposite to the crank pin.")
            if opposite
            else tr("The weight is on the side of the crank pin.")
        )
    if opposite:
        return tr("When the crank lies along the $x$ axis, the weight is opposite to it.")
    return tr("When the crank lies along the $x$ axis, the weight is on the same side.")


def _angle_words(order: int) -> str:
    if order == 1:
        return tr("angle of the weight from the crank")
    return tr("angle of the weight from the $x$ axis where the crank lies along it")


def _left_terms(scheme: Scheme) -> str:
    """The mean square that a scheme leaves."""
    if scheme.name == "minimax":
        return "R_q**2 - X_0**2 - Y_0**2 + (X_m - X_0)**2 + (Y_m - Y_0)**2"
    taken = ["X_0**2 - Y_0**2", *(f"C_{{{w.order}}}**2" for w in scheme.balance.weights if w.order != 1)]
    return " - ".join(("R_q**2", *taken))


def _given_table(scheme: Scheme) -> Table:
    """Weights of the user's own."""
    weights = scheme.balance.weights
    columns = {
        "$U$, kg*m": [weight.size for weight in weights],
        "$psi$, deg": [math.degrees(made.angle) for made in scheme.weights],
        "$x$, m": [weight.axis.real for weight in weights],
        "$y$, m": [weight.axis.imag for weight in weights],
    }
    labels = [signed(weight.order) for weight in weights]
    return tabulated(tr("Given weights"), columns, labels, head=tr("Order"), key="balance_given")


def _on_links(found: Redistribution) -> Iterator[Block]:
    """Counterweights on links, and whether they keep the centre of mass at rest."""
    name = tr("counterweights")
    yield Heading(name[0].upper() + name[1:], 3)
    yield Paragraph(
        tr(
            "Counterweights on links that keep the common centre of mass of all links at rest take the shaking force "
            "away. Their places are in table {tab:balance_links}, in the axes of the links."
        )
    )
    bodies = found.counterweights
    columns = {
        "$m$, kg": [body.mass for body in bodies],
        "$x$, m": [body.center.real for body in bodies],
        "$y$, m": [body.center.imag for body in bodies],
    }
    labels = [str(body.link) for body in bodies]
    yield tabulated(tr("Counterweights on links"), columns, labels, head=tr("Link"), key="balance_links")
    if found.exact:
        yield Paragraph(tr("The common centre of mass stays at rest: the shaking force is balanced."))
    else:
        yield Paragraph(tr("On these links they cannot keep it at rest: a part of the shaking force is left."))


def _left_table(result: Balancing) -> Iterator[Block]:
    """What every scheme leaves of force and moment, in N and in per cent."""
    found, noise = result.shaking, NOISE * result.shaking.scale
    rows = [(tr("as it is"), found.size, found.moment_size)]
    rows += [(scheme_name(each.name), each.balance.after, each.balance.moment_after) for each in result.schemes]
    if result.redistribution is not None:
        after = result.redistribution.after
        rows.append((tr("counterweights"), after.size, after.moment_size))
    rms = np.array([size.rms * (size.largest > noise) for _, size, _ in rows])
    most = np.array([size.largest * (size.largest > noise) for _, size, _ in rows])
    columns = {
        "$D_q$, N": rms,
        "$D_q$/$R_q$, %": 100 * rms / (rms[0] or 1.0),
        "$D_{max}$, N": most,
        "$D_{max}$/$R_{max}$, %": 100 * most / (most[0] or 1.0),
        "$M_q$, N*m": [size.rms * (size.largest > noise) for *_, size in rows],
    }
    yield Paragraph(
        tr(
            "Table {tab:balance_left} has root mean squares ($q$) and largest values of the force that is left and of "
            "the moment about the same point, figure {fig:balance_left} their course."
        )
    )
    labels = [name for name, *_ in rows]
    yield tabulated(tr("Shaking force that is left"), columns, labels, head=tr("Balancing"), key="balance_left")
