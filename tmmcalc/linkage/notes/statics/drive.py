"""The input link: what the drive does, through a coupling, a mesh or along a guide, and the reaction of the frame."""

from __future__ import annotations

import math
from collections.abc import Iterator

from tmmcalc.linkage.loading import GearDrive
from tmmcalc.linkage.notes.statics.loaded import Loaded, moments, point_of, put_reaction, sums
from tmmcalc.linkage.notes.statics.pairs import ToldPair, arms, friction
from tmmcalc.linkage.notes.statics.slides import put_slide
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Paragraph
from tmmcalc.report.telling import named, vector


def crank(loaded: Loaded) -> Iterator[Block]:
    """The moment about the pivot, of the mesh its force, and the reaction there."""
    chain, gear = loaded.told.chain, loaded.loading.drive
    link, joint = loaded.told.result.structure.input_link, chain.input_joint
    pivot, own = point_of(loaded, joint.name), {joint.name}
    texts = [*sums(loaded, link, own), moments(loaded, [link], pivot, own)]
    for lexicon, each, row in zip(loaded.told.lexicons, loaded.bodies, loaded.rows, strict=True):
        lexicon["M_d"] = Given(float(loaded.result.drive[row]), "N*m", tr("balancing moment"))
        put_reaction(loaded, joint, link, each, lexicon)
    said = tr(
        "The moments of link {link} about {point} give the balancing moment, its forces the reaction of the frame.",
        link=link,
        point=pivot,
    )
    yield Paragraph(said)
    yield from loaded.lines([*texts, f"M_d = -M_{{{link}}}^{{{pivot}}}"])
    mesh = ""
    if isinstance(gear, GearDrive):
        yield from _mesh(loaded, gear)
        mesh = "F_{mesh,%}"
    yield from loaded.lines(
        [
            *(
                f"R_{{{link}0{axis}}} = -(T_{{{link}{axis}}}{mesh and f' + {mesh}'.replace('%', axis)})"
                for axis in "xy"
            ),
            f"R_{{{link}0}} = sqrt(R_{{{link}0x}}**2 + R_{{{link}0y}}**2)",
        ]
    )
    yield from friction(loaded, [input_pair(loaded)])


def _mesh(loaded: Loaded, gear: GearDrive) -> Iterator[Block]:
    """The force of the pinion along the line of action (3.14)."""
    mesh = loaded.result.mesh
    assert mesh is not None
    for lexicon, row in zip(loaded.told.lexicons, loaded.rows, strict=True):
        force = complex(mesh[row])
        lexicon |= named(
            {
                "r_w": Given(gear.radius, "m", tr("operating pitch radius of the wheel on the crank")),
                "alpha_w": Given(math.degrees(gear.mesh_angle), "deg", tr("operating pressure angle")),
                "beta": Given(math.degrees(gear.pinion), "deg", tr("direction from the pivot to the pinion")),
                "F_{mesh}": Given(abs(force), "N", tr("force of the mesh along the line of action")),
                **vector("F_{mesh,%}", force, "N", tr("force of the mesh along the line of action")),
            }
        )
    said = tr("The drive acts through the mesh of a gear: its force lies on the line of action and makes this moment.")
    if gear.open:
        said += " " + tr("Radius and angle are those of the open pair {pair}.", pair=gear.teeth)
    radial = "+" if gear.internal else "-"
    yield Paragraph(said)
    yield from loaded.lines(
        [
            "F_{mesh} = abs(M_d)/(r_w*cos(alpha_w))",
            f"F_{{mesh,%}} = {radial}F_{{mesh}}*sin(alpha_w)*cos(beta) - M_d*sin(beta)/r_w".replace("%", "x"),
            f"F_{{mesh,%}} = {radial}F_{{mesh}}*sin(alpha_w)*sin(beta) + M_d*cos(beta)/r_w".replace("%", "y"),
        ]
    )


def input_pair(loaded: Loaded) -> ToldPair:
    """The pair of the input link with the frame, its quantities entered where it is a guide."""
    link, joint = loaded.told.result.structure.input_link, loaded.told.chain.input_joint
    if joint.kind == "revolute":
        return ToldPair(joint, link)
    pair = ToldPair(joint, link, f"gamma_{{{link}0}}")
    return pair._replace(point=put_slide(loaded, pair, 1.0 if joint.links[0] == link else -1.0))


def slider(loaded: Loaded) -> Iterator[Block]:
    """A driven slider: the force along its guide, the normal reaction and its moment."""
    link, joint = loaded.told.result.structure.input_link, loaded.told.chain.input_joint
    own, pair = {joint.name}, input_pair(loaded)
    point = pair.point
    texts = [*sums(loaded, link, own), moments(loaded, [link], point, own)]
    for lexicon, row in zip(loaded.told.lexicons, loaded.rows, strict=True):
        lexicon["F_d"] = Given(float(loaded.result.drive[row]), "N", tr("balancing force"))
    said = tr(
        "The projections of the forces of link {link} on its guide give the balancing force, those across it the "
        "normal reaction.",
        link=link,
    )
    yield Paragraph(said)
    ij = pair.ij
    angle = f"gamma_{{{ij}}}"
    moment = f"M_{{{link}}}^{{{point}}}"
    yield from loaded.lines(
        [
            *texts,
            f"F_d = -T_{{{link}x}}*cos({angle}) - T_{{{link}y}}*sin({angle})",
            f"N_{{{ij}}} = T_{{{link}x}}*sin({angle}) - T_{{{link}y}}*cos({angle})",
            f"M_{{{ij}}}^{{{point}}} = -{moment}" if texts[-1] else "",
        ]
    )
    if texts[-1]:
        yield from arms(loaded, [pair])
    yield from friction(loaded, [pair])
