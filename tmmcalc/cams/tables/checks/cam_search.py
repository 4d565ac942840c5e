"""Checks of the search for the lowest mechanism in ``[cam.optimum]``, and of the options of its design game."""

from __future__ import annotations

from collections.abc import Iterator
from math import prod

from tmmcalc.cams.tables.checks.written_cam import place, written_cam
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline
from tmmcalc.spec.phrases import listing, show
from tmmcalc.spec.values import amounts

# What the search for the lowest mechanism needs: without them nothing holds the guide, and the roller.
_GUIDED = (("loads", "mass"), ("guide", "stem_radius"), ("guide", "land"), ("requirements", "guide_pressure"))
_TURNED = (("loads", "inertia"),)
_ROLLING = (("requirements", "width"), ("requirements", "contact"))
_OPTIONS = ("laws", "safeties", "contacts", "roller_ratios")
MOST_OPTIONS = 60  # mechanisms in one design game; a test holds it to that of the search


def check_optimum(outline: Outline) -> Iterator[Finding]:
    """The search has what its constraints need; heights run upwards."""
    cam = written_cam(outline)
    optimum = cam.part("optimum")
    if cam.has("optimum") and cam.kind:
        pinned = cam.kind == "flat" or "pin_pressure" in cam.part("requirements")
        held = _TURNED if cam.kind == "oscillating" else _GUIDED
        needed = held if pinned else (*held, *_ROLLING)
        known = {("requirements", "contact")} if "material" in cam.part("requirements") else set()
        absent = [
            f"{key} in [cam.{part}]" for part, key in needed if key not in cam.part(part) and (part, key) not in known
        ]
        if absent:
            what = "cam and roller" if cam.kind == "oscillating" else "guide and roller"
            rule = f"[cam.optimum] without what holds the sizes: {what} would become as small as you please"
            yield Finding(place("optimum"), rule, f"add {listing(absent)}")
    for key, what in (("heights", "height"), ("centre_distances", "distance"), ("rocker_lengths", "length")):
        ends = amounts(optimum.get(key), "length")
        if ends is None or len(ends) != 2 or ends[0] < ends[1] or (ends[0] == ends[1] and key == "rocker_lengths"):
            continue
        rule = f"{show(optimum[key])} runs backwards"
        yield Finding(place("optimum", key), rule, f"write the smaller {what} first")


def check_game(outline: Outline) -> Iterator[Finding]:
    """The options of the design game differ, change something, and are not too many together."""
    cam = written_cam(outline)
    optimum, needs = cam.part("optimum"), cam.part("requirements")
    counts = []
    for key in _OPTIONS:
        written = optimum.get(key)
        listed = [each for each in written if isinstance(each, str | float | int)] if isinstance(written, list) else []
        counts.append(len(written) if isinstance(written, list | dict) else 0)
        twice = next((each for k, each in enumerate(listed) if each in listed[:k]), None)
        if twice is not None:
            yield Finding(place("optimum", key), f"{show(twice)} is named twice", "remove one of them")
    if "roller_ratios" in optimum and cam.kind == "flat":
        yield Finding(place("optimum", "roller_ratios"), "roller_ratios of a flat face: it has no roller", "remove it")
    elif "roller_ratios" in optimum and not {"pin", "pin_pressure"} & {*needs}:
        rule = "roller_ratios without what the pin needs: the roller may be as small as you please"
        yield Finding(place("optimum", "roller_ratios"), rule, "add pin_pressure or pin in [cam.requirements]")
    if "contacts" in optimum and "width" not in needs:
        rule = "contacts without the width of the line of contact: there is no contact stress"
        yield Finding(place("optimum", "contacts"), rule, "add width in [cam.requirements]")
    if "contacts" in optimum and "material" in needs:
        rule = "contacts together with material: they are allowed stresses of other materials than one that is given"
        yield Finding(place("requirements", "material"), rule, "write contact, its allowed stress, in its place")
    together = prod(count + 1 for count in counts) if optimum.get("combine") is True else 1 + sum(counts)
    if together > MOST_OPTIONS:
        rule = f"{together} mechanisms with what is asked are too many, at most are {MOST_OPTIONS}"
        remedy = "name fewer options" + (", or combine = false" if optimum.get("combine") is True else "")
        yield Finding(place("optimum"), rule, remedy)


CHECKS = (check_optimum, check_game)
