"""The pictures of what is cut out: its load diagram beside its force polygon."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from tmmcalc.linkage.forces.results import side_of
from tmmcalc.linkage.freebody import FreeBody, cleared, free_bodies
from tmmcalc.linkage.notes.statics.loaded import Loaded
from tmmcalc.linkage.pictures.cutting import NAME, SEEN, draw_body
from tmmcalc.linkage.pictures.cycle import motion_at, whole_cycle
from tmmcalc.linkage.pictures.forcepolygon import draw_force_polygon
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Figure, Paragraph
from tmmcalc.report.telling import WIDE, located

HIGH = 64.0  # of a picture [mm]
PARTS = (0.8, 1.0)  # of the load diagram and the polygon, which may have details beside it


class Cut:
    """The mechanism cut to free bodies at the first of the shown positions."""

    def __init__(self, loaded: Loaded) -> None:
        row, chain = loaded.rows[0], loaded.told.chain
        theta, side = float(loaded.result.theta[row]), side_of(loaded.result, row)
        self.bodies = cleared(free_bodies(loaded.statics, theta, side), SEEN)
        self.motion = motion_at(chain, loaded.statics.scene.travel.x(loaded.result.theta[[row]]))
        self.cycle = whole_cycle(chain, loaded.told.result)
        self.place = loaded.told.there(0)

    def pictured(self, links: Sequence[int]) -> Iterator[Block]:
        """The picture of each body of these links."""
        own = [body for body in self.bodies if set(body.links) <= set(links)]
        figures = [self._figure(body, f"forces_body_{body.links[0]}") for body in own]
        where = located(figures)
        yield Paragraph(
            tr("The forces on each link, with their closed polygon, are {where}.", where=where)
            if len(figures) > 1
            else tr("The forces on what is cut out, with their closed polygon, are {where}.", where=where)
        )
        yield from figures

    def _figure(self, body: FreeBody, key: str) -> Figure:
        def draw(drawing: Drawing, box: Box) -> None:
            left, right = box.split(*PARTS, gap=4.0, across=True)
            draw_body(drawing, left, body, self.motion, self.cycle)
            draw_force_polygon(drawing, right.inset(0, 0, 0, NAME), body, None)

        caption = (
            tr("Forces on link {link} and their polygon {place}", link=body.links[0], place=self.place)
            if len(body.links) == 1
            else tr("Forces on group {name} and their polygon {place}", name=body.name, place=self.place)
        )
        return Figure(caption, draw, (WIDE, HIGH), key)
