"""The shaking force and moment of a linkage at the chosen positions, over the turn, and by harmonics.

Masses of rods stand in their pins, which keeps the shaking force; the shaking moment is that of the links as they are.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from functools import partial

import numpy as np
from numpy.typing import ArrayLike

from tmmcalc.linkage.chain import Chain, chain_of
from tmmcalc.linkage.loading import Body, Loading
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.notes.shown import rows_shown
from tmmcalc.linkage.tables.tasks.loading import to_loading
from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
from tmmcalc.machine.balance.shaking import Shaking, inertia_loads
from tmmcalc.machine.balance.solve import Balancing
from tmmcalc.machine.notes.counterweights import balanced
from tmmcalc.machine.notes.moving import Mass, Moving, masses_of, point_name
from tmmcalc.machine.pictures.balance import draw_hodographs
from tmmcalc.machine.reduction.inertia import lumped, rods_of
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Heading, Paragraph
from tmmcalc.report.numbers import NOISE
from tmmcalc.report.telling import drawn, lines, named, tabulated, vector

ON_LINE = 1e-12  # of a rod: a centre of mass so near to its line lies on it
HIGHEST = 4  # order of harmonics that are told
HODOGRAPHS = 100.0  # height of the picture [mm]


def linkage_blocks(order: Order, result: Balancing) -> Iterator[Block]:
    """Lumped masses, shaking force and moment, the hodograph, the schemes and what they leave."""
    mechanism, loading, found = to_linkage(order.spec.linkage), to_loading(order.spec), result.shaking
    kinematics = order.results["kinematics"]
    chain = chain_of(mechanism, kinematics)
    rows = rows_shown(order, chain, kinematics)
    moving = Moving(mechanism, kinematics, chain.evaluate(kinematics.x[rows]), rows, [{} for _ in rows])
    moving.turning(moving.link)
    bodies = _in_pins(mechanism, loading)
    if divided := _divided(loading, bodies):
        yield Heading(tr("Masses in points"))
        yield from _lumped_lines(moving, divided)
    yield Heading(tr("Shaking force and moment"))
    yield Paragraph(tr("The shaking force is the sum of the inertia forces of all links:"))
    yield from _force_lines(moving, result, bodies)
    yield from _moment_lines(moving, chain, result, loading.heavy)
    yield Paragraph(
        tr(
            "In axes that turn with the crank, $x_1$ along it, the shaking force has other projections; figure "
            "{fig:balance_hodographs} has its hodographs in both axes."
        )
    )
    yield from _crank_lines(moving, result)
    yield from _table(result)
    yield from _harmonics(found)
    hodographs = partial(draw_hodographs, result=result)
    yield drawn(tr("Hodographs of the shaking force"), hodographs, HODOGRAPHS, "balance_hodographs")
    yield from balanced(result, moving.link)


def _in_pins(mechanism: Mechanism, loading: Loading) -> tuple[Body, ...]:
    """The bodies with the rods lumped in their pins whose centres of mass lie between these."""
    rods = [link for link in rods_of(mechanism, loading) if _on_line(mechanism, loading, link)]
    least = ON_LINE * max((body.mass for body in loading.bodies), default=0.0)
    return tuple(body for body in lumped(mechanism, loading, tuple(rods)) if abs(body.mass) > least or body.inertia)


def _divided(loading: Loading, bodies: Sequence[Body]) -> list[tuple[Body, list[Body]]]:
    """The rods whose mass is divided, with its parts; that of one whose centre of mass is in a pin is there whole."""
    parts = {body: [each for each in bodies if each.link == body.link] for body in loading.bodies}
    return [(body, own) for body, own in parts.items() if len(own) > 1]


def _on_line(mechanism: Mechanism, loading: Loading, link: int) -> bool:
    a, b = pins_of(mechanism, link)
    own = [body for body in loading.bodies if body.link == link]
    return all(abs(((body.center - a) / (b - a)).imag) <= ON_LINE for body in own) and len(own) == 1


def pins_of(mechanism: Mechanism, link: int) -> tuple[complex, complex]:
    """The two pins of a rod in its own axes."""
    first, second = (joint for joint in mechanism.joints if link in joint.links)
    return first.points[first.links.index(link)], second.points[second.links.index(link)]


def _lumped_lines(moving: Moving, divided: Sequence[tuple[Body, list[Body]]]) -> Iterator[Block]:
    """The masses of every rod by the lever rule."""
    yield Paragraph(
        tr(
            "The mass of a connecting rod is divided between its pins, so that mass and centre of mass are kept; the "
            "shaking force stays as it is."
        )
    )
    place = moving.places[0]._replace(name="")
    for body, parts in divided:
        link = body.link
        ends, at = pins_of(moving.mechanism, link), [point_name(moving.mechanism, link, each.center) for each in parts]
        centre = point_name(moving.mechanism, link, body.center)
        lengths = {f"{at[0]}{at[1]}": abs(ends[1] - ends[0])}
        for name, end in zip(at, ends, strict=True):
            lengths[f"{name}{centre}"] = abs(body.center - end)
        for name, length in lengths.items():
            said = tr(
                "distance between points {first} and {second}", first=name[: len(at[0])], second=name[len(at[0]) :]
            )
            moving.give(f"l_{{{name}}}", np.asarray(length), "m", said)
        moving.give(f"m_{link}", np.asarray(body.mass), "kg", tr("mass of link {link}", link=link))
        masses_of(moving, parts)
        first, second = at
        yield from lines(
            (
                f"m_{{{link}{first}}} = m_{link}*l_{{{second}{centre}}}/l_{{{first}{second}}}",
                f"m_{{{link}{second}}} = m_{link}*l_{{{first}{centre}}}/l_{{{first}{second}}}",
            ),
            [place],
        )


def _force_lines(moving: Moving, result: Balancing, bodies: Sequence[Body]) -> Iterator[Block]:
    """R = -sum m a, masses in one point together."""
    points: dict[str, list[Mass]] = {}
    for mass in masses_of(moving, [body for body in bodies if body.mass]):
        points.setdefault(mass.centre, []).append(mass)
    terms = []
    for point, masses in points.items():
        total = " + ".join(mass.mass for mass in masses)
        terms.append(f"{f'({total})' if len(masses) > 1 else total}*a_{{{point}%}}")
    whole = tr("shaking force")
    for lexicon, force in zip(moving.lexicons, result.shaking.force[moving.rows], strict=True):
        lexicon |= named(vector("R_%", complex(force), "N", tr("projections of the shaking force")))
        lexicon["R"] = Given(abs(complex(force)), "N", whole)
    sums = [f"R_{axis} = -({' + '.join(terms)})".replace("%", axis) for axis in "xy"]
    yield from lines([*sums, "R = sqrt(R_x**2 + R_y**2)"], moving.places)


def _moment_lines(moving: Moving, chain: Chain, result: Balancing, bodies: Sequence[Body]) -> Iterator[Block]:
    """The moments of all inertia forces and couples about the chosen point, link by link."""
    found, result_of = result.shaking, moving.kinematics
    pole = _pole(moving, found)
    for lexicon in moving.lexicons:
        lexicon |= named(
            {
                f"x_{pole}": Given(found.about.real, "m", tr("coordinates of point {point}", point=pole)),
                f"y_{pole}": Given(found.about.imag, "m", tr("coordinates of point {point}", point=pole)),
            }
        )
    yield Paragraph(
        tr("The shaking moment is the sum of the moments of inertia forces and couples about {point}:", point=pole)
    )
    texts, names = [], []
    for mass in masses_of(moving, bodies):
        link, name, centre = mass.body.link, f"M_{{R{mass.body.link}}}", mass.centre
        _, moment = inertia_loads(
            chain, [mass.body], result_of.x[moving.rows], found.speed, found.acceleration, found.about
        )
        said = tr("moment of inertia force and couple of link {link} about {point}", link=link, point=pole)
        moving.give(name, moment, "N*m", said)
        names.append(name)
        texts.append(
            f"{name} = -m_{link}*((x_{{{centre}}} - x_{pole})*a_{{{centre}y}} - (y_{{{centre}}} - y_{pole})*"
            f"a_{{{centre}x}}) - J_{link}*eps_{link}"
        )
    moving.give("M_R", found.moment[moving.rows], "N*m", tr("shaking moment"))
    yield from lines([*texts, f"M_R = {' + '.join(names)}"], moving.places)


def _pole(moving: Moving, found: Shaking) -> str:
    """The name of the point that moments are about."""
    return point_name(moving.mechanism, 0, found.about, "P")


def _crank_lines(moving: Moving, result: Balancing) -> Iterator[Block]:
    """The force in the axes of the crank."""
    found = result.shaking
    angle = f"phi_{moving.link}" if np.array_equal(found.x, found.phi) else "phi_c"
    whose = tr("angle of link {link}", link=moving.link) if angle != "phi_c" else tr("angle of the line of the crank")
    for lexicon, turned, phi in zip(moving.lexicons, found.turned[moving.rows], found.phi[moving.rows], strict=True):
        said = tr("projections of the shaking force on the axes of the crank")
        lexicon |= named(vector("R_{%1}", complex(turned), "N", said))
        lexicon[angle] = Given(math.degrees(float(phi)), "deg", whose)
    texts = (
        f"R_{{x1}} = R_x*cos({angle}) + R_y*sin({angle})",
        f"R_{{y1}} = R_y*cos({angle}) - R_x*sin({angle})",
    )
    yield from lines(texts, moving.places)


def _table(result: Balancing) -> Iterator[Block]:
    """Force and moment at all positions."""
    found = result.shaking
    columns: dict[str, ArrayLike] = {
        "$phi$, deg": np.degrees(result.phi),
        "$R_x$, N": found.force.real,
        "$R_y$, N": found.force.imag,
        "$R$, N": np.abs(found.force),
        "$R_{x1}$, N": found.turned.real,
        "$R_{y1}$, N": found.turned.imag,
        "$M_R$, N*m": found.moment,
    }
    caption = tr("Shaking force and moment")
    yield Paragraph(tr("Values in all positions are in table {tab:balance_shaking}."))
    yield tabulated(caption, columns, result.labels, head=tr("No."), key="balance_shaking")


def _harmonics(found: Shaking) -> Iterator[Block]:
    """The parts of the force that turn with the crank and against it, by their orders."""
    series = found.series
    yield Paragraph(
        tr(
            "The shaking force is a sum of vectors that turn $k$ times as fast as the crank, with it ($k > 0$) and "
            "against it ($k < 0$); their sizes $C_k$ are in table {tab:balance_harmonics}, with their parts of the "
            "mean square $R_q**2$."
        )
    )
    orders = [k for k in range(-HIGHEST, HIGHEST + 1) if abs(series.coefficient(k)) > NOISE * found.scale]
    sizes = np.array([abs(series.coefficient(k)) for k in orders])
    parts = np.array([series.coefficient(k) for k in orders])
    columns = {
        "$C_k$, N": sizes,
        "$C_{kx}$, N": np.where(abs(parts.real) > NOISE * found.scale, parts.real, 0.0),
        "$C_{ky}$, N": np.where(abs(parts.imag) > NOISE * found.scale, parts.imag, 0.0),
        "$C_k**2$/$R_q**2$, %": 100 * sizes**2 / series.rms**2,
    }
    labels = [str(k).replace("-", "−") for k in orders]
    yield tabulated(tr("Harmonics of the shaking force"), columns, labels, head="$k$", key="balance_harmonics")
