"""Crank-rocker from its swing 2 phi and time ratio, scaled by one length, with a second size or the best transmission.

The first two sizes leave a family of one free size (see rockerfamily.py): the second size is a root along it, the best
transmission the place where its slope changes sign: by a zero, by a jump, or where links get too long.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.notes import Said, held
from tmmcalc.core.numerics.roots import bracketed
from tmmcalc.core.plane import Real
from tmmcalc.linkage.model import Output
from tmmcalc.linkage.synthesis.builders import FourBar, four_bar
from tmmcalc.linkage.synthesis.designs import ClosedForm, closed_form, scene_of
from tmmcalc.linkage.synthesis.results import TRANSMISSION, Check, Size, Synthesis
from tmmcalc.linkage.synthesis.rockerfamily import Family, cosines, family, slopes
from tmmcalc.linkage.synthesis.simulation import Simulation, check, simulate
from tmmcalc.linkage.synthesis.strokes import overlap
from tmmcalc.linkage.synthesis.task import CrankRockerTask, SynthesisTask

KIND = "crank_rocker"
RULE = "the greatest least transmission angle"
SAMPLES = 4000
WEAK = 30.0  # deg: a smaller transmission angle is told
LENGTHS = ("crank", "coupler", "rocker", "frame")


def solve(task: SynthesisTask) -> Synthesis:
    """All crank-rockers with the swing and time ratio asked for; raises `NoSolutionError` if none is."""
    asked: CrankRockerTask = task.asked
    half, psi = asked.swing / 2, overlap(asked.time_ratio)
    found = [(x, side) for side in ((1,) if psi == 0 else (1, -1)) for x in _places(asked, half, psi, side)]
    if not found:
        raise _none(asked, half, psi)
    designs = [_closed(task, asked, family(np.array([x]), half, psi, side)) for x, side in found]
    designs.sort(key=lambda design: -design.merits[TRANSMISSION.key])
    return closed_form(task, KIND, RULE, designs)


def _grid(psi: float) -> Real:
    """Values of x, denser towards both ends."""
    s = math.sin(psi / 2)
    u = (1 - np.cos(np.linspace(0, np.pi, SAMPLES + 2)[1:-1])) / 2
    return s + (1 - s) * u


def _places(asked: CrankRockerTask, half: float, psi: float, side: int) -> list[float]:
    """Where the second size holds, or where the transmission is best."""
    x = _grid(psi)

    def residual(at: Real) -> Real:
        return _residual(asked, family(at, half, psi, side))

    if _second(asked) is None:
        return _best(asked.largest_ratio, x, half, psi, side)
    values = residual(x)
    change = np.flatnonzero(np.signbit(values[1:]) != np.signbit(values[:-1]))
    roots = bracketed(lambda at, which: residual(at), x[change], x[change + 1])
    good = family(roots, half, psi, side).transmission > 0
    if asked.transmission is not None:
        good &= np.abs(residual(roots)) < 1e-9
    return [float(root) for root in roots[good]]


def _second(asked: CrankRockerTask) -> str | None:
    """The second size by name: the transmission angle, or the ratio of two lengths."""
    given = [name for name in LENGTHS if getattr(asked, name) is not None]
    return "transmission" if asked.transmission is not None else given[1] if len(given) > 1 else None


def _residual(asked: CrankRockerTask, found: Family) -> Real:
    if asked.transmission is not None:
        return found.transmission - asked.transmission
    one, two = (name for name in LENGTHS if getattr(asked, name) is not None)
    lengths = {
        "crank": found.crank,
        "coupler": found.coupler,
        "rocker": np.ones_like(found.crank),
        "frame": found.frame,
    }
    return lengths[one] * getattr(asked, two) - lengths[two] * getattr(asked, one)


def _best(ratio: float, x: Real, half: float, psi: float, side: int) -> list[float]:
    """The place of the greatest least transmission angle, none where no links are short enough."""

    def slope(at: Real) -> Real:
        """Of what is to be largest: the transmission angle or, where links are too long, less their length."""
        found = family(at, half, psi, side)
        rates, size = slopes(at, found, half, psi, side), cosines(found)
        sharper = -np.take_along_axis(np.sign(size) * rates.cosines, np.argmax(np.abs(size), axis=0)[None], axis=0)[0]
        return np.where(found.longest > ratio * found.crank, -rates.ratio, sharper)

    found = family(x, half, psi, side)
    angles = np.where(found.longest <= ratio * found.crank, found.transmission, -1.0)
    k = int(np.argmax(angles))
    if angles[k] <= 0:
        return []
    low, high = x[[max(k - 1, 0)]], x[[min(k + 1, len(x) - 1)]]
    if slope(low)[0] < 0 or slope(high)[0] > 0:
        return [float(x[k])]  # the best of the grid is its end
    return [float(bracketed(lambda at, which: slope(at), low, high)[0])]


def _none(asked: CrankRockerTask, half: float, psi: float) -> NoSolutionError:
    members = [family(_grid(psi), half, psi, side) for side in (1, -1)]
    best = max(float(each.transmission.max()) for each in members)
    said, where = f"swing {math.degrees(asked.swing):.6g} deg and K = {asked.time_ratio:g}", f"synthesis.{KIND}"
    if best <= 0:
        return NoSolutionError(
            f"there is no crank-rocker of {said}",
            where=where,
            value=asked.swing,
            limit=math.pi - psi,
            remedy="ask for a smaller swing, or a time ratio nearer to 1",
        )
    if _second(asked) is None:
        least = min(
            float(np.min((each.longest / each.crank)[each.transmission > 0], initial=np.inf)) for each in members
        )
        return NoSolutionError(
            f"every crank-rocker of {said} has a link longer than largest_ratio = {asked.largest_ratio:g} cranks: "
            f"of {least:.6g} cranks or more",
            where=where,
            value=asked.largest_ratio,
            limit=least,
            remedy="raise largest_ratio above that, or ask for a larger swing",
        )
    return NoSolutionError(
        f"no crank-rocker of {said} has the second size asked for; "
        f"the best one has a least transmission angle of {math.degrees(best):.5g} deg",
        where=where,
        value=best,
        remedy="leave the second size out to see the best one, and take its sizes as a guide",
    )


def _closed(task: SynthesisTask, asked: CrankRockerTask, found: Family) -> ClosedForm:
    """The design in its own axes: crank's pivot at 0, rocker's pivot to the right of it."""
    ones = {"crank": found.crank[0], "coupler": found.coupler[0], "rocker": 1.0, "frame": found.frame[0]}
    base = next(name for name in LENGTHS if getattr(asked, name) is not None)
    scale = getattr(asked, base) / ones[base]
    r, l, rocker, frame = (float(scale * ones[name]) for name in LENGTHS)
    pivot = complex(found.pivot[0])
    turn = -pivot / abs(pivot)  # A to D along x
    above = (np.exp(1j * (math.pi / 2 + asked.swing / 2)) / turn).imag
    scene = scene_of(task, asked.swing, asked.time_ratio, Output(link=3))
    sizes4 = FourBar(0j, r, l, rocker, complex(frame), variant=1 if above > 0 else -1)
    mechanism = four_bar(sizes4, scene)
    simulation = simulate(mechanism)
    transmission = simulation.result.qualities[0].transmission or 0.0
    sizes = (
        Size("r", r, "m", "crank AB"),
        Size("l", l, "m", "coupler BC"),
        Size("R", rocker, "m", "rocker DC"),
        Size("L", frame, "m", "frame AD"),
        Size("two_phi", asked.swing, "rad", "swing of the rocker"),
        Size("psi", overlap(asked.time_ratio), "rad", "overlap angle"),
        Size("grashof", sum((r, l, rocker, frame)) - 2 * (r + max(l, rocker, frame)), "m", "Grashof's margin"),
    )
    checks = tuple(_checks(asked, simulation, (r, l, rocker, frame), transmission))
    merits = {TRANSMISSION.key: math.degrees(transmission), "r/L": r / frame}
    return ClosedForm("crank-rocker", sizes, checks, merits, mechanism, simulation, tuple(_notes(asked, transmission)))


def _checks(
    asked: CrankRockerTask, found: Simulation, lengths: tuple[float, ...], transmission: float
) -> Iterator[Check]:
    yield check("swing", found.stroke, "rad", asked.swing)
    yield check("K", found.time_ratio, "-", asked.time_ratio)
    yield check("least transmission angle", transmission, "rad", asked.transmission)
    for symbol, name, value in zip("rlRL", LENGTHS, lengths, strict=True):
        if getattr(asked, name) is not None:
            yield check(symbol, value, "m", getattr(asked, name))


def _notes(asked: CrankRockerTask, transmission: float) -> Iterator[Said]:
    if asked.time_ratio == 1:
        yield (
            "note: K = 1: the crank-rocker is central, a special case: the crank's pivot stands in line with both ends "
            "of the rocker pin, both swings take the same time, and r = R sin(phi)"
        )
    least = math.degrees(transmission)
    if transmission < math.radians(WEAK):
        text = "the least transmission angle is {value:.4g} deg, below {limit:g} deg"
        yield held("warning", text, least, WEAK, "deg", name="mu_min")
