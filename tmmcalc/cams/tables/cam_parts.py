"""The tables in ``[cam]``: limits, loads, spring, guide, requirements, search for the best, elastic follower."""

import math
from typing import Annotated, Any, Literal

from pydantic import Field

from tmmcalc.cams.tables.cam_law import LawForm
from tmmcalc.cams.tables.cam_spring import SPRING_KEYS, SpringMethod
from tmmcalc.cams.tables.tasks.design_game import ROLLER_KINDS, Options
from tmmcalc.spec.choices import Known, Listed, OrFalse, Within
from tmmcalc.spec.quantities import Friction, Number, Quantity
from tmmcalc.spec.table import Table

_PRESSURE = Within("angle", "deg", math.pi / 180, 1, 89)
_POSITIVE = {"at_least_zero": True, "nonzero": True}
_SIZE = Within("length", "mm", 1e-3, 1e-4, 1e5, bare=2.0)

Size = Annotated[float, _SIZE]
Distance = Annotated[float, Within("length", "mm", 1e-3, 0, 1e5, bare=2.0)]
Pressure = Annotated[float, _PRESSURE]
ReturnPressure = Annotated[Any, OrFalse(_PRESSURE)]
LawNames = Annotated[list[str], Listed(LawForm.KNOWN, '["sine", "shun", "const"]')]
Ends = Annotated[list[float], Listed(_SIZE, '["90 mm", "120 mm"]', 2)]
Heights = Annotated[list[float], Listed(_SIZE, '["100 mm", "140 mm"]', 2)]
Load = Annotated[float, Quantity("force", "moment")]
Place = Annotated[float, Quantity("angle", at_least_zero=True)]
PressingLoad = Annotated[float, Quantity("force", "moment", at_least_zero=True)]
Acceleration = Annotated[float, Quantity("acceleration")]
Mass = Annotated[float, Quantity("mass", **_POSITIVE)]
Inertia = Annotated[float, Quantity("inertia", **_POSITIVE)]
MassOrInertia = Annotated[float, Quantity("mass", "inertia", **_POSITIVE)]
Stiffness = Annotated[float, Quantity("stiffness", "torsional stiffness", **_POSITIVE)]
Deflection = Annotated[float, Quantity("length", "angle", **_POSITIVE)]
_SAFETY = Number("a safety of the contact", "1.25", at_least=1, at_most=100)
Safety = Annotated[float, _SAFETY]
Stress = Annotated[float, Quantity("pressure", **_POSITIVE)]
Density = Annotated[float, Quantity("density", **_POSITIVE)]
Coefficient = Annotated[float, Number("a coefficient of friction", "0.1", above=0, at_most=5)]
Factor = Annotated[float, Number("a factor", "1.4", above=0)]
Safeties = Annotated[list[float], Listed(_SAFETY, "[1.2, 1.5]")]
Contacts = Annotated[list[Any], Options(Quantity("pressure", **_POSITIVE), '["400 MPa", "600 MPa"]')]
RollerRatios = Annotated[list[Any], Options(Number("a factor", "2.5", above=0), '["needle", "plain"]', ROLLER_KINDS)]
Damping = Annotated[float, Number("a part of critical damping", "0.05", at_least=0, below=1)]


class CamLimitsTable(Table):
    """Largest pressure angles and least radii of curvature."""

    pressure_angle: Pressure | None = Field(
        default=None,
        description="Largest pressure angle on the rise (default: translating 30 deg, oscillating 45 deg).",
    )
    pressure_angle_return: ReturnPressure | None = Field(
        default=None,
        description="Largest pressure angle on the return; `false`: not limited (default: "
        "in a groove that of the rise; with force closure not limited: the spring drives).",
    )
    convex_radius: Distance = Field(
        default=0.0025,
        description="r_m: least radius of curvature of convex parts of the working profile; "
        "of a groove, where either wall bulges.",
    )
    concave_radius: Distance = Field(
        default=0.075, description="r_i: least radius of the tool for concave parts of the working profile."
    )
    allow_concave: bool = Field(
        default=True, description="Whether the working profile may have concave parts; `false`: it has none."
    )
    shaft_radius: Distance = Field(default=0.0, description="Radius of the shaft that the base circle has to clear.")


class ForceTable(Table):
    """A technological force or moment by the angle of the cam, straight lines between, repeated every turn."""

    phi: list[Place] | None = Field(
        default=None,
        min_length=2,
        description="Angles from the start of the rise, ascending; two equal ones are a jump (default: n values are n "
        "equal steps).",
    )
    force: list[Load] | None = Field(
        default=None, min_length=2, description="Force at each angle, straight lines between, repeated every turn."
    )
    moment: list[Load] | None = Field(default=None, min_length=2, description="Moment at each angle, of a rocker.")
    file: str | None = Field(
        default=None,
        description='CSV file in place of the values, `{ file = "q.csv" }`: two columns under a header such as '
        "`phi[deg],Q[N]`; its path counts from the folder of the spec.",
    )
    columns: str | None = Field(
        default=None,
        description="Columns of a file that has more than two: of the values, or of both, as `--columns` names them, "
        '`"phi,Q"`.',
    )


