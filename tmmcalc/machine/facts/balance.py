"""The documents of the balance stage: of the linkage, and with it or in its place those of an engine and of a rotor.

Angles of weights are positive counter-clockwise. A place is phi, the crank coordinate counted from position 0.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from tmmcalc.core.columns import Column
from tmmcalc.core.errors import UsageError
from tmmcalc.core.notes import Phrase
from tmmcalc.core.numerics.fourier import Magnitude
from tmmcalc.core.quantity import Quantity, keyed
from tmmcalc.machine.balance.columns import FORCE, LEFT, MOMENT, ON_LINKS, columns
from tmmcalc.machine.balance.redistribution import Redistribution
from tmmcalc.machine.balance.schemes import RotatingWeight
from tmmcalc.machine.balance.solve import Balancing, Scheme
from tmmcalc.machine.balance.weights import Weight
from tmmcalc.machine.facts.shakingmoment import less, moment, moment_left, moved, phi_at, raised
from tmmcalc.machine.facts.weights import MAX_RATIO, RATIO, direction, ratios, size_text, size_values
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.numbers import NOISE, angle, number
from tmmcalc.report.positions import with_positions

if TYPE_CHECKING:
    from tmmcalc.machine.stages.balance import Balances

FURTHER = tuple(f"tmmcalc.machine.facts.{name}" for name in ("engine", "rotor"))  # where quantities stand, too

TOLD = (RATIO, MAX_RATIO)  # of `weights`, found here: their general forms would answer for others

GOALS = {
    "least squares": "counterweight for the least mean square of the force",
    "minimax": "counterweight for the least maximum of the force",
    "lanchester": "counter-rotating pair against the first harmonic",
    "lanchester 2": "pairs against the first and the second harmonic",
    "given": "your own weights",
}

WEIGHTS = Quantity("weights_{scheme}", "rotating weights of {scheme}")
LINK = Quantity("link", "link of a counterweight")
MASS = Quantity("mass[kg]", "mass of a counterweight")
X = Quantity("x[m]", "x of a counterweight in the axes of its link")
Y = Quantity("y[m]", "y of a counterweight in the axes of its link")


def summary(result: Balances, title: str, *, everything: bool = True) -> Document:
    """Facts and notes of all that is balanced, without the table of positions; ``everything`` is all in SI."""
    parts = tuple(_others(result, everything))
    if result.linkage is None:
        return replace(parts[0], title=title) if len(parts) == 1 else Document(title, parts=parts)
    found = result.linkage
    facts = (
        *_shaking_facts(found),
        *(_scheme_fact(found, scheme) for scheme in found.schemes),
        *_legend_facts(found),
        *([] if found.redistribution is None else _redistribution_facts(found, found.redistribution)),
        _error_fact(found.shaking.error),
    )
    return Document(title, facts, tuple(_notes(found)), parts=parts)


def _error_fact(error: float) -> Fact:
    return Fact("error of force (est.)", f"{error:.0e} (relative)", {"error": {"shaking": error}})


def document(
    result: Balances,
    title: str,
    *,
    patterns: Sequence[str] = (),
    rows: Sequence[int] | None = None,
    everything: bool = False,
    where: str = "",
) -> Document:
    """Summary, and of a linkage the table of positions, the sizes of forces first.

    ``patterns`` choose columns by name, header or wildcard, ``rows`` positions by index; ``everything`` takes all
    columns in their order (for csv, json, toml). ``where`` is the file that has them all. Raises `UsageError` for
    columns or rows without a linkage.
    """
    told = summary(result, title, everything=everything)
    if result.linkage is None:
        if patterns or rows is not None:
            text = "an engine and a rotor have no table of positions"
            raise UsageError(text, where="balance", remedy="leave --columns and --positions out")
        return told
    available = columns(result.linkage)
    usual = available if everything else _first(available)
    told = with_positions(
        told,
        result.labels,
        available,
        patterns,
        rows,
        usual=usual,
        example="phi,R,D_*",
        everything=everything,
        where=where,
    )
    assert told.table is not None
    return replace(told, table=replace(told.table, peaks=_peaks(told.table, result.linkage.shaking.scale)))


def _peaks(view: View, scale: float) -> list[float]:
    """What forces and moments are noise against: all inertia forces together, at an arm of a metre."""
    return [
        max(peak, scale) if header.endswith(("[N]", "[N*m]")) else peak
        for header, peak in zip(view.headers, view.peaks, strict=True)
    ]


def _others(result: Balances, everything: bool) -> Iterator[Document]:
    """The documents of an engine and of a rotor."""
    if result.engine is not None:
        from tmmcalc.machine.facts.engine import engine_document

        yield engine_document(result.engine, "engine")
    if result.rotor is not None:
        from tmmcalc.machine.facts.rotor import rotor_document

        yield rotor_document(result.rotor, "rotor", everything=everything)


def _first(available: list[Column]) -> list[Column]:
    """Position, sizes of the forces before and after, moments; then the components."""

    def rank(column: Column) -> int:
        sizes = column.name == "R" or column.name.startswith("D_")
        return 0 if column.name == "phi" else 1 if sizes else 2 if column.name.startswith("M_") else 3

    return sorted(available, key=rank)


def _force(result: Balancing, told: Quantity, size: Magnitude) -> tuple[str, dict[str, float]]:
    """A force for people and for programs."""
    phi = phi_at(result, size.at)
    text = size_text(size, told.unit, result.shaking.scale, f" at phi = {angle(phi)} deg")
    return text, size_values(size, told, "_phi", phi)


def _shaking_facts(result: Balancing) -> Iterator[Fact]:
    """The force and the moment of the inertia of all links, and the centroid of the hodograph. Textbook (3.71)."""
    found = result.shaking
    speed = f"{number(found.speed)} rad/s ({number(found.speed * 30 / math.pi)} rpm) of the input"
    yield Fact("taken at", speed, keyed(found, "speed"))
    text, values = _force(result, FORCE, found.size)
    yield Fact("shaking force R", text, values)
    text, values = moment(result, MOMENT, found.moment_size, placed=True)
    about = f"about {'the pivot of the crank' if found.about == found.pivot else _point(found.about)}"
    yield Fact("shaking moment M_R", f"{text}\n{about}", {**values, **keyed(found, "about_x", "about_y")})
    x0, y0 = found.mean_along, found.mean_across
    text = f"mean X0 = {number(x0, peak=found.scale)} N along the crank, Y0 = {number(y0, peak=found.scale)} N across"
    yield Fact("hodograph (3.74)", text, keyed(found, "mean_along", "mean_across"))


def _point(z: complex) -> str:
    x, y = (number(1e3 * value, peak=1e3 * abs(z)) for value in (z.real, z.imag))
    return f"({x}, {y}) mm"


def _scheme_fact(result: Balancing, scheme: Scheme) -> Fact:
    """The weights of a scheme as they are to be made, and what they leave."""
    balance, key = scheme.balance, scheme.name.replace(" ", "_")
    pairs = list(zip(balance.weights, scheme.weights, strict=True)) if scheme.weights else []
    lines = [GOALS[scheme.name], *(_weight_line(result, scheme, *pair) for pair in pairs)]
    if not pairs:
        lines.append("no weight: there is nothing of it to balance")
    left, values = _left(result, key, balance.before, balance.after)
    turning, more = moment_left(result, key, balance.moment_before, balance.moment_after)
    lines += [left, turning]
    weights = [_weight_values(scheme, *pair) for pair in pairs]
    named = WEIGHTS.of(scheme=key).value(weights) if weights else {}
    return Fact(scheme.name, "\n".join(lines), {**named, **values, **more})


def _left(result: Balancing, scheme: str, before: Magnitude, after: Magnitude) -> tuple[str, dict[str, Any]]:
    """What a scheme leaves of the force, and how many times less that is."""
    _, values = _force(result, LEFT.of(scheme=scheme), after)
    if after.largest <= NOISE * result.shaking.scale:
        return "leaves no force", values
    less_by = ratios("D", scheme, before, after)
    rms, largest = map(less, less_by.values())
    place = f"at phi = {angle(phi_at(result, after.at))} deg"
    text = f"leaves rms {number(after.rms)} N, {rms}\nmax {number(after.largest)} N {place}, {largest}"
    return text, {**values, **less_by}


def _weight_line(result: Balancing, scheme: Scheme, weight: RotatingWeight, made: Weight) -> str:
    """A weight for people; of those given only the static moment is known."""
    size = f"{number(abs(weight.moment), 5)} kg*m"
    if scheme.name != "given":
        size = f"{number(made.mass, 5)} kg * {number(1e3 * made.radius, 5)} mm = {size}"
    axis = "" if weight.axis == result.shaking.pivot else f", axis at {_point(weight.axis)}"
    return f"order {weight.order}, {direction(made.angle)} deg: {size}{axis}"


def _weight_values(scheme: Scheme, weight: RotatingWeight, made: Weight) -> dict[str, float]:
    sizes = {} if scheme.name == "given" else keyed(made, "mass", "radius")
    return {
        **keyed(weight, "order"),
        **sizes,
        **keyed(weight, "size"),
        **keyed(made, "angle[deg]"),
        **keyed(weight, "axis_x", "axis_y"),
    }


def _redistribution_facts(result: Balancing, found: Redistribution) -> Iterator[Fact]:
    """Counterweights on links, what they leave, and the links that could bear an exact balance."""
    lines = [
        f"link {body.link}: {number(body.mass, 5)} kg at {_point(body.center)} in its axes"
        for body in found.counterweights
    ]
    before, after = found.before.size, found.after.size
    left, values = _left(result, ON_LINKS, before, after)
    turning, more = moment_left(result, ON_LINKS, found.before.moment_size, found.after.moment_size)
    lines += [f"{number(found.added, 5)} kg in all", left, turning]
    bodies = [
        {LINK.key: b.link, MASS.key: b.mass, X.key: b.center.real, Y.key: b.center.imag} for b in found.counterweights
    ]
    own = {"counterweights": bodies, **keyed(found, "exact", "added")}
    yield Fact("counterweights", "\n".join(lines), {**own, **values, **more})
    sets = [list(some) for some in found.sufficient]
    text = " or ".join(" and ".join(map(str, some)) for some in sets) or "none: a link of some mass only slides"
    if sets == [[]]:
        text = "none is needed"
    yield Fact("links that suffice", text, {"sufficient_links": sets})


def _legend_facts(result: Balancing) -> list[Fact]:
    """How the weights are told."""
    if not any(scheme.weights for scheme in result.schemes):
        return []
    text = "speed of its shaft over that of the crank. Order 1 is on the crank, its angle is from the crank; "
    text += "that of others is from the x axis where the crank points along x"
    return [Fact("order of a weight", text)]


def _notes(result: Balancing) -> Iterator[str]:
    """What is to be known beside the numbers."""
    if result.schemes and not any(moved(scheme.balance) for scheme in result.schemes):
        yield "note: weights whose axes are at the pivot do not change the shaking moment"
    yield from raised(result)
    if result.shaking.acceleration:
        yield "note: the crank accelerates; the moments that its acceleration gives to the weights are left out"
    if result.redistribution is not None and not result.redistribution.exact:
        yield Phrase("note: {message}", message=result.redistribution.message)
