"""Checks of the pairs of a train: what the train gives itself, which mesh an entry is about, its rack."""

from __future__ import annotations

import math
from collections.abc import Iterator

from tmmcalc.gears.involute.rack import RACKS
from tmmcalc.gears.scheme import Layout
from tmmcalc.gears.tables.checks.train import written_layouts
from tmmcalc.gears.tables.checks.written_pair import Written, entries, is_of_train, mesh_name, written_pairs
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, subtable, word
from tmmcalc.spec.phrases import Path, did_you_mean, listing, show
from tmmcalc.spec.values import amount

# What a train gives to its pairs.
_GIVEN = {
    "teeth": "the train gives the numbers of teeth",
    "module": "strength gives the modules",
    "kind": "the layout says which wheels are rings",
    "name": "its pairs are called by their meshes",
}
_OF_ONE_MESH = ("x1", "x2", "tip_diameters", "span_teeth", "ball_diameters")
_CHOOSING = ("max_contact_strength", "equal_sliding", "max_contact_ratio", "equal_strength", "balanced")
_SAME = 1e-9  # by which two ways to write an angle may differ


def check_train(outline: Outline) -> Iterator[Finding]:
    """A train has modules, and gives its pairs what they need."""
    if not is_of_train(outline):
        return
    if "strength" not in outline.document:
        rule = "[pair] without [strength]: the pairs of a train have the modules that strength gives"
        remedy = "add [strength] with torque and material, or write pairs by themselves: teeth and module in [pair]"
        yield Finding(("pair",), rule, remedy)
    pairs = written_pairs(outline)
    for pair in pairs:
        for key in (each for each in _GIVEN if each in pair.own):
            yield Finding((*pair.path, key), f"{key} of the pairs of a train: {_GIVEN[key]}", "remove it")
        yield from _check_cutter(pair)
    for usual in pairs[:1]:
        yield from _check_usual(usual, written_layouts(subtable(outline.document, "train")))
    yield from _check_meshes(outline)
    yield from _check_common(pairs, written_layouts(subtable(outline.document, "train")))
    yield from dict.fromkeys(finding for pair in pairs for finding in _check_rack(pair))


def _shares(layout: Layout) -> bool:
    """Whether all its meshes have one centre distance."""
    return layout.branched and not layout.paired


def _check_cutter(pair: Written) -> Iterator[Finding]:
    if "tip_diameter" in subtable(pair.own, "cutter"):
        rule = "tip_diameter of a cutter in a train, whose modules are not known yet"
        yield Finding((*pair.path, "cutter", "tip_diameter"), rule, "remove it: it follows from teeth and shift")


def _check_usual(usual: Written, found: list[Layout]) -> Iterator[Finding]:
    """What differs from wheel to wheel stands with its mesh."""
    remedy = 'write it in [[pair.meshes]] with mesh = "1-2", for example'
    for key in _OF_ONE_MESH:
        if key in usual.own:
            yield Finding(("pair", key), f"{key} is that of one mesh, a train has several", remedy)
    if "centre_distance" in usual.own and found and not any(map(_shares, found)):
        rule = f"layout {listing(layout.key for layout in found)} has no common centre distance"
        yield Finding(("pair", "centre_distance"), rule, remedy)


def _check_meshes(outline: Outline) -> Iterator[Finding]:
    """Every entry names a mesh of the train that no other names."""
    found = written_layouts(subtable(outline.document, "train"))
    known = list(dict.fromkeys(mesh_name(mesh) for layout in found for mesh in layout.meshes))
    taken: list[str] = []
    for index, entry in entries(outline):
        path: Path = ("pair", "meshes", index)
        name = word(entry, "mesh")
        if "mesh" not in entry:
            yield Finding(path, "missing key: an entry says which mesh of the train it is about", 'add mesh = "1-2"')
        elif name in taken:
            yield Finding((*path, "mesh"), f"mesh {show(name)} has an entry already", "write all its keys in one")
        elif name and known and name not in known:
            guess = did_you_mean(name, known)
            rule = f"the train has no mesh {show(name)}"
            yield Finding((*path, "mesh"), rule, f"{guess} meshes: {listing(known)}".strip())
        taken += [name] if name else []


def _check_common(pairs: list[Written], found: list[Layout]) -> Iterator[Finding]:
    """The first mesh around a common axis settles the centre distance of the others; pairs of planets keep theirs."""
    if not found or not all(layout.branched for layout in found):
        return
    first = {mesh_name(layout.meshes[0]) for layout in found if _shares(layout)}
    for pair in pairs:
        chosen = word(pair.own, "strategy")
        settling = first and ("mesh" not in pair.own or word(pair.own, "mesh") in first)
        if chosen in _CHOOSING and not settling:
            rule = f'"{chosen}" would choose another centre distance than the train has here'
            other = f", or set it in the mesh {listing(sorted(first))}" if first else ""
            yield Finding(pair.at("strategy"), rule, f'write strategy = "given_aw"{other}')


def _check_rack(pair: Written) -> Iterator[Finding]:
    """The teeth were sought for the rack of the train."""
    rack = RACKS.get(word(pair.keys, "rack"), pair.rack)
    angle = amount(pair.keys.get("pressure_angle", rack.angle), "angle")
    addendum = amount(pair.keys.get("addendum", rack.addendum))
    if angle is not None and abs(angle - pair.rack.angle) > _SAME:
        own, of_train = (f"{math.degrees(each):.6g} deg" for each in (angle, pair.rack.angle))
        yield _other_rack(pair, "pressure_angle", own, of_train)
    if addendum is not None and abs(addendum - pair.rack.addendum) > _SAME:
        yield _other_rack(pair, "addendum", f"{addendum:g}", f"{pair.rack.addendum:g}")


def _other_rack(pair: Written, key: str, own: str, of_train: str) -> Finding:
    place = key if key in pair.keys else "rack"
    noun = "a pressure angle" if key == "pressure_angle" else "an addendum"
    rule = f"{noun} of {own}, the teeth of the train are sought for {of_train}"
    value = f'"{own}"' if key == "pressure_angle" else own
    return Finding(pair.at(place), rule, f"remove it, or write {key} = {value} in [train]")
