"""The documents of the cam's forces: spring, guide, extremes, jamming, loss of contact, work, the table of rows."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import degrees, pi

from tmmcalc.cams.facts.rows import with_further, with_rows
from tmmcalc.cams.follower import along
from tmmcalc.cams.forces.columns import force_columns
from tmmcalc.cams.forces.results import CamForces, ForceExtreme, Governing, SpringFound, WireSize
from tmmcalc.core.columns import Column
from tmmcalc.core.quantity import keyed
from tmmcalc.report.document import Document, Fact, angles_in_degrees
from tmmcalc.report.numbers import angle, number
from tmmcalc.report.sizes import quantity

LAST = ("P_in", "M_in", "Q", "M_spring", "M_Q", "mu", "q")  # columns that stand behind what is asked first
VERDICTS = {"ok": "the follower stays on the cam and moves freely", "loss_of_contact": "the follower leaves the cam"}
METHODS = {
    "none": "none",
    "given": "given",
    "safety": "by the safety of the contact (5.54 to 5.57)",
    "preload": "by the tangent to the force that lifts off",
}


def summary(result: CamForces, title: str) -> Document:
    """Facts and warnings without the table."""
    return angles_in_degrees(Document(title, tuple(_facts(result)), result.notes))


def document(
    result: CamForces,
    title: str,
    *,
    patterns: Sequence[str] = (),
    rows: Sequence[int] | None = None,
    everything: bool = False,
    where: str = "",
    further: Sequence[Column] = (),
) -> Document:
    """All facts and the table, its columns chosen by ``patterns``, its rows by index; ``everything`` is all in SI.

    ``where`` is the file that has the whole table, ``further`` are columns that are printed by name alone.
    """
    columns = force_columns(result)
    if not everything and not patterns:
        columns = dict(sorted(columns.items(), key=lambda column: column[0].startswith(LAST)))
    told, ends = summary(result, title), [degrees(end) for end in result.ends]
    chosen = with_further(columns, patterns, further)
    return with_rows(told, chosen, patterns, rows, ends=ends, everything=everything, example="phi,R,T", where=where)


def _facts(result: CamForces) -> Iterator[Fact]:
    yield Fact("verdict", VERDICTS[result.verdict], keyed(result, "verdict") | keyed(result.spring, "method"))
    text = f"{number(result.speed)} rad/s ({number(result.speed * 30 / pi)} rpm)"
    yield Fact("speed of the cam", text, keyed(result, "speed"))
    yield from _spring_facts(result)
    if result.guide is not None:
        guide = result.guide
        heights = f"edges at H1 = {quantity(guide.lower, 'm')} and H2 = {quantity(guide.top, 'm')}"
        text = f"l = {quantity(guide.length, 'm')}, {heights}"
        yield Fact("guide", text, keyed(guide, "lower", "top", "length"))
    for extreme in result.extremes:
        yield _extreme_fact(extreme)
    yield _reserve_fact(result)
    if result.closure == "groove" or result.lost:
        yield _contact_fact(result)
    yield from _work_facts(result)


def _spring_facts(result: CamForces) -> Iterator[Fact]:
    found, turns = result.spring, result.follower.kind == "oscillating"
    if found.method == "none" or not (found.stiffness or found.preload):
        yield Fact("spring", "none", keyed(found, "stiffness", "preload", **along(turns)))
        return
    places = along(turns)
    force, letter = places["force"], places["spring"]
    lines = [
        f"{METHODS[found.method]}: c = {_stiffness(found.stiffness, turns)}",
        f"{letter}0 = {number(found.preload)} {force} at the lowest, {number(found.highest)} {force} at the highest",
    ]
    yield Fact("spring", "\n".join(lines), keyed(found, "stiffness", "preload", "highest", **places))
    if found.lifting is None:
        yield Fact("lifting force", "none: nothing lifts the follower off")
    elif found.phi is not None and found.lift is not None:
        yield _lifting_fact(found, turns)
    if found.governing is not None:
        yield _governing_fact(found.governing, turns, force)
    if found.reached is not None and found.reached_phi is not None:
        asked = "" if found.asked is None else f", asked K1 = {number(found.asked)}"
        text = f"{number(found.reached)} at phi = {angle(degrees(found.reached_phi))} deg{asked}"
        values = keyed(found, "asked", "reached", "reached_phi[deg]")
        if found.exact is not None:
            text += f"\nc = {_stiffness(found.exact, turns)} keeps it all over the turn"
            values |= keyed(found, "exact", **places)
        yield Fact("safety of the contact", text, values)
    if found.wire is not None:
        wire = found.wire
        text = (
            f"D/d = {number(wire.index, 5)}, {number(wire.coils, 5)} working coils, k_w = {number(wire.factor, 5)}\n"
            f"tau from {quantity(wire.stress_low, 'Pa')} to {quantity(wire.stress, 'Pa')}"
        )
        yield Fact("wire of the spring", text, keyed(wire, "coils", "factor", "stress", "stress_low"))
    if found.sizes:
        yield Fact(
            "springs by D/d", "\n".join(map(_size, found.sizes[::2])), {"springs": list(map(keyed, found.sizes))}
        )


def _size(spring: WireSize) -> str:
    """A spring that has the allowed stress at the highest position."""
    wire, solid, free = (number(1e3 * size, 4) for size in (spring.wire, spring.solid, spring.free))
    return f"{spring.index:g}: d = {wire}, n = {number(spring.coils, 4)}, height {solid} solid, {free} free"


def _stiffness(value: float, turns: bool) -> str:
    return f"{number(value)} N*m/rad" if turns else f"{number(1e-3 * value)} N/mm"


def _lifting_fact(found: SpringFound, turns: bool) -> Fact:
    """The force that the spring has to beat, and where."""
    lift, phi, value = found.lift or 0.0, found.phi or 0.0, found.lifting or 0.0
    places = along(turns)
    values = keyed(found, "lifting", "lift", "phi[deg]", **places)
    letter, place, _ = (key.partition("[")[0] for key in values)
    shown = f"{angle(degrees(lift))} deg" if turns else quantity(lift, "m")
    text = f"{letter} = {number(value)} {places['force']} on the {found.phase}"
    text += f", {place} = {shown}, phi = {angle(degrees(phi))} deg"
    return Fact("lifting force" if value > 0 else "place of the tangent", text, values)


def _governing_fact(found: Governing, turns: bool, force: str) -> Fact:
    """The phase that the spring is stiff for, and what the textbook's rule would give."""
    shown = f"{angle(degrees(found.lift))} deg" if turns else quantity(found.lift, "m")
    text = (
        f"by the {found.phase}: {number(found.force)} {force} at {shown}, phi = {angle(degrees(found.phi))} deg\n"
        f"by the largest force alone (5.57): c = {_stiffness(found.rule, turns)}"
    )
    return Fact("stiffness", text, keyed(found, "phase", "rule", "phi[deg]", **along(turns)))


