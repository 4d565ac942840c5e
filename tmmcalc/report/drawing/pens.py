"""The kinds of lines of a drawing: each has a meaning, and from it its width, dashes, colour and layer.

Widths follow the standards of drawings (ISO 128, GOST 2.303): thick lines of 0.7 mm, thin ones of a third to a half.
Colours are of a palette that the colour-blind tell apart, each with dashes of its own, so that a grey print reads too.
"""

from __future__ import annotations

from typing import NamedTuple

INK = "#1a1a1a"
WHITE = "#ffffff"
PLATE = "#dfe6ec"  # ternary and bigger links


class Pen(NamedTuple):
    """A kind of line; lengths in mm."""

    layer: str  # its meaning, as a layer of a CAD program is called
    width: float
    dashes: tuple[float, ...] = ()  # stroke, gap, ...; empty: continuous
    colour: str = INK


THICK = Pen("THICK", 0.7)
THIN = Pen("THIN", 0.25)
MIDDLE = Pen("MIDDLE", 0.35)
AXIS = Pen("AXIS", 0.25, (6.0, 1.5, 1.0, 1.5))
HIDDEN = Pen("HIDDEN", 0.35, (3.0, 1.2))
OTHER = Pen("OTHER_POSITIONS", 0.18, colour="#8a8a8a")
PATH = Pen("PATHS", 0.3, (4.0, 1.0, 0.7, 1.0), "#0072b2")
HATCH = Pen("HATCH", 0.18)
GRID = Pen("GRID", 0.13, colour="#cfcfcf")
DIMENSION = Pen("DIMENSIONS", 0.25)
FRAME = Pen("FRAME", 0.7)
BLOCK = Pen("TITLE_BLOCK", 0.25)
ZONES = Pen("ZONES", 0.35)
MARK = Pen("MARKS", 0.5, colour="#d55e00")
TEXT = Pen("TEXT", 0.25)

CURVES = tuple(
    Pen(f"CURVE_{k}", 0.4, dashes, colour)
    for k, (colour, dashes) in enumerate(
        (
            ("#0072b2", ()),
            ("#d55e00", (3.0, 1.2)),
            ("#009e73", (4.5, 1.0, 0.8, 1.0)),
            ("#cc79a7", (0.9, 0.9)),
            ("#56b4e9", (6.0, 1.2)),
            ("#e69f00", (3.0, 0.8, 0.8, 0.8, 0.8, 0.8)),
            ("#7a5195", (7.0, 1.4, 1.6, 1.4)),
            ("#6b6b6b", (2.0, 0.9)),
        ),
        1,
    )
)
VECTORS = {
    "absolute": Pen("VECTORS_ABSOLUTE", 0.5),
    "relative": Pen("VECTORS_RELATIVE", 0.35, (), "#0072b2"),
    "normal": Pen("VECTORS_NORMAL", 0.4, (3.0, 0.9), "#009e73"),
    "tangential": Pen("VECTORS_TANGENTIAL", 0.45, (2.0, 0.7, 0.7, 0.7), "#56b4e9"),
    "sliding": Pen("VECTORS_SLIDING", 0.5, (0.9, 0.8), "#cc79a7"),
    "coriolis": Pen("VECTORS_CORIOLIS", 0.45, (4.0, 0.9, 0.9, 0.9), "#d55e00"),
    "special": Pen("VECTORS_SPECIAL", 0.3, (6.0, 1.0, 1.0, 1.0), "#6b6b6b"),
}
FORCES = {
    "load": Pen("FORCES_LOAD", 0.7, (), "#d55e00"),
    "weight": Pen("FORCES_WEIGHT", 0.45, (3.0, 0.9), "#009e73"),
    "inertia": Pen("FORCES_INERTIA", 0.45, (4.0, 0.9, 0.9, 0.9), "#0072b2"),
    "spring": Pen("FORCES_SPRING", 0.45, (2.0, 0.7, 0.7, 0.7), "#e69f00"),
    "damper": Pen("FORCES_DAMPER", 0.45, (2.0, 0.7), "#56b4e9"),
    "drive": Pen("FORCES_DRIVE", 0.55, (6.0, 1.0), "#7a5195"),
    "reaction": Pen("FORCES_REACTION", 0.5),
    "friction": Pen("FORCES_FRICTION", 0.55, (0.9, 0.8), "#cc79a7"),
}
PENS = (
    *(THICK, MIDDLE, THIN, AXIS, HIDDEN, OTHER, PATH, HATCH, GRID, DIMENSION, FRAME, BLOCK, ZONES, MARK, TEXT),
    *CURVES,
    *VECTORS.values(),
    *FORCES.values(),
)