class CamLoadsTable(Table):
    """Masses, forces and friction of the follower; forces are positive along the lift."""

    mass: Mass | None = Field(default=None, description="Mass of a stem and all that moves with it (default: 0).")
    inertia: Inertia | None = Field(
        default=None, description="Moment of inertia of a rocker about its pivot (default: 0)."
    )
    force: Load = Field(
        default=0.0,
        description="Technological force (of a rocker moment) during rise and high dwell; "
        "positive along the lift, negative presses on the cam.",
    )
    force_return: Load = Field(
        default=0.0,
        description="Technological force (of a rocker moment) during return and low dwell; "
        "positive along the lift, negative presses on the cam.",
    )
    force_table: ForceTable | None = Field(
        default=None,
        description='Or by the angle of the cam from the start of the rise: `{ phi = ["0 deg", "90 deg"], force = '
        '["-150 N", 0] }` (rocker: `moment`).',
    )
    gravity: Acceleration = Field(
        default=0.0,
        description='Component of the gravity along the lift; `"-9.81 m/s^2"`: the weight presses on the cam.',
    )
    friction: Friction = Field(
        default=0.0,
        description="Coefficient of friction of a stem in its guide, whose `top` or `length` has to be known.",
    )
    pivot_friction: Friction = Field(default=0.0, description="Coefficient of friction of a rocker in its pivot.")
    pivot_radius: Size | None = Field(
        default=None,
        description="Radius of the rocker's pivot (default: 0); the synthesis lets the cam pass the pivot.",
    )


DeadCoils = Annotated[float, Number("a number of coils", "2", at_least=0, at_most=20)]


class CamSpringTable(Table):
    """The spring that keeps the follower on the cam: sized, or given."""

    method: Annotated[SpringMethod, Known("way to size the spring", tuple(SPRING_KEYS))] | None = Field(
        default=None,
        description='How the spring is found. `"safety"`: by the safety of the contact; `"preload"`: '
        'by the deflection of the preload and the least contact force; `"given"`; `"none"` (default: '
        'by the other keys, else `"safety"`).',
    )
    safety: Safety = Field(
        default=1.25,
        description='Of `"safety"`: K1, the spring\'s force over the inertia force that lifts the follower off, by '
        "the textbook's rule.",
    )
    exact: bool = Field(
        default=False,
        description='Of `"safety"`: whether it is kept over the whole turn, in place of the textbook\'s rule.',
    )
    stiffness: Stiffness | None = Field(
        default=None, description='Of `"given"`: stiffness of the spring, `"8 N/mm"`; of a rocker `"6 N*m/rad"`.'
    )
    preload: PressingLoad = Field(
        default=0.0,
        description='Of `"given"`: its force at the lowest position, `"60 N"`; of a rocker its moment, `"0.8 N*m"`.',
    )
    deflection: Deflection | None = Field(
        default=None,
        description='Of `"preload"`: deflection of the spring at the lowest position (default: 0.4 of the stroke).',
    )
    least_contact: PressingLoad = Field(
        default=5.0, description='Of `"preload"`: least force (of a rocker moment) on the cam with this deflection.'
    )
    wire: Size | None = Field(
        default=None,
        description="Diameter of the wire, with `coil`: the number of coils and the stress follow; not of a rocker.",
    )
    coil: Size | None = Field(default=None, description="Mean diameter of the coils.")
    shear_modulus: Stress = Field(default=8e10, description="Shear modulus of the wire.")
    shear_stress: Stress | None = Field(
        default=None,
        description="Allowed shear stress of the wire: wire, coils and height of the springs that have it at the "
        "highest position follow, for D/d from 4 to 16; not of a rocker.",
    )
    dead_coils: DeadCoils = Field(default=2.0, description="Coils at the ends that do not work, of these springs.")


class CamGuideTable(Table):
    """The guide of a translating or flat-faced follower."""

    top: Size | None = Field(default=None, description="H2: height of the upper edge above the cam's axis.")
    length: Size | None = Field(default=None, description="Or l: distance of the two edges.")
    gap: Distance = Field(default=0.0, description="Between the roller at its highest and the lower edge.")
    stem_radius: Size | None = Field(default=None, description="r_T: radius of a round stem.")
    land: Size | None = Field(default=None, description="l_H: length of each of the two ground lands of the stem.")


class CamMaterialTable(Table):
    """The steel of the softer one of cam and roller."""

    treatment: Literal[
        "annealed", "normalised", "improved", "surface-hardened", "carburised", "nitrocarburised", "nitrided"
    ] = Field(
        description='Heat treatment: `"annealed"`, `"normalised"`, `"improved"`, `"surface-hardened"`, `"carburised"`, '
        '`"nitrocarburised"`, `"nitrided"`.',
    )
    hardness: str = Field(description='Hardness of the surface: `"300 HB"`, `"52 HRC"`, `"750 HV"`.')
    failure: Literal["ordinary", "severe"] = Field(
        default="ordinary", description='Consequences of a failure: `"ordinary"` or `"severe"`.'
    )


