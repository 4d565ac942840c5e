"""``[pair]``: pairs of gears written out, or what is asked of the pairs of the train that is chosen."""

from typing import Annotated, Any

from pydantic import Field

from tmmcalc.gears.tables.shifting import SPLITS, STRATEGIES
from tmmcalc.gears.tables.teeth import (
    ANGLE,
    LENGTH,
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
from tmmcalc.spec.phrases import show
from tmmcalc.spec.quantities import Number
from tmmcalc.spec.reader import Reader
from tmmcalc.spec.table import Table
from tmmcalc.spec.units import UnitError


class OneOrTwo(Reader):
    """A list of one value or two: for the first wheel and the second."""

    def __init__(self, item: Reader, example: str) -> None:
        self.item = item
        self.example = example

    def read(self, value: object) -> list[Any]:
        """Return the list; raise UnitError with the fault in plain words."""
        if not isinstance(value, list) or len(value) not in (1, 2):
            what = f"{show(value)} is not a list of one value or two, of the first wheel and of the second"
            raise UnitError(what, f"write {self.example}")
        return [self.item.read(each) for each in value]

    def describe(self) -> dict[str, Any]:
        """Return the JSON Schema: an array."""
        whose = f"A list of one value or two: {self.example}."
        return {"type": "array", "items": self.item.describe(), "minItems": 1, "maxItems": 2, "description": whose}


PairName = Annotated[str, Words("pair")]
Kind = Annotated[str, Known("kind of pair", ("external", "internal", "rack"))]
Teeth = Annotated[list[int], OneOrTwo(Whole("a number of teeth", *TEETH), "[14, 17], or [14] of a pinion on a rack")]
Strategy = Annotated[str, Known("way to choose the shifts", STRATEGIES)]
Split = Annotated[str, Known("way to split the sum of the shifts", SPLITS)]
ContactRatio = Annotated[float, Number("a contact ratio", "1.2", above=0, at_most=5)]
Sliding = Annotated[float, Number("a specific sliding", "3", above=0)]
Pressure = Annotated[float, Number("a specific pressure", "1.5", above=0)]
Angles = Annotated[list[float], Listed(Within(*ANGLE, 0, 60), '["15 deg", "30 deg"]', 2)]
Diameters = Annotated[list[float], OneOrTwo(LENGTH, '["86.8 mm", "152 mm"]')]
SpanTeeth = Annotated[list[int], OneOrTwo(Whole("a number of teeth", 2, TEETH[1]), "[3, 5]")]


class PairKeys(Table):
    """What [pair] and each of [[pair.meshes]] may say."""

    name: PairName | None = Field(
        default=None, description="Name in titles and files; of several pairs each its own (default: `pair 1` ...)."
    )
    kind: Kind | None = Field(
        default=None,
        description='`"external"` wheels; or `"internal"`: the mate is a ring; or `"rack"`: it is a rack (default: '
        '`"external"`).',
    )
    teeth: Teeth | None = Field(
        default=None, description="Numbers of teeth of pinion and mate, `[14, 27]`; of a pinion on a rack `[14]`."
    )
    module: Module | None = Field(default=None, description="Module in the normal section.")
    helix_angle: Helix | None = Field(
        default=None,
        description="Helix angle on the reference cylinder, below 60 deg; the hand, its sign, does not matter "
        "(default: 0, spur).",
    )
    rack: RackName | None = Field(
        default=None,
        description='Basic rack that cuts the wheels: `"GOST 13755"`, or `"ISO 53 A"`, `"ISO 53 B"`, `"ISO 53 C"`, '
        '`"ISO 53 D"`, `"AGMA 14.5"`, `"stub 20"` (default: `"GOST 13755"`, of a train that of '
        "`[train]`).",
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
    strategy: Strategy | None = Field(
        default=None,
        description='How the shifts are chosen (default: `"given"` with `x1` and `x2`, `"given_aw"` with '
        '`centre_distance` and in a train, else `"balanced"`, of a ring and of a rack `"zero"`).',
    )
    x1: Shift | None = Field(default=None, description="Shift of the pinion in modules.")
    x2: Shift | None = Field(
        default=None, description="Shift of its mate in modules; of a ring positive towards the tips of its teeth."
    )
    centre_distance: Length | None = Field(
        default=None,
        description="Operating centre distance; with it one of the shifts may be given, or `split` (default: "
        "in a train that of its tooth numbers).",
    )
    split: Split | None = Field(
        default=None,
        description='How a given sum of shifts is split: `"equal_sliding"`, or `"equal_strength"`, '
        '`"max_contact_ratio"`, `"middle"` of the admissible ones (default: `"equal_sliding"`).',
    )
    desired_contact_ratio: ContactRatio | None = Field(
        default=None, description='Contact ratio of the strategy `"equal_sliding"` (default: 1.2).'
    )
    contact_ratio_min: ContactRatio | None = Field(
        default=None, description="Least transverse contact ratio, below which a pair fails (default: 1)."
    )
    contact_ratio_wanted: ContactRatio | None = Field(
        default=None, description="Transverse contact ratio below which a pair is warned of (default: 1.2)."
    )
    tip_thickness_min: Thickness | None = Field(
        default=None, description="Least thickness of the tips, in modules (default: 0)."
    )
    tip_thickness_wanted: Thickness | None = Field(
        default=None,
        description="Thickness of the tips below which is warned, in modules (default: 0.25); 0.4 of hardened teeth.",
    )
    sliding_max: Sliding | None = Field(
        default=None, description="Specific sliding above which is warned (default: 3)."
    )
    pressure_max: Pressure | None = Field(
        default=None, description="Specific pressure above which is warned (default: not judged)."
    )
    angle_range: Angles | None = Field(
        default=None, description='Usual operating pressure angles (default: `["15 deg", "30 deg"]`).'
    )
    undercut: Undercut | None = Field(
        default=None,
        description='`"none"`: undercut is a fault; `"tolerated"`: the choice makes use of it as long as it leaves '
        "the active flanks whole (default: the choice avoids it, given shifts may have it).",
    )
    face_width: Length | None = Field(
        default=None,
        description="Working face width, for the overlap ratio and spans (default: in a train that of strength).",
    )
    fillet: Fillet | None = Field(
        default=None,
        description='Section of the rack\'s rounding across helical teeth: `"ellipse"`, exact, or `"circle"`, as '
        'the textbook has it (default: `"ellipse"`).',
    )
    tip_diameters: Diameters | None = Field(
        default=None,
        description='Diameters of the tip circles, `["86.8 mm", "152 mm"]` (default: '
        "by the shifts, with the full clearance).",
    )
    cutter: CutterTable | None = Field(
        default=None,
        description='The shaper that cuts a ring, `{ teeth = 25, shift = 0.1, rounding = 0.1, tip_diameter = "84 mm" '
        "}` (default: the ring is as deep as the rack).",
    )
    span_teeth: SpanTeeth | None = Field(
        default=None,
        description="Teeth that the span is measured over, two or more each, `[3, 5]`; "
        "of a pinion in a ring or on a rack `[3]` (default: z_w,max, the most that the rule admits).",
    )
    ball_diameters: Diameters | None = Field(
        default=None,
        description='Diameters of the balls or pins, `["8.5 mm", "8.5 mm"]` (default: '
        "they touch near the middle of the flank).",
    )
    measure_over: Body | None = Field(default=None, description='`"balls"` or `"pins"` (default: `"balls"`).')
    face_width_rule: WidthRule | None = Field(
        default=None,
        description="Face width that a span needs, in z_w,max of helical wheels: "
        '`"book"`, W <= b/sin(beta), or `"exact"`, W <= b/sin(beta_b) (default: `"book"`).',
    )


class PairMeshTable(PairKeys):
    """One of several pairs, or of the meshes of a train; what it does not say is that of [pair]."""

    mesh: str | None = Field(
        default=None,
        description='Which mesh of the train it is, by its wheels: `"1-2"`, `"2\'-3"`. '
        "Without a train there is no such key: each entry is a pair.",
    )


class PairTable(PairKeys):
    """Pairs of gears: teeth, rack, choice of the shifts, limits, what is measured."""

    refuse: bool = Field(
        default=True,
        description="Whether a pair that cannot work is an error, with its margin and the nearest admissible shifts; "
        "`false`: it is told and shown.",
    )
    points: Points = Field(default=POINTS, description="Points of each curve of a tooth profile.")
    meshes: list[PairMeshTable] = Field(
        default=[], description="Several pairs, or the meshes of the train that differ from the others."
    )

    @property
    def of_train(self) -> bool:
        """Whether the pairs are those of the train: none has teeth of its own."""
        return self.teeth is None and not any(mesh.teeth for mesh in self.meshes)
