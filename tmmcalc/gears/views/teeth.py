"""The teeth of an external pair by formulas, which a page redraws while its shifts are moved.

Texts have the letters of the chapter on tooth profiles (`tmmcalc.gears.notes.pairs.tooth`), without an index; those of
a wheel take its own. Axes of a tooth: the centre of the wheel is the origin, Y lies along the tooth, the flank left of
it. The rounding of the rack is an ellipse with the half axes A and B (`tmmcalc.gears.involute.profile.rounding`), a
point of the fillet is told by the slope theta of its normal. The fillet of an undercut tooth crosses the involute of
the same radius where the angle G from this to that vanishes (`tmmcalc.gears.involute.profile.form`); with

    T = tan(theta) - tan(alpha_t),  w = sqrt(A^2 + B^2 tan^2(theta)) = D/cos(theta)

its integral is  E = delta - T (1 + y_S/r) + (w - w_0)/r. The root is sought in v = sqrt(delta), which is of the order
of the undercut.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from tmmcalc.gears.meshing.members import both
from tmmcalc.gears.meshing.results import MeshPair
from tmmcalc.gears.notes.pairs import sizes, tooth
from tmmcalc.gears.notes.pairs.lexicon import words_of
from tmmcalc.report.exploring import Condition, Drawn, Piece, Sketch, Toothed
from tmmcalc.report.formula.carried import Root, Step, carried, step_of
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.formula.tree import Statement, renamed
from tmmcalc.report.language import tr
from tmmcalc.report.moving import GREEN
from tmmcalc.report.telling import filled

OWN = "z", "x", "r", "r_b", "r_w", "r_a", "r_f", "alpha_a", "rho_L", "rho_p"  # of a wheel, told before its tooth
ROUNDING = (
    "x_S = m*(x - <hl>)*tan(<t>) - A**2*cos(<t>)/sqrt(A**2*cos(<t>)**2 + B**2*sin(<t>)**2)",
    "y_S = m*(x - h_a^{*} - c^{*}) + B",
)
CROSSING = "v"
# beyond the foot of the normal of a circle of the same height; no way where nothing is undercut
FARTHEST = "max(-sign(rho_L), 0)*sqrt(max(asin(min((B + sqrt(B**2 - 4*r*min(y_S, 0)))/(2*r), 1)) - <t>, 0))"
JUNCTION = (
    "delta = v**2",
    "theta_F = <t> + delta",
    "T = sin(delta)/(cos(<t>)*cos(theta_F))",
    "w_0 = sqrt(A**2 + B**2*tan(<t>)**2)",
    "w = sqrt(A**2 + B**2*tan(theta_F)**2)",
    "k = r*sin(theta_F) + y_S/sin(theta_F) - B**2/(w*cos(theta_F))",  # from the foot of the normal to the fillet
    "q = k**2 - r**2*sin(delta)*sin(2*<t> + delta)",
    "rho_F = sign(q)*sqrt(abs(q))",
    "kappa = k/(r*cos(theta_F))",
    "E = delta - T*(1 + y_S/r - B**2*(tan(<t>) + tan(theta_F))/(r*(w + w_0)))",
    "G = kappa - atan(kappa) - rho_F/r_b + atan(rho_F/r_b) + E",
)
ENDS = (
    tooth.PSI,
    filled(sizes.CUT_RADIUS, {"i": "", "_i": ""}),
    "inv(alpha_P) = psi + inv(<t>)",
    "r_P = r_b/cos(alpha_P)",  # the point of the tooth
    "phi_F = rho_F/r_b - tan(<t>)",
    "phi_A = min(tan(alpha_a), tan(alpha_P)) - tan(<t>)",
    "alpha_A = atan(phi_A + tan(<t>))",
    "psi_A = psi + inv(<t>) - inv(alpha_A)",
    "r_A = r_b/cos(alpha_A)",
    "phi_D = x_S/r",
    "zeta = psi + inv(<t>) - inv(alpha_tw)",  # half the angle of the tooth on the pitch circle
)
FILLET = (
    "D = sqrt(A**2*cos(theta)**2 + B**2*sin(theta)**2)",
    "d = B**2/D - y_S/sin(theta)",
    "phi = (x_S + y_S*cos(theta)/sin(theta) + (A**2 - B**2)*cos(theta)/D)/r",
    "F = phi - psi",
)
REACH = 3.1  # [module] that is shown above the pitch point, and below
ASIDE, AWAY = 0.5, 2.75  # [module] from the line of centres and the pitch point to the numbers of the wheels
CONTACTS = 4  # pitches before and behind the pitch point at which flanks may touch
# points of the line of action: distances from N1, on which side of it their names stand
POINTS = ("N1", "0", -1), ("A2", "rho_p1", 1), ("P", "rho_w1", -1), ("A1", "rho_a1", 1), ("N2", "g", -1)
ACTION = GREEN  # colour; those of the wheels are their numbers


class Tooth:
    """The tooth of wheel 1 or 2 of an external pair: its own letters take the number as their index."""

    def __init__(self, found: MeshPair, number: int) -> None:
        self.number, self.name = number, found.task.wheels[number - 1]
        self._words = words_of(found.task)
        read_out = [read(filled(text, self._words)) for text in (*ROUNDING, *JUNCTION, *ENDS)]
        told = [step_of(each).name for each in read_out]
        self._letters = {key: _indexed(key, number) for key in (*OWN, *told, CROSSING)}

    def node(self, text: str) -> Any:
        """A side of a formula with the letters of the wheel."""
        (side,) = read(filled(text, self._words)).sides
        return carried(renamed(side, self._letters))

    def step(self, text: str) -> Step:
        """A formula with the letters of the wheel."""
        formula = read(filled(text, self._words))
        return step_of(Statement(tuple(renamed(side, self._letters) for side in formula.sides), formula.relations))

    def steps(self) -> Iterator[Step | Root]:
        """From the circles of the pair to all that the curves of the tooth need."""
        yield from map(self.step, ROUNDING)
        ends = self.node("0"), self.node(FARTHEST)
        yield Root(self._letters[CROSSING], *ends, tuple(map(self.step, JUNCTION)))
        yield from map(self.step, ENDS)

    def piece(self, parameter: str, ends: tuple[str, str], at: tuple[str, str], *texts: str) -> Piece:
        """A part of the outline."""
        start, end, x, y = map(self.node, (*ends, *at))
        return Piece(parameter, start, end, tuple(map(self.step, texts)), x, y)

    def involute(self, start: str, end: str) -> Piece:
        """The involute between two roll angles."""
        return self.piece("phi_T", (start, end), ("X_T", "Y_T + r_b"), *tooth.INVOLUTE[:3])

    def toothed(self, turn: str, y: str, active: tuple[str, str]) -> Toothed:
        """The wheel in its place; its flank works between two radii of curvature."""
        fillet = "r*sin(F) + d*cos(theta + F)", "r*cos(F) - d*sin(theta + F)"
        half = (
            self.piece("t", ("pi/z", "psi - phi_D"), ("-r_f*sin(t)", "r_f*cos(t)")),
            self.piece("theta", ("pi/2", "theta_F"), fillet, *FILLET),
            self.involute("phi_F", "phi_A"),
            self.piece("t", ("psi_A", "0"), ("-r_A*sin(t)", "r_A*cos(t)")),
        )
        start, end = (f"{rho}/r_b - tan(<t>)" for rho in active)
        worked = self.involute(f"max({start}, phi_F)", f"min({end}, phi_A)")
        beyond = tr("undercut cuts the teeth of wheel {wheel} off at their feet", wheel=self.name)
        count, turned, above = map(self.node, ("z", turn, y))
        return Toothed(half, worked, beyond, count, turned, 0.0, above, self.number)

    def conditions(self) -> Iterator[Condition]:
        """What a tooth needs that there is one."""
        wheel = self.name
        yield Condition(self.node("r_f"), tr("nothing is left of wheel {wheel} within its root circle", wheel=wheel))
        yield Condition(
            self.node("r_a - r_F"),
            tr("the tip circle of wheel {wheel} lies below the beginning of its involute", wheel=wheel),
        )
        yield Condition(
            self.node("r_P - r_F"),
            tr("the teeth of wheel {wheel} are pointed below the beginning of their involutes", wheel=wheel),
        )

    def faults(self, mate: str) -> Iterator[Condition]:
        """What keeps a tooth that there is from its work."""
        pointed = tr("the teeth of wheel {wheel} are pointed below the tip circle", wheel=self.name)
        yield Condition(self.node("r_P - r_a"), pointed, needed=False)
        cut = tr("the tip of wheel {wheel} cuts into the fillet of wheel {mate}", wheel=mate, mate=self.name)
        yield Condition(self.node("rho_p - rho_F"), cut, needed=False)


def _indexed(key: str, number: int) -> str:
    return f"{key}{number}" if "_" in key else f"{key}_{number}"


def axes_of_rounding(found: MeshPair) -> dict[str, float]:
    """A and B [mm]."""
    tool = both(found)[0].tool
    return {key: 1e3 * found.task.module * axis for key, axis in (("A", tool.width), ("B", tool.height))}


def conditions_of(found: MeshPair, teeth: tuple[Tooth, Tooth]) -> Iterator[Condition]:
    """What a pair needs, then what keeps it from its work."""
    first, second = teeth
    spread = first.node("inv(<t>) + 2*x_Sigma*tan(alpha)/(z_1 + z_2)")
    yield Condition(spread, tr("the sum of the shifts is too small for a mesh without backlash"))
    for each in teeth:
        yield from each.conditions()
    yield from first.faults(second.name)
    yield from second.faults(first.name)


def sketch_of(found: MeshPair, teeth: tuple[Tooth, Tooth]) -> Sketch:
    """Both wheels in mesh around their pitch point, as `tmmcalc.gears.pictures.placedpair` puts them."""
    first, second = teeth
    m = 1e3 * found.task.module
    return Sketch(
        tr("Teeth at these shifts"),
        (0.0, first.node("r_w")),
        REACH * m,
        (
            first.toothed("-zeta", "0", ("rho_s1", "rho_e1")),
            second.toothed("pi - zeta", "a_w", ("rho_e2", "rho_s2")),
        ),
        tuple(_marks(first, second, m)),
    )


def _marks(first: Tooth, second: Tooth, m: float) -> Iterator[Drawn]:
    """Circles, the line of centres, the line of action with its points, where flanks touch, the numbers of wheels."""
    node = first.node
    far = 4 * REACH * m
    yield Drawn("axis", ((0.0, node(f"r_w - {far}")), (0.0, node(f"r_w + {far}"))))
    for wheel, y in ((first, "0"), (second, "a_w")):
        yield Drawn("pitch", ((0.0, node(y)),), wheel.node("r_w"), wheel.number)
        yield Drawn("base", ((0.0, node(y)),), wheel.node("r_b"), wheel.number)

    def on_line(rho: str) -> tuple[Any, Any]:
        """The point of the line of action that is so far from N1."""
        return node(f"r_b*sin(alpha_tw) - ({rho})*cos(alpha_tw)"), node(f"r_b*cos(alpha_tw) + ({rho})*sin(alpha_tw)")

    yield Drawn("line", (on_line(f"-{far}"), on_line(f"g + {far}")), tone=ACTION)
    yield Drawn("bar", (on_line("rho_s1"), on_line("rho_e1")), tone=ACTION, there=node("rho_e1 - rho_s1"))
    for k in range(-CONTACTS, CONTACTS + 1):
        rho = f"rho_w1 + {k}*p_b"
        yield Drawn("dot", (on_line(rho),), tone=ACTION, there=node(f"min({rho} - rho_s1, rho_e1 - ({rho}))"))
    for name, rho, side in POINTS:
        yield Drawn("dot", (on_line(rho),), name=name, side=side)
    for wheel, way in ((first, -1), (second, 1)):
        yield Drawn("number", ((ASIDE * m, node(f"r_w + {way * AWAY * m}")),), name=wheel.name)
