"""Path and motion generators: the equations at all points or poses, how they are solved, what is left."""

from __future__ import annotations

import cmath
from collections.abc import Iterator

import numpy as np

from tmmcalc.core.plane import Plane
from tmmcalc.linkage.chain import chain_of
from tmmcalc.linkage.kinematics import solve_kinematics
from tmmcalc.linkage.notes.syntheses.fourbar import turning
from tmmcalc.linkage.notes.syntheses.told import Told, angle, course_of, length, ratio, sound
from tmmcalc.linkage.synthesis.path import STARTS
from tmmcalc.linkage.synthesis.pathequations import Path
from tmmcalc.linkage.synthesis.posesearch import NEAREST
from tmmcalc.linkage.synthesis.results import ANGLE_ERROR, DISTANCE
from tmmcalc.linkage.synthesis.task import PoseTask
from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.language import tr, tr_name
from tmmcalc.report.manuscript import Block, Datum, Display, Heading, Paragraph, Place, Result
from tmmcalc.report.telling import held, lines, named, quantities, tabulated, vector

CRANK = ("x_Bi = x_A + a*cos(phi_i)", "y_Bi = y_A + a*sin(phi_i)")
POINT = ("x_Pi = x_Bi + p*cos(theta_i) - q*sin(theta_i)", "y_Pi = y_Bi + p*sin(theta_i) + q*cos(theta_i)")
COUPLER = ("x_Ci = x_Bi + b*cos(theta_i)", "y_Ci = y_Bi + b*sin(theta_i)")
ROCKER = ("c = sqrt((x_Ci - x_D)**2 + (y_Ci - y_D)**2)",)
GUIDE = ("x_Ci = x_G + s_i*cos(gamma)", "y_Ci = y_G + s_i*sin(gamma)")
TURNED, TIMED = "theta_i = beta_i - beta", "phi_i = phi_0 + tau_i"
CIRCLE = "(x_Bi - x_A)**2 + (y_Bi - y_A)**2 = (x_B1 - x_A)**2 + (y_B1 - y_A)**2"
LINEAR = "(x_Bi - x_B1)*x_A + (y_Bi - y_B1)*y_A = (x_Bi**2 + y_Bi**2 - x_B1**2 - y_B1**2)/2"
WORKED = 6  # points that are worked out; the tables have all


def task(told: Told) -> str:
    """What is sought."""
    asked: PoseTask = told.asked
    slides = asked.mechanism == "slider_crank"
    linkage = (
        tr(
            "A slider-crank is sought: crank $AB = a$, connecting rod $BC = b$, guide of $C$ through the point $G$ at "
            "the angle $gamma$."
        )
        if slides
        else tr("A four-bar linkage is sought: crank $AB = a$, coupler $BC = b$, rocker $DC = c$.")
    )
    if asked.angles is not None:
        return (
            linkage + " " + tr("Its coupler is to carry a body through given poses: places of a point $P$ and angles.")
        )
    if asked.timing is not None:
        return (
            linkage
            + " "
            + tr("The point $P$ of its coupler is to pass through given points while the crank turns by given angles.")
        )
    return linkage + " " + tr("The point $P$ of its coupler is to pass through given points.")


def given(told: Told) -> dict[str, Given]:
    """What is asked beside the points."""
    asked: PoseTask = told.asked
    found = {
        "n": ratio(len(asked.points), tr("number of points")),
        "m": ratio(asked.largest_ratio, tr("largest ratio of the longest to the shortest link")),
    }
    if told.task.transmission:
        found["mu_a"] = angle(told.task.transmission, tr("allowed transmission angle"))
    if asked.region is not None:
        low, high = asked.region
        said = tr("corners of the region of the pivots")
        for name, at in (("I", low), ("II", high)):
            found |= {f"x_{{{name}}}": length(at.real, said), f"y_{{{name}}}": length(at.imag, said)}
    return found


