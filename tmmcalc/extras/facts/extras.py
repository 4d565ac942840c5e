"""The documents of the small calculators: contact, reliability, tie-down, falling ball, bearing."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import degrees

import numpy as np

from tmmcalc.core.columns import picked
from tmmcalc.extras.bearing import Bearing
from tmmcalc.extras.columns import ball_columns, contact_columns, reliability_columns
from tmmcalc.extras.contact import Contact
from tmmcalc.extras.falling_ball import Ball, Moment
from tmmcalc.extras.reliability import Reliability
from tmmcalc.extras.tie_down import TieDown
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.numbers import angle, number
from tmmcalc.report.sizes import drawn, plain, quantity

SHOWN = 25  # rows that people get
MORE = "--positions names further rows, --format csv prints all"
HELD = {
    "friction": "friction alone holds the load",
    "all ties": "all four ties hold the load",
    "two ties": "two ties hold the load, the opposite ones are slack",
}


def contact_summary(result: Contact, title: str) -> Document:
    """Pressure, approach and area, with what Hertz has."""
    grid = f"{len(result.x)} nodes at {quantity(result.step, 'm')}, {result.touching} touch; {result.passes} passes"
    x, y = result.peak_at
    facts = [
        Fact("grid", grid, {"c[m]": result.step, "touching": result.touching, "passes": result.passes}),
        Fact(
            "largest pressure",
            f"{quantity(result.peak, 'Pa')} at x = {quantity(x, 'm')}, y = {quantity(y, 'm')}",
            {"p_max[Pa]": result.peak, "x[m]": x, "y[m]": y},
        ),
        Fact("approach", f"{number(1e6 * result.approach, 6)} um", {"delta[m]": result.approach}),
        Fact("contact area", f"{number(1e6 * result.area, 5)} mm^2", {"A[m^2]": result.area}),
        Fact(
            "change from a grid twice as coarse",
            f"pressure {result.peak_change:.1e}, approach {result.approach_change:.1e}; load kept to "
            f"{result.load_error:.0e}",
            {"p_change": result.peak_change, "delta_change": result.approach_change, "load_error": result.load_error},
        ),
    ]
    smooth = result.hertz
    if smooth is not None:
        text = f"half-axes {quantity(smooth.along_x, 'm')} along x, {quantity(smooth.along_y, 'm')} along y\n"
        text += f"p0 = {quantity(smooth.peak, 'Pa')}, approach {number(1e6 * smooth.approach, 6)} um"
        text += f"\nhere p_max/p0 = {number(result.peak / smooth.peak, 6)}, "
        text += f"of the approaches {number(result.approach / smooth.approach, 6)}"
        values = {
            "a_x[m]": smooth.along_x,
            "a_y[m]": smooth.along_y,
            "p0[Pa]": smooth.peak,
            "delta_H[m]": smooth.approach,
        }
        facts.append(Fact("Hertz", text, values))
    return Document(title, tuple(facts), result.notes)


def contact_document(
    result: Contact, title: str, *, patterns: Sequence[str], rows: Sequence[int] | None, everything: bool, where: str
) -> Document:
    """The summary with the pressures; people get the nodes on the axis of x."""
    axis = [int(k) for k in np.flatnonzero(np.abs(result.y) < result.step / 4)]
    view = _view(contact_columns(result), patterns, rows, everything, axis)
    return _with_table(contact_summary(result, title), view, everything or rows is not None)


def reliability_summary(result: Reliability, title: str) -> Document:
    """Strength, threshold, mean life, lives and reliabilities that are asked for."""
    never = "never" if result.floor is None else f"from {number(result.floor, 8)}"
    lives = ", ".join(f"{number(life)} with {number(part)}" for part, life in result.lives)
    facts = [
        Fact(
            "strength",
            f"r = {number(result.strength, 10)}, beta = {number(result.decay, 10)}",
            {"r": result.strength, "beta": result.decay},
        ),
        Fact("loads", f"from {number(result.low)} to {number(result.high)}", {"a": result.low, "b": result.high}),
        Fact(
            "no failure up to",
            f"t0 = {number(result.threshold, 9)}; every shock is a failure {never}",
            {"t0": result.threshold, "t_a": result.floor},
        ),
        Fact("mean life", number(result.mean, 9), {"mean_life": result.mean}),
        Fact("life", lives, {"lives": [{"R": part, "t": life} for part, life in result.lives]}),
    ]
    if result.asked:
        text = "\n".join(f"R({number(t)}) = {number(r, 6)}" for t, r in result.asked)
        facts.append(Fact("reliability", text, {"R_at": [{"t": t, "R": r} for t, r in result.asked]}))
    return Document(title, tuple(facts), result.notes)


def reliability_document(
    result: Reliability,
    title: str,
    *,
    patterns: Sequence[str],
    rows: Sequence[int] | None,
    everything: bool,
    where: str,
) -> Document:
    """The summary with the reliability over the time."""
    view = _view(reliability_columns(result), patterns, rows, everything, _even(len(result.t)))
    return _with_table(reliability_summary(result, title), view, everything or rows is not None)


def tie_down_document(result: TieDown, title: str) -> Document:
    """Loads and forces of the ties."""
    two = f"R = {number(result.force, 7)} N, dR = {number(result.change, 7)} N; of an opposite tie "
    facts = (
        Fact(
            "load",
            f"F = {number(result.push, 7)} N moves it, G = {number(result.press, 7)} N presses it on the cradle",
            {"F[N]": result.push, "G[N]": result.press},
        ),
        Fact("preload", f"P0 = {number(result.preload, 7)} N", {"P0[N]": result.preload}),
        Fact(
            "R by formula (3)",
            f"{two}{number(result.opposite, 7)} N",
            {"R[N]": result.force, "dR[N]": result.change, "R_opposite[N]": result.opposite},
        ),
        Fact("vertical load of the ties", f"{number(result.vertical, 7)} N", {"vertical[N]": result.vertical}),
        Fact(
            "R by equilibrium",
            f"{number(result.balanced, 7)} N of a stretched tie; {HELD[result.held]}",
            {"R_balanced[N]": result.balanced, "held_by": result.held},
        ),
        Fact(
            "best elevation",
            f"{angle(degrees(result.best_elevation))} deg",
            {"alpha_best[deg]": degrees(result.best_elevation)},
        ),
    )
    return Document(title, facts, result.notes)


def ball_summary(result: Ball, title: str) -> Document:
    """What drives the ball, its maximum, its stop, what is asked for."""
    facts = [Fact("driven by", f"{number(result.drive)} m/s^2", {"a[m/s^2]": result.drive, "eta0": result.argument})]
    if result.fastest is not None:
        facts.append(Fact("largest speed", _moment(result.fastest), {"v_max": _values(result.fastest)}))
    if result.stop is not None:
        values = {"stop": _values(result.stop), "tau*": result.stop_argument}
        facts.append(Fact("stop", f"{_moment(result.stop)}, tau* = {number(result.stop_argument or 0.0)}", values))
    if result.total is not None:
        facts.append(Fact("whole way", f"{number(result.total)} m", {"S_max[m]": result.total}))
    if result.asked:
        text = "\n".join(_moment(each) for each in result.asked)
        facts.append(Fact("at", text, {"at": [_values(each) for each in result.asked]}))
    facts.append(Fact("error of the way", f"{result.error['way']:.0e}, relative", {"S_error": result.error["way"]}))
    return Document(title, tuple(facts), result.notes)


def _moment(at: Moment) -> str:
    return f"t = {number(at.t)} s: v = {number(at.v)} m/s, S = {number(at.way)} m"


def _values(at: Moment) -> dict[str, float]:
    return {"t[s]": at.t, "v[m/s]": at.v, "S[m]": at.way}


def ball_document(
    result: Ball, title: str, *, patterns: Sequence[str], rows: Sequence[int] | None, everything: bool, where: str
) -> Document:
    """The summary with the fall over the time."""
    view = _view(ball_columns(result), patterns, rows, everything, _even(len(result.t)))
    return _with_table(ball_summary(result, title), view, everything or rows is not None)


def bearing_document(result: Bearing, title: str) -> Document:
    """Speeds, sizes, frequencies of defects, crest factors."""
    speed = f"{number(result.omega)} rad/s, n = {number(result.turns)} 1/s ({number(60 * result.turns)} rpm)"
    sizes = f"between the rings {quantity(result.width, 'm')}, half of it {quantity(result.half, 'm')}; mean radius "
    named = (
        ("cage", "FTF", result.cage),
        ("outer raceway", "BPFO", result.outer_race),
        ("inner raceway", "BPFI", result.inner_race),
        ("rolling body", "BSF", result.roller),
    )
    facts = [
        Fact("speed", speed, {"omega[rad/s]": result.omega, "n[1/s]": result.turns}),
        Fact(
            "sizes",
            f"{sizes}{quantity(result.mean_radius, 'm')}",
            {"R_n[m]": result.width, "half[m]": result.half, "R_mean[m]": result.mean_radius},
        ),
        Fact("speed of the inner ring", f"{number(result.raceway_speed)} m/s", {"v_inner[m/s]": result.raceway_speed}),
        *(Fact(name, f"{short} = {number(f)} Hz", {f"{short}[Hz]": f}) for name, short, f in named),
    ]
    if result.crest:
        text = ", ".join(number(each, 4) for each in result.crest)
        facts.append(Fact("crest factors", text, {"crest": list(result.crest)}))
    return Document(title, tuple(facts), result.notes)


def _view(
    columns: Mapping[str, np.ndarray],
    patterns: Sequence[str],
    rows: Sequence[int] | None,
    everything: bool,
    told: Sequence[int],
) -> View:
    """The table of chosen columns; people get the rows that are told, in the units of a drawing."""
    chosen = picked(columns, patterns)
    whole = plain(chosen) if everything else drawn(chosen)
    if rows is None:
        rows = range(len(columns["i"])) if everything else told
    peaks = [max((abs(v) for v in column if isinstance(v, float)), default=0.0) for column in whole.columns]
    return View(whole.headers, [[column[k] for k in rows] for column in whole.columns], () if everything else peaks)


def _even(count: int) -> list[int]:
    """Indices of some rows at equal steps, the first and the last among them."""
    return sorted({round(k * (count - 1) / (SHOWN - 1)) for k in range(SHOWN)})


def _with_table(summary: Document, view: View, complete: bool) -> Document:
    return Document(summary.title, summary.facts, summary.notes, view, more="" if complete else MORE)
