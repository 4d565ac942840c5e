"""What is wrong with a profile: refused where it cannot move the follower, else said with its place and size."""

from __future__ import annotations

from collections.abc import Iterator
from math import degrees, tau

from tmmcalc.cams.pivot import pivot_fault
from tmmcalc.cams.profile.results import Crossing, Place, Profile, Reach, Wall
from tmmcalc.cams.task import CamTask
from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.notes import Phrase, Said, held, listed

BASE_PART, BEND_PART = 0.4, 0.7  # the rule r2 <= min(0.4 R0, 0.7 rho_min)
AT_LIMIT = 1e-9  # relative
NARROW = 2e-4  # [rad] an interval whose ends differ in the last of six digits
NAMES = {
    "inner": "working profile",
    "outer": "second wall",
    "tool": "path of the tool",
    "outer tool": "path of the tool",
}


def refuse(found: Profile, task: CamTask) -> None:
    """Raise `NoSolutionError` for a cam that cannot work.

    A wall that turns back or crosses itself lets the follower leave its law; a cam over the pivot cannot turn.
    """
    for wall in (found.working, found.outer):
        if wall is None or wall.sound:
            continue
        reach = found.inner_reach if wall.name == "inner" else found.outer_reach
        raise NoSolutionError(
            f"the {NAMES[wall.name]} {fault(wall)}",
            where="cam profile",
            value=found.sharpest.value if found.flat else found.follower.roller,
            limit=0.0 if reach is None else reach.distance,
            remedy=_remedy(found, wall, task),
        )
    room = found.pivot
    if room is not None and room.swept:
        raise NoSolutionError(
            pivot_fault(room),
            where="cam profile",
            value=room.radius,
            limit=room.limit,
            remedy="a larger centre_distance, a smaller start_angle, stroke or rocker_length",
        )


def fault(wall: Wall) -> str:
    """What a wall does that it must not, at the worst place; the rest is counted."""
    said = []
    if wall.loops:
        longest = max(wall.loops, key=lambda each: each[1] - each[0])
        said.append(_rest(Phrase("is undercut: it runs backwards {over}", over=_over(*longest)), len(wall.loops)))
    if wall.crossings:
        worst = max(wall.crossings, key=_cut_off)
        first, second = _deg(worst.first), _deg(worst.second)
        text = Phrase("crosses itself at phi = {first} and {second} deg", first=first, second=second)
        said.append(_rest(text, len(wall.crossings)))
    return listed(said, ", and ") if said else "touches itself"


def _over(low: float, high: float) -> str:
    if high - low < NARROW:
        return Phrase("over {width:.2g} deg at phi = {phi} deg", width=degrees(high - low), phi=_deg(low))
    return Phrase("from phi = {low} to {high} deg", low=_deg(low), high=_deg(high))


def _cut_off(crossing: Crossing) -> float:
    """The angle that the follower loses to a crossing."""
    between = crossing.second - crossing.first
    return min(between, tau - between)


def _rest(text: str, count: int) -> str:
    """The text with how many lesser places there are."""
    if count == 1:
        return text
    more = "{text} and at {count} lesser places" if count > 2 else "{text} and at {count} lesser place"
    return Phrase(more, text=text, count=count - 1)


def _remedy(found: Profile, wall: Wall, task: CamTask) -> str:
    if found.flat:
        need = found.follower.start - found.sharpest.value
        with_margin = _mm(need + task.limits.convex)
        return f"a start_distance above {_mm(need)}, or {with_margin} for radii of {_mm(task.limits.convex)}"
    limit = found.inner_reach if wall.name == "inner" else found.outer_reach
    assert limit is not None
    return f"a roller_radius below {_mm(limit.distance)} ({_cause(limit)}), or a larger base circle"


def _cause(limit: Reach) -> str:
    places = listed([Phrase("{phi} deg", phi=_deg(phi)) for phi in limit.at], " and ")
    return Phrase("a point phi = {places}" if limit.cause == "cusp" else "a neck between phi = {places}", places=places)


def remarks(found: Profile, task: CamTask) -> Iterator[Said]:
    """Graded remarks: a limit that is not kept is a warning, a rule of thumb a note."""
    for wall in found.walls:
        if not wall.sound and not wall.name.endswith("tool"):
            yield Phrase("warning: the {wall} {fault}", wall=NAMES[wall.name], fault=fault(wall))
    if found.pivot is not None and found.pivot.swept:
        yield Phrase("warning: {fault}", fault=pivot_fault(found.pivot))
    if found.pivot is not None and found.pivot.passed:
        yield Phrase("note: {fault}", fault=pivot_fault(found.pivot))
    yield from _flat_remarks(found, task) if found.flat else _roller_remarks(found, task)
    yield from _concave_remarks(found, task)
    yield from _tool_remarks(found)
    shaft = task.limits.shaft
    if found.nearest.value < shaft * (1 - AT_LIMIT):
        text = (
            "the profile comes to {value:.6g} mm of the axis at phi = {phi} deg, "
            "the shaft has a radius of {limit:.6g} mm"
        )
        near, phi = found.nearest.value, _deg(found.nearest.phi)
        yield held("warning", text, near, shaft, "m", shown="mm", name="r_min", phi=phi)