def further(told: Told) -> Iterator[Block]:
    """The points or poses, and whether the crank has to turn fully."""
    asked: PoseTask = told.asked
    if asked.region is not None:
        yield Paragraph(tr("The fixed pivots stand in the rectangle between the corners of the region."))
    for k, at in enumerate(asked.points, 1):
        yield Datum(tr("point {number}", number=k), (f"x_{k}", f"y_{k}"), (at.real, at.imag), "m")
    if asked.angles is not None:
        for k, beta in enumerate(np.degrees(asked.angles).tolist(), 1):
            yield Datum(tr("angle of the body at point {number}", number=k), (f"beta_{k}",), (beta,), "deg")
    if asked.timing is not None:
        for k, tau in enumerate(np.degrees(asked.timing).tolist(), 1):
            said = tr("turn of the crank from the first point to point {number}", number=k)
            yield Datum(said, (f"tau_{k}",), (tau,), "deg")
    if asked.full_turn:
        yield Datum(tr("motion of the crank"), text=tr("a full turn"))


def blocks(told: Told) -> Iterator[Block]:
    """The wanted places, the equations with their unknowns, the way of their solution, the linkage at the points."""
    asked: PoseTask = told.asked
    yield Paragraph(
        tr("Table {tab:synthesis_points} has the wanted poses.")
        if asked.angles is not None
        else tr("Table {tab:synthesis_points} has the wanted points.")
    )
    yield _wanted(asked)
    yield from _equations(told, asked)
    if asked.angles is not None:
        yield from _circles(asked)
    yield Paragraph(_method(told, asked))
    nearest = told.found.rule == NEAREST
    best = tr("least sum of squares, parts of the spread") if nearest else tr("least residual, part of the spread")
    yield from course_of(told, best, of=tr("linkages iterated"))
    yield from _linkage(told, asked)


def _wanted(asked: PoseTask) -> Block:
    """The points, angles of the body, angles of the crank from the first point."""
    columns = {"$x_i$, m": asked.points.real, "$y_i$, m": asked.points.imag}
    if asked.angles is not None:
        columns["$beta_i$, deg"] = np.degrees(asked.angles)
    if asked.timing is not None:
        columns["$tau_i$, deg"] = np.degrees(asked.timing)
    labels = [str(k + 1) for k in range(len(asked.points))]
    caption = tr("Wanted poses of the body") if asked.angles is not None else tr("Wanted points of the coupler point")
    return tabulated(caption, columns, labels, head=tr("Point"), key="synthesis_points")


def _equations(told: Told, asked: PoseTask) -> Iterator[Block]:
    """The equations at a point, and how many there are of them and of the unknown."""
    slides = asked.mechanism == "slider_crank"
    yield Paragraph(
        tr(
            "With the angle $phi_i$ of the crank and the angle $theta_i$ of the coupler at point $i$ the linkage is "
            "at the point, and its other end on its path:"
        )
    )
    yield Display(read("x_i = x_A + a*cos(phi_i) + p*cos(theta_i) - q*sin(theta_i)"))
    yield Display(read("y_i = y_A + a*sin(phi_i) + p*sin(theta_i) + q*cos(theta_i)"))
    if slides:
        yield Display(
            read(
                "(y_A + a*sin(phi_i) + b*sin(theta_i) - y_G)*cos(gamma)"
                " = (x_A + a*cos(phi_i) + b*cos(theta_i) - x_G)*sin(gamma)"
            )
        )
    else:
        yield Display(
            read(
                "(x_A + a*cos(phi_i) + b*cos(theta_i) - x_D)**2 + (y_A + a*sin(phi_i) + b*sin(theta_i) - y_D)**2 = c**2"
            )
        )
    count = len(asked.points)
    sizes = "x_A, y_A, a, b, p, q, gamma, h_G" if slides else "x_A, y_A, a, b, c, x_D, y_D, p, q"
    free = len(sizes.split(", "))
    more = []
    if asked.timing is not None:
        yield Display(read(TIMED))
        more.append("phi_0")
        free += 1
    else:
        more.append("phi_i")
        free += count
    if asked.angles is not None:
        yield Display(read(TURNED))
        more.append("beta")
        free += 1
    else:
        more.append("theta_i")
        free += count
    names = ", ".join(f"${name}$" for name in (*sizes.split(", "), *more))
    yield Paragraph(
        tr(
            "These are {equations} equations for {count} points with {free} unknown: {names}.",
            equations=3 * count,
            count=count,
            free=free,
            names=names,
        )
    )


