"""The Assur groups drawn apart, in the order of assembly: links with their numbers, joints, class, order and kind."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

from tmmcalc.linkage.freebody import FreeBody
from tmmcalc.linkage.pictures.bodies import bodies
from tmmcalc.linkage.pictures.cycle import LinkageMotion
from tmmcalc.linkage.pictures.loaddiagram import draw_load_diagram, scale_in
from tmmcalc.linkage.pins import find_pins
from tmmcalc.linkage.structure import ROMAN, Group, Structure
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.lettering import width
from tmmcalc.report.drawing.scales import scale_text
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.language import tr

NAME = 16.0  # room of the name of a group, its class and scale [mm]
LEAST = 50.0  # width and height of a picture beside others, if they can have it [mm]
MARGIN = 7.0  # free border of a group [mm]
GAP = 4.0  # between pictures [mm]


def cells(box: Box, count: int, scales: Callable[[list[Box]], Sequence[float]]) -> list[Box]:
    """The rooms of so many pictures in a rectangle, row by row, in which they have the largest scales together."""
    ways = []
    for columns in range(1, count + 1):
        lines = box.split(*[1.0] * math.ceil(count / columns), gap=GAP)
        rooms = [cell for line in lines for cell in line.split(*[1.0] * columns, gap=GAP, across=True)][:count]
        ways.append((min(min(room.width, room.height) for room in rooms), rooms))
    large = [rooms for low, rooms in ways if low > LEAST] or [max(ways, key=lambda way: way[0])[1]]
    return min(large, key=lambda rooms: sum(map(math.log, scales(rooms))))


def draw_groups(drawing: Drawing, box: Box, structure: Structure, motion: LinkageMotion, cycle: LinkageMotion) -> None:
    """Draw the mechanism of class I and the groups in a rectangle."""
    larger = drawing.letters
    free = [FreeBody(group.name, group.links, (), ()) for group in structure.groups]
    classes = [_class_of(group) for group in structure.groups]
    if not structure.driven:
        free.insert(0, FreeBody(f"I(0,{structure.input_link})", (structure.input_link,), (), ()))
        classes.insert(0, tr("mechanism of class I"))

    def room(place: Box) -> Box:
        return place.inset(0, 0, 0, NAME * larger)

    def scales(places: list[Box]) -> list[float]:
        return [scale_in(room(place), body, motion, cycle, MARGIN) for place, body in zip(places, free, strict=True)]

    for place, body, told in zip(cells(box, len(free), scales), free, classes, strict=True):
        mu = draw_load_diagram(drawing, room(place), body, motion, cycle, MARGIN * larger)
        lines = f"{body.name}\n{told}\n{scale_text(mu)}"
        height = 2.5 * larger * min(1.0, place.width / width(lines, 2.5 * larger))
        drawing.add(Words(complex(place.middle.real, place.top), lines, height, 1j))
        board = drawing.fields[-1]
        assert isinstance(board, Board)
        _number_links(board, body, motion, cycle)


def _class_of(group: Group) -> str:
    roman = ROMAN.get(group.class_number, str(group.class_number))
    if group.kind:
        return tr("class {roman}, order {order}, kind {kind}", roman=roman, order=group.order, kind=group.kind)
    return tr("class {roman}, order {order}", roman=roman, order=group.order)


def _number_links(board: Board, body: FreeBody, motion: LinkageMotion, cycle: LinkageMotion) -> None:
    mechanism = motion.chain.mechanism
    for shape in bodies(mechanism, find_pins(mechanism), cycle, 0.0):
        if shape.link in body.links:
            corners = shape.corners or (0j,)
            longest = max(shape.segments, key=lambda s: abs(s[1] - s[0]), default=(corners[0], corners[0]))
            ends = [complex(motion.place(shape.link, p)[0]) for p in longest]
            anchors = [ends[0] + t * (ends[1] - ends[0]) for t in (0.5, 0.35, 0.65, 0.2, 0.8)]
            board.labels.put(str(shape.link), board.paper(anchors), height=2.0, ring=True, gaps=(0.6, 1.4, 2.4, 3.6))