class CamRequirementsTable(Table):
    """Data of slip, shaft, stem, pin and contact; what is not said is not judged."""

    width: Size | None = Field(default=None, description="b: length of the line of contact.")
    modulus: Stress = Field(default=2e11, description="E_n: reduced modulus of elasticity of cam and roller.")
    contact: Stress | None = Field(default=None, description="Allowed contact stress; or `material`.")
    material: CamMaterialTable | None = Field(
        default=None,
        description="The steel whose allowed contact stress it is, sigma_Hlim/S_H of the tables of gears.",
    )
    rolling_arm: Distance | None = Field(
        default=None, description="k: arm of the rolling resistance of the roller that shall not slip."
    )
    roller_friction: Coefficient | None = Field(
        default=None, description="f: sliding friction on the cam of the roller that shall not slip."
    )
    pin_friction: Friction | None = Field(
        default=None, description="f0: friction on its pin of the roller that shall not slip."
    )
    pin: Size | None = Field(default=None, description="r0: radius of the pin (default: by the pressure).")
    pin_pressure: Stress | None = Field(default=None, description="Allowed pressure on the pin.")
    pin_ratio: Factor = Field(
        default=1.4, description="alpha2: width of the roller's hub over the diameter of the pin."
    )
    roller_ratio: Factor = Field(
        default=2.5,
        description="alpha0: least radius of the roller over that of the pin, by the kind of its bearing: "
        "needles 1.1 to 1.2, plain 2 to 2.5, rolling bearing 2.5 to 3.5.",
    )
    roller_density: Density = Field(default=7820.0, description="Density of the roller.")
    roller_inertia: Inertia | None = Field(
        default=None, description="Moment of inertia of the roller (default: of a hollow cylinder)."
    )
    span: Size | None = Field(default=None, description="l_s: distance of the camshaft's supports.")
    bending: Stress | None = Field(default=None, description="Allowed bending stress of camshaft and stem.")
    deflection: Size | None = Field(default=None, description="Allowed deflection of the camshaft.")
    young: Stress = Field(default=2e11, description="Modulus of elasticity of the camshaft.")
    torsion: Factor = Field(default=0.75, description="alpha_e: weight of the torque in the reduced moment.")
    guide_pressure: Stress | None = Field(
        default=None, description="Allowed pressure of the stem's lands in its guide."
    )


class CamOptimumTable(Table):
    """The search for the lowest mechanism; of a rocker for the least distance of the centres."""

    step: Size = Field(
        default=1e-3,
        description="Step of start distance and roller radius; of a rocker of l0, l2, R0 and r2.",
    )
    height_step: Size = Field(default=1e-3, description="Step of the height of the guide's upper edge.")
    heights: Heights | None = Field(
        default=None,
        description='Heights of the guide\'s upper edge, from and to, `["100 mm", "140 mm"]` (default: '
        "from the least possible).",
    )
    centre_distances: Ends | None = Field(
        default=None,
        description='Of a rocker: distances l0 of the centres, from and to, `["80 mm", "120 mm"]` (default: from the '
        "least possible).",
    )
    rocker_lengths: Ends | None = Field(
        default=None,
        description='Of a rocker: its lengths l2, from and to; twice the same: one that is given, `["90 mm", "90 mm"]` '
        "(default: any).",
    )
    phases: Annotated[Literal["turn", "rise"], Known("part of the turn", ("turn", "rise"))] = Field(
        default="turn",
        description='What is examined: the whole turn, `"turn"`, or the `"rise"` alone as in the textbook.',
    )
    laws: LawNames | None = Field(
        default=None, description='Laws of rise and return that are tried in place of the cam\'s, `["sine", "shun"]`.'
    )
    safeties: Safeties | None = Field(
        default=None, description="Safeties K1 by which the spring is sized instead, which are tried, `[1.2, 1.5]`."
    )
    contacts: Contacts | None = Field(
        default=None,
        description="Allowed contact stresses that are tried, of other materials: "
        '`["400 MPa", "600 MPa"]`, or by name `{ "steel 45" = "600 MPa" }`.',
    )
    roller_ratios: RollerRatios | None = Field(
        default=None,
        description='Kinds of roller that are tried: `"needle"` (1.15), `"plain"` (2.2), `"rolling"` (3), or numbers '
        "alpha0; a table gives them names.",
    )
    combine: bool = Field(
        default=False,
        description="Whether all combinations are tried, at most 60 mechanisms, and not each option alone.",
    )


class CamElasticTable(Table):
    """A follower as one mass on an elastic train."""

    stiffness: Stiffness = Field(description="Stiffness between cam and mass.")
    damping: Damping = Field(default=0.0, description="Damping as a part of critical damping.")
    mass: MassOrInertia | None = Field(
        default=None, description="What swings: a mass, of a rocker a moment of inertia (default: of the loads)."
    )