def _circles(asked: PoseTask) -> Iterator[Block]:
    """Burmester: what is asked of the pins of the body."""
    yield Paragraph(
        tr(
            "The pins $B$ and $C$ are points of the body all of whose places lie on a circle about $A$ or $D$ (points "
            "of Burmester):"
        )
    )
    yield Display(read(CIRCLE))
    yield Paragraph(tr("In the coordinates of the centre these are linear equations,"))
    yield Display(read(LINEAR))


def _method(told: Told, asked: PoseTask) -> str:
    """How the equations are solved."""
    counters, count = told.found.counters, len(asked.points)
    if told.found.rule == NEAREST:
        return tr(
            "Not all equations can be kept. Random linkages are brought to the points by the shift, turn and scale "
            "that fit best; from the nearest of them the sum of the squares of all deviations is made least by the "
            "method of Levenberg and Marquardt: {count} linkages.",
            count=counters.get("designs", len(told.listed)),
        )
    if asked.angles is None:
        path = Path(asked.points, asked.timing, asked.mechanism == "slider_crank")
        return tr(
            "They can be kept exactly at up to {most} points. The turns of the coupler are eliminated, and what is "
            "left is solved by the method of Levenberg and Marquardt from {starts} random linkages; it leads to "
            "{solutions} solutions.",
            most=path.most,
            starts=counters.get("starts", STARTS),
            solutions=counters.get("solutions", len(told.listed)),
        )
    pairs = counters.get("pairs", len(told.listed))
    if count == 5:
        return tr(
            "which for five poses have a solution where two determinants are zero: for at most four pins. They are "
            "the eigenvalues of a problem with two parameters, refined by Newton’s method; {pairs} pairs of pins are "
            "compared.",
            pairs=pairs,
        )
    if count == 4:
        return tr(
            "which for four poses have a solution where the determinant of the system is zero: the pins lie on a "
            "curve of the third order. It is cut by lines in all directions, whose cubic equations give pins; {pairs} "
            "pairs of pins are compared.",
            pairs=pairs,
        )
    return tr(
        "which for {count} poses have a solution for any pin. Pins are taken at random in the region; {pairs} pairs "
        "are compared.",
        count=count,
        pairs=pairs,
    )


