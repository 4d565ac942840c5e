"""Which assembly variant each dyad takes: given signs, or the nearest to a sketch.

The sign of RRR is +1 if the inner joint lies to the left of the line from the outer joint of the first link
to that of the second, in the order in which the spec names the two links; of RRP +1 ("right") if the slider's
pin lies ahead of the rod's outer pin in the direction of the guide; of RPR +1 if the slider's pivot lies
ahead of the guide link's pivot. PRP and RPP have one assembly only. Without a word in the spec it is +1.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import product

import numpy as np

from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.core.notes import Phrase
from tmmcalc.linkage.assemblies import own_points, tied
from tmmcalc.linkage.assembly import reach_of
from tmmcalc.linkage.chain import Chain, compile_chain
from tmmcalc.linkage.dyads import ONE_ASSEMBLY
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.results import Branch, Grade
from tmmcalc.linkage.structure import Group, Structure


def given_variants(mechanism: Mechanism, structure: Structure) -> dict[str, int]:
    """Signs by group name from ``assembly.variants``; raises `UsageError` for what names no dyad."""
    signs: dict[str, int] = {}
    for links, sign in mechanism.assembly.variants.items():
        key = f"mechanism.assembly.variants.{'-'.join(map(str, links))}"
        group = next((g for g in structure.groups if set(g.links) == set(links)), None)
        if group is None:
            known = ", ".join("-".join(map(str, g.links)) for g in structure.groups)
            raise UsageError(
                f"links {', '.join(map(str, links[:-1]))} and {links[-1]} are not a group of {structure.formula}",
                where=key,
                remedy=f"the groups are {known}",
            )
        if group.kind in ONE_ASSEMBLY and sign < 0:
            raise UsageError(
                f"{group.name} has one assembly only; -1 does not exist", where=key, remedy="remove the line"
            )
        reversed_order = group.kind == "RRR" and links != group.links
        signs[group.name] = -sign if reversed_order else sign
    return signs


def sketched_groups(mechanism: Mechanism, structure: Structure, given: Mapping[str, int]) -> list[Group]:
    """Dyads whose sign the sketch has to tell: two variants, none given, a sketched point that they place."""
    return [
        group
        for group in structure.groups
        if group.kind
        and group.kind not in ONE_ASSEMBLY
        and group.name not in given
        and not mechanism.assembly.sketch.keys().isdisjoint(own_points(mechanism, group))
    ]


def candidates(groups: list[Group], given: dict[str, int]) -> Iterator[dict[str, int]]:
    """All combinations of signs of these groups, each with the given signs."""
    for signs in product((1, -1), repeat=len(groups)):
        yield {**given, **{group.name: sign for group, sign in zip(groups, signs, strict=True)}}


def distance(chain: Chain, x: float) -> float:
    """Root mean square distance [m] of the sketch from this chain at the input coordinate x; inf if none."""
    with np.errstate(invalid="ignore"):
        motions = chain.evaluate(np.array([x]), order=0).motions
    gaps = [
        abs(motions[link.id].point(link.points[name]).r.item() - place)
        for name, place in chain.mechanism.assembly.sketch.items()
        for link in chain.mechanism.links
        if name in link.points
    ]
    total = float(np.sqrt(np.mean(np.square(gaps))))
    return total if np.isfinite(total) else np.inf


def nearest(found: list[tuple[float, dict[str, int]]], groups: list[Group]) -> dict[str, int]:
    """The signs of the nearest candidate; raises `NoSolutionError` if the sketch does not tell two apart."""
    found = sorted(found, key=lambda pair: pair[0])
    if not found or not np.isfinite(found[0][0]):
        names = ", ".join(group.name for group in groups)
        raise NoSolutionError(
            f"no assembly variant of {names} exists at the position of the sketch",
            where="kinematics, assembly.sketch",
            remedy="give assembly.at, the input coordinate of the sketch, or check the lengths",
        )
    if len(found) > 1 and tied(found[0][0], found[1][0]):
        differ = [g.name for g in groups if found[0][1][g.name] != found[1][1][g.name]]
        if any(g.kind != "RPR" for g in groups if g.name in differ):
            raise NoSolutionError(
                f"the sketch stands equally near to both variants of {', '.join(differ)}",
                where="kinematics, assembly.sketch",
                remedy="move a sketched point off the line of the pivots, or give assembly.variants",
            )
        return max(found[:2], key=lambda pair: sum(pair[1].values()))[1]
    return found[0][1]


def sketch_grades(
    mechanism: Mechanism, structure: Structure, signs: dict[str, int], branches: Mapping[str, Branch], at: float
) -> tuple[Grade, ...]:
    """What is odd about the sketch: far from the mechanism, against the given signs, or of no use."""
    if not mechanism.assembly.sketch:
        return ()
    where = "assembly.sketch"
    sketched = sketched_groups(mechanism, structure, {})
    if not sketched and not branches:
        text = "decides nothing: none of its points moves with a dyad that has two variants"
        return (Grade("note", where, text),)
    gap, size = distance(compile_chain(mechanism, structure, signs, branches), at), reach_of(mechanism)
    if not np.isfinite(gap):
        return (Grade("note", where, "was not compared: the mechanism does not assemble where it was read"),)
    grades = []
    if gap > size:
        text = Phrase(
            "lies {gap:.4g} m from the mechanism, whose points reach {size:.4g} m: are its units right?",
            gap=gap,
            size=size,
        )
        grades.append(Grade("warning", where, text, gap, size, "m", "distance"))
    for group in sketched:
        other = -signs[group.name]
        if distance(compile_chain(mechanism, structure, {**signs, group.name: other}, branches), at) < gap * (1 - 1e-6):
            text = Phrase(
                "stands nearer to the variant {other:+d} of {name}, which is not the one taken",
                other=other,
                name=group.name,
            )
            grades.append(Grade("warning", where, text))
    return tuple(grades)