def _extreme_fact(extreme: ForceExtreme) -> Fact:
    lines = []
    peak = extreme.size
    pairs = (("min", extreme.least, extreme.least_phi), ("max", extreme.largest, extreme.largest_phi))
    for word, value, phi in pairs:
        lines.append(f"{word} {number(value, peak=peak)} {extreme.unit} at phi = {angle(degrees(phi))} deg")
    labels = {
        "P_c": "resultant P_c", "M_c": "resultant M_c", "R": "force of the cam R", "N1": "lower edge N1",
        "N2": "upper edge N2", "T": "torque on the cam T", "M_drive": "driving torque",
    }  # fmt: skip
    ends = ("least", "least_phi[deg]", "largest", "largest_phi[deg]")
    values = keyed(extreme, *ends, name=extreme.name, unit=extreme.unit)
    return Fact(labels[extreme.name], "\n".join(lines), values)


def _reserve_fact(result: CamForces) -> Fact:
    """How near the follower is to jamming."""
    reserve = result.reserve
    values = keyed(reserve, "eaten", "phi[deg]", "critical[deg]")
    if not reserve.eaten:
        return Fact("jamming", "none: nothing rubs", values)
    text = f"friction takes at most {number(100 * reserve.eaten, 4)} % at phi = {angle(degrees(reserve.phi))} deg"
    if reserve.critical is not None:
        theta, critical = angle(degrees(abs(reserve.theta))), angle(degrees(reserve.critical))
        text += f"\nthere |theta| = {theta} deg, critical {critical} deg"
    elif result.follower.kind == "flat":
        text += f"\nthere 2 f S'/l = {number(reserve.eaten, 6)}, limit 1"
    return Fact("jamming", f"none: {text}", values)


def _contact_fact(result: CamForces) -> Fact:
    if result.lost:
        text = "\n".join(f"lost for phi from {angle(degrees(a))} to {angle(degrees(b))} deg" for a, b in result.lost)
    elif result.reversals:
        text = "the roller changes the wall at phi = "
        text += ", ".join(angle(degrees(phi)) for phi in result.reversals) + " deg"
    else:
        text = "on one wall all over the turn"
    return Fact("contact", text, keyed(result, "lost[deg]", "reversals[deg]"))


def _work_facts(result: CamForces) -> Iterator[Fact]:
    work = result.work
    text = (
        f"{number(work.driving)} J a turn: {number(work.given)} J given, {number(abs(work.returned))} J back\n"
        f"friction takes {number(work.friction)} J, the technological force gives {number(work.force)} J\n"
        f"mean torque {number(work.mean)} N*m, mean power {number(work.power)} W"
    )
    yield Fact("work of the camshaft", text, keyed(work))
    yield Fact("error of its balance", f"{work.error:.1e}")
