"""The two flanks of a cam: motion of the wheel, pitch curve, pressure angle, curvature, working profile, the tip."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import degrees

import numpy as np

from tmmcalc.cams.indexing.results import LARGEST, Cam, FlankTable, PressureReached
from tmmcalc.cams.notes.stepping.quantities import MM, Stepping, at_part, at_row
from tmmcalc.report.drawing.order import POSITIONS, Order
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Heading, Paragraph, Place, Result, Table
from tmmcalc.report.telling import degrees as turned
from tmmcalc.report.telling import lines, number_of, numeral, plainly, tabulated

MOTION = ("phi = k*phi_p", "beta = beta_m*s", "beta' = beta_m*s'/phi_p", "beta'' = deg(180)*beta_m*s''/(pi*phi_p**2)")
STARTS = {"A": "theta_A = beta_0 + beta", "B": "theta_B = beta - beta_0"}
PITCH = (
    "R_<f> = sqrt(a**2 + l_k**2 - 2*a*l_k*cos(theta_<f>))",
    "psi_<f> = atan2(l_k*sin(theta_<f>), a - l_k*cos(theta_<f>))",
    "delta_<f> = psi_<f> - phi",
    "x_<f> = R_<f>*cos(delta_<f>)",
    "y_<f> = R_<f>*sin(delta_<f>)",
)
PRESSURE = "vartheta_<f> = atan((a*cos(theta_<f>) - l_k*(1 + beta'))/(a*sin(theta_<f>)))"
RATES = (
    "x'_<f> = l_k*(1 + beta')*sin(theta_<f> + phi) - a*sin(phi)",
    "y'_<f> = l_k*(1 + beta')*cos(theta_<f> + phi) - a*cos(phi)",
    "v_<f> = sqrt(x'_<f>**2 + y'_<f>**2)",
)
CURVATURE = (
    "D_<f> = a**2 + l_k**2*(1 + beta')**3 - a*l_k*(1 + beta')*(2 + beta')*cos(theta_<f>) - a*l_k*beta''*sin(theta_<f>)",
    "rho_<f> = v_<f>**3/D_<f>",
)
WORKING = "x_w<f> = x_<f> + r_r*y'_<f>/v_<f>", "y_w<f> = y_<f> - r_r*x'_<f>/v_<f>"
ROWS = 24  # of a table at most
STILL = 1e-9  # of l_k: a speed of the curve that is none
STRAIGHT = 1e-6  # of LARGEST: a radius of a straight piece
LEVEL = 1e-6  # [deg] theta at the line of centres


def shown_rows(of: Stepping, order: Order) -> list[int]:
    """Rows that are asked for, or one of each half of the step."""
    count = len(of.found.k) - 1
    return order.rows(POSITIONS, of.found.labels) or [count // 4, count - count // 4]


def flanks(of: Stepping, cam: Cam, rows: Sequence[int]) -> Iterator[Block]:
    """Motion, pitch curves, pressure angles, curvature and working profiles at rows; the tables of all."""
    places = [Place(tr("at k = {part}", part=plainly(float(of.found.k[row]))), at_row(of, row)) for row in rows]
    yield Heading(tr("Profile of the cams"), 3)
    yield Paragraph(
        tr(
            "Flank A of the lobe of one cam pushes its roller outwards, groove B of the other leads its roller through "
            "the line of centres. The wheel follows the law of the step:"
        )
    )
    yield from lines(MOTION, places)
    for flank in ("A", "B"):
        said = tr("Flank A") if flank == "A" else tr("Groove B")
        yield Paragraph(tr("{flank}: roller, pitch curve, pressure angle, curvature, working profile.", flank=said))
        yield from _flank(flank, places)
    yield Paragraph(
        tr(
            "The pitch curves and pressure angles over the step are in tables {tab:indexing_A} and {tab:indexing_B}, "
            "the working profiles in table {tab:indexing_working}."
        )
    )
    yield from (_table(of, table) for table in (cam.a, cam.b))
    yield _working(of, cam)
    yield from _tip(of, cam)
    yield from _pressures(of, cam)


def _flank(flank: str, places: Sequence[Place]) -> Iterator[Block]:
    """One flank; where the roller crosses the line of centres it has no pressure angle by its tangent."""
    words = {"f": flank}
    yield from lines((STARTS[flank], *PITCH), places, words)
    yield from lines([PRESSURE], [at for at in places if _beside(at, flank)], words)
    moving = [at for at in places if number_of(at.lexicon, f"v_{flank}") > STILL * number_of(at.lexicon, "l_k")]
    yield from lines(RATES, places, words)
    bent = [at for at in moving if abs(number_of(at.lexicon, f"rho_{flank}")) < STRAIGHT * LARGEST]
    yield from lines(CURVATURE, bent, words)
    yield from lines(WORKING, moving, words)


def _beside(at: Place, flank: str) -> bool:
    """Whether the roller is off the line of centres."""
    return abs(number_of(at.lexicon, f"theta_{flank}")) > LEVEL


def _few(of: Stepping) -> list[int]:
    """Rows of a table, in even steps with both ends."""
    count = len(of.found.k)
    return np.unique(np.linspace(0, count - 1, min(count, ROWS + 1)).round().astype(int)).tolist()


def _table(of: Stepping, flank: FlankTable) -> Table:
    """A flank over the step."""
    rows, f = _few(of), flank.name
    bends = np.where(np.abs(flank.bend) < STRAIGHT * LARGEST * np.max(flank.radius), flank.bend, np.nan)
    columns = {
        f"$theta_{f}$, deg": np.degrees(flank.theta)[rows],
        f"$R_{f}$, mm": MM * flank.radius[rows],
        f"$delta_{f}$, deg": np.degrees(flank.polar)[rows],
        f"$vartheta_{f}$, deg": np.degrees(flank.pressure)[rows],
        f"$rho_{f}$, mm": MM * bends[rows],
        f"$x_{f}$, mm": MM * flank.x[rows],
        f"$y_{f}$, mm": MM * flank.y[rows],
    }
    caption = tr("Flank A over the step") if f == "A" else tr("Groove B over the step")
    return tabulated(caption, columns, _parts(of, rows), head="$k$", key=f"indexing_{f}")


def _parts(of: Stepping, rows: Sequence[int]) -> list[str]:
    return [f"${numeral(float(of.found.k[row]))}$" for row in rows]


def _working(of: Stepping, cam: Cam) -> Table:
    """The motion of the wheel and the working profiles over the step."""
    rows, (y, y1, y2, _) = _few(of), of.found.motion
    columns = {
        "$beta$, deg": np.degrees(y)[rows],
        "$beta'$": y1[rows],
        "$beta''$": y2[rows],
        "$x_wA$, mm": MM * cam.a.working_x[rows],
        "$y_wA$, mm": MM * cam.a.working_y[rows],
        "$x_wB$, mm": MM * cam.b.working_x[rows],
        "$y_wB$, mm": MM * cam.b.working_y[rows],
    }
    caption = tr("Motion of the wheel and working profiles over the step")
    return tabulated(caption, columns, _parts(of, rows), head="$k$", key="indexing_working")


def _tip(of: Stepping, cam: Cam) -> Iterator[Block]:
    """Where B takes over from A: the polar angle of A comes to the axis of the lobe (3)."""
    end = cam.handover
    lexicon = at_part(of, end.part)
    lexicon["k_m"] = Given(end.part, "", tr("part of the step at which groove B takes over"))
    lexicon["R_m"] = Given(MM * end.radius, "mm", tr("distance of the tip of the lobe from the axis of the cams"))
    lexicon["vartheta_2"] = Given(degrees(end.angle), "deg", tr("pressure angle with which B takes over"))
    yield Heading(tr("Tip of the lobe and pressure angles"), 3)
    yield Paragraph(
        tr(
            "The lobe is symmetric, so flank A ends on its axis: there the polar angle $psi_A$ is "
            "$phi_p*(k_m - 1/2)$. This equation has the solution $k_m = {part}$, which the two lines for $psi_A$ show:",
            part=numeral(end.part, 7),
        )
    )
    place = [Place("", lexicon)]
    yield from lines(("beta = beta_m*s", STARTS["A"], PITCH[1], "psi_A = phi_p*(k_m - 1/2)"), place, {"f": "A"})
    texts = [
        "R_m = sqrt(a**2 + l_k**2 - 2*a*l_k*cos(theta_A))",
        STARTS["B"],
        "vartheta_2 = atan((a*cos(theta_B) - l_k*(1 + beta'))/(a*sin(theta_B)))",
    ]
    yield from lines(texts, place)


def _pressures(of: Stepping, cam: Cam) -> Iterator[Block]:
    """The largest pressure angles of the run-up on A and of the run-out on B."""
    for reached, run in ((cam.run_up, tr("run-up on A")), (cam.run_out, tr("run-out on B"))):
        yield Paragraph(
            tr(
                "The largest pressure angle of the {run} is ${angle}$ at $k = {part}$; the limit is ${limit}$.",
                run=run,
                angle=turned(reached.largest),
                part=numeral(reached.part),
                limit=turned(reached.limit),
            )
        )
        yield _result(reached, run)


def _result(reached: PressureReached, run: str) -> Result:
    given = Given(degrees(reached.largest), "deg", tr("largest pressure angle"))
    return Result(f"vartheta_{reached.flank}", given, degrees(reached.limit), "<=", run)