def _linkage(told: Told, asked: PoseTask) -> Iterator[Block]:
    """The linkage that is taken, put into the equations at the points."""
    precision, slides = told.design.precision, asked.mechanism == "slider_crank"
    assert precision is not None
    b, c, turned = _pins(told, precision.crank)
    if not slides:
        frame = complex(
            told.design.size("x_D") - told.design.size("x_A"), told.design.size("y_D") - told.design.size("y_A")
        )
        told.give({"d": length(abs(frame), tr_name("frame AD"))})
    places = []
    for k in range(min(len(b), WORKED)):
        own = {
            "phi_i": angle(float(precision.crank[k]), tr("angle of the crank at the point")),
            "theta_i": angle(cmath.phase(turned[k]), tr("angle of the coupler at the point")),
            **vector("%_Bi", complex(b[k]), "m", tr("coordinates of point {point}", point="B")),
            **vector("%_Ci", complex(c[k]), "m", tr("coordinates of point {point}", point="C")),
            **vector("%_Pi", complex(precision.reached[k]), "m", tr("coordinates of point {point}", point="P")),
        }
        if slides:
            own["s_i"] = length(_along(told, complex(c[k])), tr("coordinate of the slider along the guide"))
        if asked.angles is not None:
            own["beta_i"] = angle(float(asked.angles[k]), tr("wanted angle of the body at the point"))
        if asked.timing is not None:
            own["tau_i"] = angle(float(asked.timing[k]), tr("turn of the crank from the first point"))
            own["phi_0"] = angle(float(precision.crank[0]), tr("angle of the crank at the first point"))
        places.append(Place(tr("at point {number}", number=k + 1), told.lexicon | named(own), str(k + 1)))
    yield Paragraph(tr("The dimensions of the linkage that is taken are in table {tab:synthesis_sizes}."))
    yield _sizes(told)
    yield Heading(tr("Linkage at the points"), 3)
    exact = told.found.rule != NEAREST
    angles = [TIMED] * (asked.timing is not None), [TURNED] * (asked.angles is not None and exact)
    texts = (*angles[0], *CRANK, *angles[1], *POINT, *COUPLER, *(GUIDE if slides else ROCKER))
    yield from lines(texts, places)
    if not slides:
        yield from told.lines("d = sqrt((x_D - x_A)**2 + (y_D - y_A)**2)")


def _along(told: Told, at: complex) -> float:
    """Coordinate of a point along the guide."""
    start = complex(told.design.size("x_G"), told.design.size("y_G"))
    return ((at - start) * cmath.rect(1.0, -told.design.size("gamma"))).real


def _sizes(told: Told) -> Block:
    return quantities(tr("Dimensions of the linkage"), told.sizes(), "synthesis_sizes", 7)


def _pins(told: Told, phi: np.ndarray) -> tuple[Plane, Plane, Plane]:
    """Places of the pins and the direction of the coupler at the angles of the crank, of the simulated linkage."""
    mechanism = to_linkage(told.order.read(told.design.spec).linkage)
    motions = chain_of(mechanism, solve_kinematics(mechanism)).evaluate(phi, order=0).motions
    coupler = motions[2]
    b, c = (np.asarray(coupler.point(at).r) for at in (0j, complex(told.design.size("b"))))
    return b, c, np.asarray(coupler.u)


def conditions(told: Told) -> Iterator[Block]:
    """Turning, transmission, ratio of the links, what is left at the points."""
    asked, precision = told.asked, told.design.precision
    assert precision is not None
    yield from turning(told, whole=True)
    largest = told.design.merits["longest/shortest"]
    yield Paragraph(tr("The ratio $k_l$ of the longest to the shortest link against its limit:"))
    yield held("k_l <= m", (largest, asked.largest_ratio), "", holds=largest <= asked.largest_ratio)
    columns = {
        "$phi_i$, deg": np.degrees(precision.crank),
        "$x_Pi$, m": precision.reached.real,
        "$y_Pi$, m": precision.reached.imag,
        tr("distance from the point") + ", mm": 1e3 * sound(precision.found),
    }
    if len(precision.angle_errors):
        columns[tr("error of the angle") + ", deg"] = np.degrees(sound(precision.angle_errors))
    sense = tr("counter-clockwise") if precision.sense > 0 else tr("clockwise")
    yield Paragraph(
        tr(
            "Table {tab:synthesis_errors} has the places that the linkage reaches; its crank turns {sense}.",
            sense=sense,
        )
    )
    labels = [str(k + 1) for k in range(len(precision.crank))]
    yield tabulated(tr("Places that the linkage reaches"), columns, labels, head=tr("Point"), key="synthesis_errors")
    distance = Given(told.design.merits[DISTANCE.key], "m", tr_name("largest distance from the points"))
    yield Result("Delta_m", distance)
    if ANGLE_ERROR.key in told.design.merits:
        drift = Given(told.design.merits[ANGLE_ERROR.key], "deg", tr_name("largest error of the body's angle"))
        yield Result("beta_m", drift)
