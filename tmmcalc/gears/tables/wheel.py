"""``[wheel]``: a gear without a mate, external or a ring: its tool, its limits, what is measured on it."""

from typing import Annotated

from pydantic import Field

from tmmcalc.gears.tables.teeth import (
    POINTS,
    TEETH,
    Addendum,
    Body,
    Clearance,
    CutterTable,
    Fillet,
    Helix,
    Length,
    Module,
    Points,
    RackAngle,
    RackName,
    Shift,
    Thickness,
    TipRadius,
    Undercut,
    WidthRule,
)
from tmmcalc.spec.choices import Known, Listed, Whole, Within
from tmmcalc.spec.identifiers import Words
from tmmcalc.spec.table import Table

WheelName = Annotated[str, Words("wheel")]
WheelKind = Annotated[str, Known("kind of wheel", ("external", "internal"))]
WheelTeeth = Annotated[int, Whole("a number of teeth", *TEETH)]
WheelSpan = Annotated[int, Whole("a number of teeth", 2, TEETH[1])]
Circles = Annotated[list[float], Listed(Within("length", "mm", 1e-3, 1e-3, 1e5, bare=2.0), '["72 mm", "78 mm"]')]


class WheelTable(Table):
    """A wheel by itself: teeth, module, shift, tool, limits, what is measured."""

    name: WheelName = Field(default="1", description="Name of the wheel in titles and files.")
    kind: WheelKind = Field(default="external", description='`"external"`, or `"internal"`: a ring.')
    teeth: WheelTeeth = Field(description="Number of teeth.")
    module: Module = Field(description="Module in the normal section.")
    x: Shift = Field(default=0.0, description="Shift in modules; of a ring positive towards the tips of its teeth.")
    helix_angle: Helix = Field(
        default=0.0, description="Helix angle on the reference cylinder; the hand, its sign, does not matter."
    )
    rack: RackName = Field(
        default="GOST 13755",
        description='Basic rack that cuts the wheel: `"GOST 13755"`, or `"ISO 53 A"`, `"ISO 53 B"`, `"ISO 53 C"`, '
        '`"ISO 53 D"`, `"AGMA 14.5"`, `"stub 20"`.',
    )
    pressure_angle: RackAngle | None = Field(
        default=None, description="Pressure angle of the rack in the normal section (default: of the rack)."
    )
    addendum: Addendum | None = Field(
        default=None, description="Addendum of the rack in the normal section, in modules (default: of the rack)."
    )
    clearance: Clearance | None = Field(
        default=None,
        description="Radial clearance of the rack in the normal section, in modules (default: of the rack).",
    )
    tip_radius: TipRadius | None = Field(
        default=None,
        description="Radius of the rounding of the rack's tips in the normal section, in modules (default: "
        "of the rack).",
    )
    cutter: CutterTable | None = Field(
        default=None,
        description='The shaper that cuts a ring, `{ teeth = 25, shift = 0.1, rounding = 0.1, tip_diameter = "84 mm" '
        "}` (default: the ring is as deep as the rack).",
    )
    tip_diameter: Length | None = Field(
        default=None,
        description="Diameter of the tip circle (default: of teeth as high as the rack's, not shortened for a mate).",
    )
    face_width: Length | None = Field(default=None, description="Face width, for the limits of spans.")
    fillet: Fillet = Field(
        default="ellipse",
        description='Section of the rack\'s rounding across helical teeth: `"ellipse"`, exact, or `"circle"`, as '
        "the textbook has it.",
    )
    undercut: Undercut = Field(
        default="tolerated", description='`"none"`: undercut is a fault; `"tolerated"`: it is warned of.'
    )
    tip_thickness_min: Thickness = Field(
        default=0.0, description="Least thickness of the tips, in modules, below which the wheel fails."
    )
    tip_thickness_wanted: Thickness = Field(
        default=0.25, description="Thickness of the tips below which is warned, in modules; 0.4 of hardened teeth."
    )
    span_teeth: WheelSpan | None = Field(
        default=None,
        description="Teeth that the span is measured over, two or more (default: z_w,max, the most that the rule "
        "admits).",
    )
    ball_diameter: Length | None = Field(
        default=None,
        description="Diameter of the balls or pins (default: they touch near the middle of the flank).",
    )
    measure_over: Body = Field(default="balls", description='`"balls"` or `"pins"`.')
    face_width_rule: WidthRule = Field(
        default="book",
        description="Face width that a span needs, in z_w,max of helical wheels: "
        '`"book"`, W <= b/sin(beta), or `"exact"`, W <= b/sin(beta_b).',
    )
    circles: Circles = Field(
        default=[], description='Diameters on which the tooth is measured, `["72 mm", "78 mm"]`, beside the usual ones.'
    )
    points: Points = Field(default=POINTS, description="Points of each curve of the tooth profile.")