def _flat_remarks(found: Profile, task: CamTask) -> Iterator[Said]:
    least, limit = found.sharpest, task.limits.convex
    if 0 <= least.value < limit * (1 - AT_LIMIT):
        text = (
            "the profile has a radius of {value:.6g} mm {at}, less than r_m = {limit:.6g} mm: "
            "S0 has to be at least {start}"
        )
        words = {"at": _at(least), "start": _mm(found.follower.start + limit - least.value)}
        yield held("warning", text, least.value, limit, "m", shown="mm", name="rho_min", **words)


def _roller_remarks(found: Profile, task: CamTask) -> Iterator[Said]:
    r2, limit = found.follower.roller, task.limits.convex
    yield from _wall_remarks(found.working, "the profile", found.inner_reach, found.sharpest, limit)
    if found.outer is not None:
        yield from _wall_remarks(found.outer, "the second wall", found.outer_reach, found.hollowest, limit)
    for part, size, name in ((BASE_PART, found.follower.base, "R0"), (BEND_PART, 1 / found.sharpest.value, "rho_min")):
        if r2 > part * size * (1 + AT_LIMIT):
            text = "the roller of {value:.6g} mm is above {part} {of} = {limit:.6g} mm, the usual rule"
            yield held("note", text, r2, part * size, "m", shown="mm", name="r2", part=part, of=name)


def _wall_remarks(wall: Wall, name: str, reach: Reach | None, place: Place | None, limit: float) -> Iterator[Said]:
    """A sound wall where it bulges most: the first where the pitch curve is convex, the second where it is concave."""
    r2 = abs(wall.distance)
    if wall.sound and reach is not None and r2 >= reach.distance * (1 - AT_LIMIT):
        yield Phrase(
            "warning: the roller is the largest that works, {distance} ({cause})",
            distance=_mm(reach.distance),
            cause=_cause(reach),
        )
    if not wall.sound or place is None:
        return
    bend = 1 / abs(place.value)
    if bend - r2 < limit * (1 - AT_LIMIT):
        text = "{wall} has a radius of {value:.6g} mm {at}, less than r_m = {limit:.6g} mm: the roller may have {most}"
        words = {"wall": name, "at": _at(place), "most": _mm(max(bend - limit, 0.0))}
        yield held("warning", text, bend - r2, limit, "m", shown="mm", name="rho_min", **words)


def _concave_remarks(found: Profile, task: CamTask) -> Iterator[Said]:
    """What r_i says of concave parts; a groove is milled by a tool no larger than its roller."""
    least, place = found.least_concave, found.hollowest
    if least is None or place is None:
        return
    if not task.limits.allow_concave:
        yield Phrase(
            "warning: the profile is concave, with a radius of {least} {at}, which is not allowed",
            least=_mm(least),
            at=_at(place),
        )
    elif least < task.limits.concave * (1 - AT_LIMIT) and found.tool_radius is None and found.outer is None:
        text = "concave parts have a radius of {value:.6g} mm {at}, less than r_i = {limit:.6g} mm of the tool"
        yield held("warning", text, least, task.limits.concave, "m", shown="mm", name="rho_concave", at=_at(place))


def _tool_remarks(found: Profile) -> Iterator[Said]:
    tool, most = found.tool, found.largest_tool
    if tool is None or tool.sound or most is None or found.tool_radius is None:
        return
    text = (
        "the tool of radius {value:.6g} mm cuts into the profile: its path {fault}; "
        "the largest tool that works has {limit:.6g} mm"
    )
    yield held("warning", text, found.tool_radius, most, "m", shown="mm", name="r_tool", fault=fault(tool))


def _at(place: Place) -> str:
    text = {-1: "just before phi = {phi} deg", 0: "at phi = {phi} deg", 1: "just after phi = {phi} deg"}[place.side]
    return Phrase(text, phi=_deg(place.phi))


def _deg(phi: float) -> str:
    return f"{degrees(phi % tau if phi > tau else phi):.6g}"


def _mm(length: float) -> str:
    return f"{1e3 * length:.6g} mm"
