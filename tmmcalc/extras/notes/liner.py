"""A cylinder liner: the collar as a ring, the cylinder as a shell, what they do to each other, stresses along the bore.

The deflection is a sum of waves that die away from the ring and from the far end; of a long liner those of the far end
are nothing, and their terms leave the formulas.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import partial

import numpy as np

from tmmcalc.extras.liner import LONG, THIN, Liner, LinerTask, Shell, along, shell_of, solve_liner, waves_at
from tmmcalc.extras.notes.told import course, given
from tmmcalc.extras.pictures.liner import draw_liner
from tmmcalc.extras.tables.tasks.liner import to_liner
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.manuscript import Block, Datum, Display, Heading, Lexicon, Paragraph, Place, Result, Table
from tmmcalc.report.telling import data_of, drawn, held, lines, named, numeral, plainly

MM, KILO, MEGA = 1e3, 1e-3, 1e6  # formulas hold in N, mm, MPa
SHELL = ("alpha_s = (3*(1 - mu**2)/(r_1**2*h**2))**(1/4)", "D_s = E*h**3/(12*(1 - mu**2))")
RING = "F' = r_1*b*ln(r_2/r_1)"
CLAMPED = "m = kappa*p_{max}*D_h**2*e/(8*r_1)"
SWOLLEN = "w_p = p*r_1**2/(E*h)"
WAVES = "w = (A*cos(xi) + B*sin(xi))/exp(xi) + (C*cos(zeta) + G*sin(zeta))/exp(zeta) + w_p"
NEAR = ("p_1 = (A*cos(xi) + B*sin(xi))/exp(xi)", "s_1 = (B*cos(xi) - A*sin(xi))/exp(xi)")
FREE_END = ("G = -s_1", "C = p_1 + 2*s_1")
FAR = ("p_2 = (C*cos(zeta) + G*sin(zeta))/exp(zeta)", "s_2 = (G*cos(zeta) - C*sin(zeta))/exp(zeta)")
BENT = (
    "w = p_1 + p_2 + w_p",
    "w' = alpha_s*(s_1 - p_1) - alpha_s*(s_2 - p_2)",
    "M = -2*D_s*alpha_s**2*(s_1 + s_2)",
    "Q = 2*D_s*alpha_s**3*(p_1 + s_1) - 2*D_s*alpha_s**3*(p_2 + s_2)",
)
OF_RING = ("u = (q - Q_0)*r_1**2/(E*F')", "psi = 12*(m - M_0 - Q_0*b/2)*r_1**2/(E*F'*b**2)")
FOLLOWS = {"edge": "w_0 = u + psi*b/2", "centre": "w_0 = u"}
RING_STRESS = "sigma_k = E/r_1*(abs(u) + abs(psi)*b/2)"
STRESSES = (
    "sigma_x = 6*M/h**2",
    "sigma_t = E*w/r_1",
    "sigma_{ti} = sigma_t + mu*sigma_x",
    "sigma_{te} = sigma_t - mu*sigma_x",
    "sigma_i = sqrt(sigma_x**2 - sigma_x*sigma_{ti} + sigma_{ti}**2)",
    "sigma_e = sqrt(sigma_x**2 + sigma_x*sigma_{te} + sigma_{te}**2)",
)
GONE = 2.5e-10  # of the waves from the ring: smaller ones are nothing, several of them together below `EXACT`
FIGURE = 150.0  # height [mm]


def blocks(order: Order) -> Iterator[Block]:
    """Shell and ring, their loads, the forces between them, the stresses, the bore."""
    result: Liner = order.results["liner"]
    task = to_liner(order.spec)
    shell = shell_of(task)
    known = _known(task)
    lexicon = named(_quantities(result, task, shell) | known)
    place = Place("", lexicon)
    yield Heading(tr("Cylinder liner"))
    yield from given(data_of(known), "liner")
    yield Heading(tr("Shell and ring"), 3)
    yield Paragraph(
        tr(
            "The collar is a ring, the cylinder below it a shell; forces and moments are those on a unit of the "
            "circumference. Parameter and stiffness of the shell:"
        )
    )
    yield from lines(SHELL, [place])
    thin = task.thickness / task.radius
    yield Paragraph(tr("The theory of shells is for thin walls:"))
    yield held(f"h/r_1 <= {numeral(THIN)}", (thin, THIN), "", holds=thin <= THIN)
    yield Paragraph(
        tr("The section of the ring, which counts fibres by their inverse radius, so that it turns as a whole:")
    )
    yield from lines([RING], [place])
    if task.clamp is not None:
        yield Paragraph(tr("The force that holds the collar is a multiple of that of the gas; it turns the ring by"))
        yield from lines([CLAMPED], [place])
    if task.pressure:
        yield Paragraph(tr("The pressure alone widens the shell by"))
        yield from lines([SWOLLEN], [place])
    shown = _shown(result, shell)
    felt = _felt(shell, [*shown])
    if felt and shell.span is not None:
        shown.setdefault(float(shell.span / shell.alpha), tr("at the far end"))
    nothing = {} if felt else {name: Given(0.0) for name in ("C", "G", "p_2", "s_2")}
    places = [Place(said, lexicon | named(_at(task, shell, x)) | nothing) for x, said in shown.items()]
    yield from _joined(result, task, shell, place, places, felt=felt)
    yield from _stresses(result, task, places, lexicon)
    yield from _course(result)


def data(order: Order) -> Iterator[Block]:
    """The ring and the shell, how they hang together, their loads."""
    task = to_liner(order.spec)
    yield Paragraph(
        tr(
            "The collar of a cylinder liner is a ring, the cylinder below it a thin shell. Forces and moments are "
            "those on a unit of the circumference of radius $r_1$; the axis $x$ runs along the bore from the ring, "
            "the deflection $w$ and the force $q$ are positive outwards, the moment $m$ towards larger $w'$."
        )
    )
    if task.clamp is not None:
        yield Paragraph(
            tr(
                "The collar is clamped by $kappa$ times the force of the gas on the area of diameter $D_h$: the head "
                "presses on it, the block carries it by the arm $e$ farther from the axis, which gives the moment $m$."
            )
        )
    yield from data_of(_known(task))
    far = tr("free end") if task.length is not None else tr("so far that it is not felt at the ring")
    yield Datum(tr("far end of the shell"), text=far)
    follows = tr("its edge, which the turn of the ring moves too") if task.continuity == "edge" else tr("its centre")
    yield Datum(tr("what of the ring the shell follows"), text=follows)


def _known(task: LinerTask) -> Lexicon:
    """What is given, without loads that are nothing."""
    found = {
        "r_1": Given(MM * task.radius, "mm", tr("radius of the shell, at which the ring joins it")),
        "h": Given(MM * task.thickness, "mm", tr("wall of the shell")),
        "r_2": Given(MM * task.outer, "mm", tr("outer radius of the ring")),
        "b": Given(MM * task.width, "mm", tr("width of the ring along the bore")),
    }
    if task.length is not None:
        found["L"] = Given(MM * task.length, "mm", tr("length of the shell"))
    found["E"] = Given(task.young / MEGA, "MPa", tr("modulus of elasticity of the liner"))
    found["mu"] = Given(task.poisson, "", tr("Poisson's ratio"))
    found |= {name: each for name, each in _loads(task).items() if each.value}
    clamp = task.clamp
    if clamp is not None:
        found["p_{max}"] = Given(clamp.pressure / MEGA, "MPa", tr("largest pressure of the gas"))
        found["D_h"] = Given(MM * clamp.bore, "mm", tr("diameter of the area that the gas acts on"))
        found["e"] = Given(MM * clamp.arm, "mm", tr("arm of the forces of the block and of the head on the collar"))
        found["kappa"] = Given(clamp.factor, "", tr("force that holds the collar over that of the gas"))
    if task.allowed is not None:
        found["sigma_P"] = Given(task.allowed / MEGA, "MPa", tr("allowed equivalent stress"))
    return found


def _loads(task: LinerTask) -> Lexicon:
    return {
        "p": Given(task.pressure / MEGA, "MPa", tr("pressure in the shell below the ring")),
        "q": Given(KILO * task.load, "N/mm", tr("force on the ring outwards")),
        "m": Given(task.moment, "N", tr("moment on the ring")),
    }


def _quantities(result: Liner, task: LinerTask, shell: Shell) -> Lexicon:
    a, b, c, g = (MM * float(each) for each in shell.waves)
    wave, far = tr("constant of the waves from the ring"), tr("constant of the waves from the far end")
    found = _loads(task) | {
        "alpha_s": Given(result.alpha / MM, "1/mm", tr("parameter of the shell")),
        "D_s": Given(MM * result.stiffness, "N*mm", tr("bending stiffness of the shell")),
        "F'": Given(MM**2 * result.ring_area, "mm^2", tr("section of the ring")),
        "m": Given(result.moment, "N", tr("moment on the ring")),
        "w_p": Given(MM * float(shell.uniform), "mm", tr("deflection by the pressure alone")),
        "A": Given(a, "mm", wave),
        "B": Given(b, "mm", wave),
        "C": Given(c, "mm", far),
        "G": Given(g, "mm", far),
        "Q_0": Given(KILO * result.force, "N/mm", tr("force between ring and shell")),
        "M_0": Given(result.couple, "N", tr("moment between ring and shell")),
        "w_0": Given(MM * result.end, "mm", tr("deflection of the shell at the ring")),
        "psi": Given(result.turn, "rad", tr("turn of the ring")),
        "u": Given(MM * result.centre, "mm", tr("displacement of the centre of the ring outwards")),
        "sigma_k": Given(result.ring_stress / MEGA, "MPa", tr("largest stress along the circumference of the ring")),
    }
    if shell.span is not None:
        found["lambda"] = Given(float(shell.span), "", tr("reduced length of the shell"))
    return found


def _joined(
    result: Liner, task: LinerTask, shell: Shell, place: Place, places: Sequence[Place], *, felt: bool
) -> Iterator[Block]:
    """The waves of the shell, what holds at its ends, and that it follows the ring."""
    yield Heading(tr("Forces between ring and shell"), 3)
    if shell.span is not None:
        yield Paragraph(tr("The reduced length of the shell, by which waves die away along it:"))
        yield from lines(["lambda = alpha_s*L"], [place])
    if felt:
        yield Paragraph(
            tr(
                "The deflection $w$ of the shell outwards are waves that die away from the ring, with $xi = "
                "alpha_s*x$, and from the far end, with $zeta = lambda - xi$:"
            )
        )
        yield Display(read(WAVES if task.pressure else WAVES.removesuffix(" + w_p")))
    else:
        yield Paragraph(
            tr(
                "The shell is long, so its deflection $w$ outwards are waves that die away from the ring, with "
                "$xi = alpha_s*x$:"
            )
        )
        near = WAVES.partition(" + (C")[0]
        yield Display(read(f"{near} + w_p" if task.pressure else near))
    yield Paragraph(
        tr(
            "Force and moment between ring and shell, deflection and slope of the shell at the ring follow from "
            "these waves, displacement and turn of the ring from its loads. The shell follows the edge of the ring, "
            "which its turn moves too:"
        )
        if task.continuity == "edge"
        else tr(
            "Force and moment between ring and shell, deflection and slope of the shell at the ring follow from these "
            "waves, displacement and turn of the ring from its loads. The shell follows the centre of the ring:"
        )
    )
    ring = (OF_RING[0].replace("q - Q_0", "-Q_0") if not task.load else OF_RING[0], OF_RING[1])
    yield from (Display(read(text)) for text in (*ring, FOLLOWS[task.continuity]))
    a, b = (plainly(MM * float(each), 7) for each in shell.waves[:2])
    found = {"a": a, "b": b, "q": plainly(KILO * result.force, 7), "m": plainly(result.couple, 7)}
    yield Paragraph(
        tr(
            "The solution of these linear equations is $A$ = {a} mm, $B$ = {b} mm, $Q_0$ = {q} N/mm, $M_0$ = {m} N. "
            "The shell has with it:",
            **found,
        )
    )
    yield from lines(["xi = alpha_s*x", *NEAR], places)
    if felt:
        yield Paragraph(tr("At the far end there is neither moment nor force, which gives the waves from it:"))
        yield from lines(FREE_END, [places[-1]._replace(name="")])
        yield from lines(["zeta = lambda - xi", *FAR], places)
    yield Paragraph(tr("Deflection, slope, moment and force of the shell:"))
    yield from lines(BENT, places)
    yield Paragraph(
        tr(
            "At the ring these are $Q = Q_0$, $M = -M_0$, $w = w_0$, $w' = psi$. The ring has the same deflection "
            "and turn:"
        )
    )
    yield from lines([*OF_RING, FOLLOWS[task.continuity]], [place])
    yield from _others(result, task, shell)


def _others(result: Liner, task: LinerTask, shell: Shell) -> Iterator[Block]:
    """Force and moment by the other continuity, and by the formulas of a long shell where this one is short."""
    said = {
        "edge": tr("the shell follows the edge of the ring"),
        "centre": tr("the shell follows the centre of the ring"),
    }
    other = "centre" if task.continuity == "edge" else "edge"
    found = {
        said[task.continuity]: (result.force, result.couple),
        said[other]: (result.other_force, result.other_couple),
    }
    if shell.span is not None and shell.span < LONG:
        long = solve_liner(replace(task, length=None))
        found[tr("a long shell")] = long.force, long.couple
        yield Paragraph(
            tr(
                "Since $lambda$ is below {limit}, the far end is felt at the ring, and formulas of a long shell do not "
                "hold.",
                limit=plainly(LONG),
            )
        )
    yield Paragraph(tr("What other assumptions give is in table {tab:liner_others}."))
    rows = tuple((name, f"${numeral(KILO * q)}$", f"${numeral(m)}$") for name, (q, m) in found.items())
    head = tr("Assumption"), f"$Q_0$, {tr_unit('N/mm')}", f"$M_0$, {tr_unit('N')}"
    yield Table(tr("Force and moment between ring and shell"), head, rows, "liner_others")


def _shown(result: Liner, shell: Shell) -> dict[float, str]:
    """The places of the bore that are worked out: the ring, the extremes, one where the wave has fallen to a third."""
    between = float(result.x[int(np.argmin(np.abs(shell.alpha * result.x - 1.0)))])
    places = dict.fromkeys((result.bending.x, result.largest.x, between))
    at = {x: tr("at x = {place} mm", place=plainly(MM * x)) for x in sorted(places)}
    at[0.0] = tr("at the ring")
    return dict(sorted(at.items()))


def _felt(shell: Shell, places: Sequence[float]) -> bool:
    """Whether the waves from the far end are anything at these places."""
    (near, bent), (far, far_bent) = waves_at(shell, np.array(places))
    size = np.maximum(np.abs(near), np.abs(bent))
    return bool(np.any(np.maximum(np.abs(far), np.abs(far_bent)) > GONE * size))


def _stresses(result: Liner, task: LinerTask, places: Sequence[Place], lexicon: Lexicon) -> Iterator[Block]:
    """The stress of the ring; those of the shell at the ring and where they are largest, with what is allowed."""
    yield Heading(tr("Stresses"), 3)
    yield Paragraph(tr("The largest stress of the ring at its inner edge:"))
    yield from lines([RING_STRESS], [Place("", lexicon)])
    yield Paragraph(
        tr(
            "Stresses of the shell: $sigma_x$ of bending at the inner surface, $sigma_t$ along the circumference, in "
            "the mean and at both surfaces, $sigma_i$ and $sigma_e$ equivalent by Mises at the inner and the outer "
            "surface:"
        )
    )
    yield from lines(STRESSES, places)
    peak = result.largest
    values = {"stress": plainly(peak.stress / MEGA), "x": plainly(MM * peak.x)}
    yield Paragraph(
        tr("The equivalent stress is largest at the inner surface, {stress} MPa at $x$ = {x} mm.", **values)
        if peak.surface == "inner"
        else tr("The equivalent stress is largest at the outer surface, {stress} MPa at $x$ = {x} mm.", **values)
    )
    largest = Given(peak.stress / MEGA, "MPa", tr("largest equivalent stress of the shell"))
    allowed = None if task.allowed is None else task.allowed / MEGA
    if allowed is not None:
        assert isinstance(largest.value, float)
        yield held("sigma_{max} <= sigma_P", (largest.value, allowed), "MPa", holds=largest.value <= allowed)
    yield Result("sigma_{max}", largest, allowed, "<=" if allowed is not None else "")
    yield Result("sigma_k", lexicon["sigma_k"])


def _at(task: LinerTask, shell: Shell, x: float) -> Lexicon:
    """Deflection, moment, force and stresses at a place of the bore."""
    found = {name: float(each[0]) for name, each in along(task, shell, np.array([x])).items()}
    xi = float(shell.alpha) * x
    (near, near_bent), (far, far_bent) = waves_at(shell, np.array([x]))
    waves = {
        "p_1": Given(MM * float(near[0]), "mm", tr("wave from the ring")),
        "s_1": Given(MM * float(near_bent[0]), "mm", tr("half the second derivative of the wave, with the other sign")),
        "p_2": Given(MM * float(far[0]), "mm", tr("wave from the far end")),
        "s_2": Given(MM * float(far_bent[0]), "mm", tr("half the second derivative of the wave, with the other sign")),
    }
    return waves | {
        "x": Given(MM * x, "mm", tr("place along the bore, from the ring")),
        "xi": Given(xi, "", tr("reduced distance from the ring")),
        "zeta": Given(
            0.0 if shell.span is None else float(shell.span) - xi, "", tr("reduced distance from the far end")
        ),
        "w": Given(MM * found["w"], "mm", tr("deflection of the shell outwards")),
        "w'": Given(found["slope"], "rad", tr("slope of the shell")),
        "M": Given(found["bend"], "N", tr("moment of bending of the shell")),
        "Q": Given(KILO * found["shear"], "N/mm", tr("force across the shell")),
        "sigma_x": Given(found["axial"] / MEGA, "MPa", tr("stress of bending at the inner surface")),
        "sigma_t": Given(found["hoop"] / MEGA, "MPa", tr("stress along the circumference")),
        "sigma_{ti}": Given(
            found["inner_hoop"] / MEGA, "MPa", tr("stress along the circumference at the inner surface")
        ),
        "sigma_{te}": Given(
            found["outer_hoop"] / MEGA, "MPa", tr("stress along the circumference at the outer surface")
        ),
        "sigma_i": Given(found["inner"] / MEGA, "MPa", tr("equivalent stress at the inner surface")),
        "sigma_e": Given(found["outer"] / MEGA, "MPa", tr("equivalent stress at the outer surface")),
    }


def _course(result: Liner) -> Iterator[Block]:
    """The table and the diagrams."""
    yield Paragraph(tr("The values along the bore are in table {tab:liner_course} and in figure {fig:liner}."))
    columns = {
        "$x$, mm": MM * result.x,
        "$w$, mm": MM * result.w,
        "$M$, N": result.bend,
        "$Q$, N/mm": KILO * result.shear,
        "$sigma_x$, MPa": result.axial / MEGA,
        "$sigma_t$, MPa": result.hoop / MEGA,
        "$sigma_i$, MPa": result.inner / MEGA,
        "$sigma_e$, MPa": result.outer / MEGA,
    }
    yield drawn(
        tr("Deflection, moment and stresses along the bore"), partial(draw_liner, result=result), FIGURE, "liner"
    )
    yield course(tr("The shell along the bore"), columns, "liner_course")
