"""The chapter on forces: what acts on the links, then the groups from the last to the first, then the input link.

Friction stands among the given forces, as the last pass of the program found it; so the lines hold with it and without.
"""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.linkage.notes.statics.course import over_the_motion
from tmmcalc.linkage.notes.statics.drive import crank, input_pair, slider
from tmmcalc.linkage.notes.statics.dyad import dyad_pairs, dyad_reactions
from tmmcalc.linkage.notes.statics.figures import Cut
from tmmcalc.linkage.notes.statics.group import group_pairs, group_reactions
from tmmcalc.linkage.notes.statics.inertia import inertia
from tmmcalc.linkage.notes.statics.lever import lever
from tmmcalc.linkage.notes.statics.loaded import loaded_of
from tmmcalc.linkage.notes.statics.pairs import put_friction
from tmmcalc.linkage.notes.statics.passes import passes
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Heading, Paragraph


def blocks(order: Order) -> Iterator[Block]:
    """Inertia, every group from the last, the input link, all positions, the lever."""
    loaded = loaded_of(order)
    told, cut = loaded.told, Cut(loaded)
    dyads = {dyad.step.group.name: dyad for dyad in told.dyads}
    yield Paragraph(
        tr(
            "With the forces of inertia each link is in equilibrium. The groups are solved from the last to the "
            "first: the reactions that are found act with opposite signs on the links that carry the group. Moments "
            "and angles are positive counter-clockwise, projections along the axes; a minus before a result means "
            "that its sense is opposite to the positive one. The first index of a force is the link that it acts on, "
            "the second the link that it comes from. In the figures the links are to scale, the arrows of the forces "
            "on them are not; the polygons of forces are to the scale that stands above them."
        )
    )
    yield from inertia(loaded)
    groups = {}
    for plan in loaded.statics.plans:
        name = plan.group.name
        yield Heading(tr("Group {name}", name=name), 2)
        yield from cut.pictured(plan.group.links)
        dyad = dyads.get(name)
        groups[tr("group {name}", name=name)] = pairs = dyad_pairs(loaded, dyad) if dyad else group_pairs(loaded, plan)
        put_friction(loaded, pairs)
        yield from passes(loaded, plan, pairs)
        yield from dyad_reactions(loaded, dyad, pairs) if dyad else group_reactions(loaded, plan, pairs)
    if told.result.structure.driven is None:
        yield Heading(tr("Input link"), 2)
        yield from cut.pictured([told.result.structure.input_link])
        groups[tr("input link")] = pairs = [input_pair(loaded)]
        put_friction(loaded, pairs)
        yield from crank(loaded) if told.chain.turns else slider(loaded)
    yield from over_the_motion(loaded, groups)
    yield from lever(loaded)
