"""Every intermediate angle, involute and length of a pair, in the order in which a calculation by hand meets them.

The source of a quantity that begins with "=" is its formula in the names of the others; lengths are in one unit there,
angles in rad. ``side`` and ``sign`` are the signs that ISO 21771 gives a ring: +1 of two external wheels, -1 of a ring.
"""

from __future__ import annotations

from math import atan, atan2, cos, pi, sin, sqrt, tan

from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record
from tmmcalc.gears.involute.function import involute
from tmmcalc.gears.meshing.geometry import pinion_on_rack
from tmmcalc.gears.meshing.results import MeshPair, WheelSizes
from tmmcalc.gears.meshing.sliding import sliding_at


@record
class WheelAngles:
    """One wheel; None where its tip circle lies within its base circle."""

    wheel: str = quantity("wheel", "name of the wheel")
    sign: int = quantity("sign", "+1, of a ring -1")
    teeth: int = quantity("z", "number of teeth")
    shift: float = quantity("x", "profile shift")
    reference: float = quantity("r[m]", "reference radius", source="= m*z/(2*cos(beta))")
    base: float = quantity("r_b[m]", "base radius", source="= r*cos(alpha_t)")
    operating: float = quantity("r_w[m]", "operating pitch radius", source="= r*eta")
    tip: float = quantity("r_a[m]", "tip radius")
    root: float = quantity("r_f[m]", "root radius")
    form: float = quantity("r_F[m]", "form radius: the involute ends")
    active: float = quantity("r_p[m]", "active radius: the contact ends")
    reference_diameter: float = quantity("d[m]", "reference diameter", source="= 2*r")
    base_diameter: float = quantity("d_b[m]", "base diameter", source="= 2*r_b")
    operating_diameter: float = quantity("d_w[m]", "operating pitch diameter", source="= 2*r_w")
    tip_diameter: float = quantity("d_a[m]", "tip diameter", source="= 2*r_a")
    root_diameter: float = quantity("d_f[m]", "root diameter", source="= 2*r_f")
    tip_angle: float | None = quantity("alpha_a[rad]", "pressure angle at the tip", source="= acos(r_b/r_a)")
    tip_involute: float | None = quantity(
        "inv_alpha_a", "involute function of the pressure angle at the tip", source="= tan(alpha_a) - alpha_a"
    )
    tip_curvature: float | None = quantity(
        "rho_a[m]", "radius of curvature of the flank at the tip", source="= r_b*tan(alpha_a)"
    )
    pitch_curvature: float = quantity(
        "rho_w[m]", "radius of curvature of the flank at the pitch point", source="= r_w*sin(alpha_tw)"
    )
    form_angle: float = quantity("alpha_F[rad]", "pressure angle where the involute ends", source="= acos(r_b/r_F)")
    active_angle: float = quantity("alpha_p[rad]", "pressure angle where the contact ends", source="= acos(r_b/r_p)")
    tip_roll: float | None = quantity(
        "phi_a[rad]", "roll angle of the tip from the reference circle", source="= tan(alpha_a) - tan(alpha_t)"
    )
    active_roll: float = quantity(
        "phi_p[rad]", "roll angle where the contact ends", source="= tan(alpha_p) - tan(alpha_t)"
    )
    half_angle: float = quantity(
        "psi[rad]",
        "half the angle of the tooth on the reference circle",
        source="= (pi/2 + 2*x*tan(alpha))/z",
    )
    arc: float = quantity("s_t[m]", "tooth thickness, transverse", source="= 2*r*psi")
    operating_half_angle: float = quantity(
        "psi_w[rad]", "half the angle of the tooth on the operating pitch circle", source="= psi - sign*gamma"
    )
    operating_arc: float = quantity(
        "s_tw[m]", "tooth thickness on the operating pitch circle, transverse", source="= 2*r_w*psi_w"
    )
    operating_space: float = quantity(
        "e_tw[m]", "space on the operating pitch circle, transverse", source="= p_tw - s_tw"
    )
    tip_half_angle: float | None = quantity(
        "theta_a[rad]",
        "half the angle of the tooth at the tip",
        source="= psi + sign*(inv_alpha_t - inv_alpha_a)",
    )
    tip_arc: float | None = quantity("s_ta[m]", "tip thickness, transverse", source="= 2*r_a*theta_a")
    tip_helix: float = quantity("beta_a[rad]", "helix angle at the tip", source="= atan(tan(beta)*r_a/r)")
    tip_thickness: float | None = quantity("s_na[m]", "tip thickness, normal", source="= s_ta*cos(beta_a)")
    approach: float | None = quantity(
        "eps_a",
        "part of the contact ratio from the pitch point to its tip",
        source="= sign*z*(tan(alpha_a) - tan(alpha_tw))/(2*pi)",
    )


@record
class ContactPoint:
    """A point of the line of action; of a rack without rho_2."""

    point: str = quantity("point", "A2 and A1 where the contact begins and ends, P the pitch point")
    rho1: float = quantity("rho_1[m]", "radius of curvature of wheel 1")
    rho2: float | None = quantity("rho_2[m]", "radius of curvature of wheel 2", source="= g - side*rho_1")
    theta1: float = quantity("theta_1", "specific sliding of wheel 1", source="= 1 - rho_2/(u*rho_1)")
    theta2: float = quantity("theta_2", "specific sliding of wheel 2", source="= 1 - u*rho_1/rho_2")
    pressure: float = quantity("lambda", "coefficient of specific pressure", source="= m*(1/rho_1 + side/rho_2)")

    @property
    def name(self) -> str:
        """The point, by which it is known among the others."""
        return self.point


@record
class PairAngles:
    """A pair; None of a rack, whose radius has no end."""

    pair: str = quantity("pair", "the pair by its teeth")
    side: int = quantity("side", "+1, of a pinion in a ring -1")
    module: float = quantity("m[m]", "normal module")
    angle: float = quantity("alpha[rad]", "profile angle")
    helix: float = quantity("beta[rad]", "helix angle at the reference cylinder, of either hand")
    transverse_module: float = quantity("m_t[m]", "transverse module", source="= m/cos(beta)")
    angle_t: float = quantity("alpha_t[rad]", "transverse pressure angle", source="= atan(tan(alpha)/cos(beta))")
    base_helix: float = quantity(
        "beta_b[rad]", "helix angle at the base cylinder", source="= asin(sin(beta)*cos(alpha))"
    )
    involute_t: float = quantity(
        "inv_alpha_t", "involute function of the transverse pressure angle", source="= tan(alpha_t) - alpha_t"
    )
    ratio: float | None = quantity("u", "ratio of the teeth", source="= z_2/z_1")
    teeth_sum: int | None = quantity("z_sum", "sum of the teeth, of a ring the difference", source="= z_1 + side*z_2")
    shift_sum: float = quantity("x_sum", "sum of the shifts", source="= x_1 + x_2")
    turn: float = quantity(
        "gamma[rad]",
        "angle between the points of a flank on the reference and on the operating pitch circle",
        source="= 2*x_sum*tan(alpha)/z_sum",
    )
    involute_w: float = quantity(
        "inv_alpha_tw", "involute function of the operating pressure angle", source="= inv_alpha_t + gamma"
    )
    angle_w: float = quantity(
        "alpha_tw[rad]", "operating transverse pressure angle", source="by its involute (4.57), or cos alpha_t/eta"
    )
    reference_distance: float | None = quantity(
        "a[m]", "reference centre distance", source="= abs(z_sum)*m/(2*cos(beta))"
    )
    stretch: float = quantity(
        "eta", "operating over reference centre distance, a_w/a", source="= cos(alpha_t)/cos(alpha_tw)"
    )
    distance: float = quantity("a_w[m]", "operating centre distance", source="= a*eta")
    modification: float = quantity("y", "centre distance modification in modules", source="= (a_w - a)/m")
    shortening: float = quantity("dy", "shortening of the tips in modules", symbol="Delta y", source="= x_sum - side*y")
    pitch: float = quantity("p_t[m]", "transverse pitch", source="= pi*m_t")
    base_pitch: float = quantity("p_bt[m]", "transverse base pitch", source="= p_t*cos(alpha_t)")
    operating_pitch: float = quantity(
        "p_tw[m]", "transverse pitch on the operating circles", source="= p_bt/cos(alpha_tw)"
    )
    between: float | None = quantity("g[m]", "distance between the points N1 and N2", source="= a_w*sin(alpha_tw)")
    path: float = quantity("g_alpha[m]", "path of contact of the whole flanks", source="= rho_a_1 + side*(rho_a_2 - g)")
    contact_ratio: float = quantity(
        "eps_alpha", "transverse contact ratio of the whole flanks", source="= g_alpha/p_bt"
    )
    overlap: float = quantity("eps_beta", "overlap ratio", source="= b*sin(beta)/(pi*m)")
    total: float = quantity("eps_gamma", "total contact ratio of the whole flanks", source="= eps_alpha + eps_beta")
    rack_addendum: float | None = quantity("h_rack", "addendum of the rack in modules")  # this and the next: of a rack
    rack_part: float | None = quantity(
        "eps_rack",
        "part of the contact ratio from the tip line of the rack to the pitch point",
        source="= (h_rack - x_1)*m/(sin(alpha_t)*p_bt)",
    )
    wheels: tuple[WheelAngles, ...]
    points: tuple[ContactPoint, ...]  # none where the whole flanks do not touch on the line of action


def pair_angles(found: MeshPair) -> PairAngles:
    """All of a solved pair.

    >>> from tmmcalc.gears.meshing.solve import solve_pair
    >>> from tmmcalc.gears.meshing.task import PairTask
    >>> pair = pair_angles(solve_pair(PairTask((14, 17), 0.005, strategy="given", shifts=(0.6, 0.522))))
    >>> round(sum(wheel.approach for wheel in pair.wheels) - pair.contact_ratio, 12)
    0.0
    """
    task, side = found.task, -1 if found.task.kind == "internal" else 1
    rack, (z1, z2) = task.kind == "rack", task.teeth
    total = None if rack else z1 + side * z2
    turn = 0.0 if total is None else 2 * found.shift_sum * tan(task.rack.angle) / total + 0.0
    base_pitch = task.transverse_pitch * cos(found.angle_t)
    operating_pitch = base_pitch / cos(found.angle_w)
    line = found.line
    return PairAngles(
        pair=task.title,
        side=side,
        module=task.module,
        angle=task.rack.angle,
        helix=task.helix,
        transverse_module=task.module * task.section.module,
        angle_t=found.angle_t,
        base_helix=found.base_helix,
        involute_t=found.involute_t,
        ratio=None if rack else z2 / z1,
        teeth_sum=total,
        shift_sum=found.shift_sum,
        turn=turn,
        involute_w=found.involute_w,
        angle_w=found.angle_w,
        reference_distance=None if rack else found.reference_distance,
        stretch=found.stretch,
        distance=found.distance,
        modification=found.modification,
        shortening=found.shortening,
        pitch=task.transverse_pitch,
        base_pitch=base_pitch,
        operating_pitch=operating_pitch,
        between=None if rack else line.between,
        path=line.path,
        contact_ratio=found.contact_ratio,
        overlap=found.overlap,
        total=found.total,
        rack_addendum=pinion_on_rack(found).addendum if rack else None,
        rack_part=(line.pitch - line.start) / base_pitch if rack else None,
        wheels=tuple(_wheel(found, size, turn, operating_pitch) for size in found.sizes),
        points=_points(found, side),
    )


def _wheel(found: MeshPair, size: WheelSizes, turn: float, pitch: float) -> WheelAngles:
    sign = -1 if size.kind == "ring" else 1
    psi_w = size.half_angle - sign * turn
    angles = {name: pressure_at(getattr(size, name), size.base) for name in ("tip", "form", "active")}
    tip, form, active = angles["tip"], angles["form"] or 0.0, angles["active"] or 0.0
    half = None if tip is None else size.half_angle + sign * (found.involute_t - float(involute(tip)))
    tip_helix = helix_at(size.tip, size.reference, found.task.helix)
    arc = None if half is None else 2 * size.tip * half
    start = tan(found.angle_t)
    return WheelAngles(
        wheel=size.name,
        sign=sign,
        teeth=size.teeth,
        shift=size.shift,
        reference=size.reference,
        base=size.base,
        operating=size.operating,
        tip=size.tip,
        root=size.root,
        form=size.form,
        active=size.active,
        reference_diameter=2 * size.reference,
        base_diameter=2 * size.base,
        operating_diameter=2 * size.operating,
        tip_diameter=2 * size.tip,
        root_diameter=2 * size.root,
        tip_angle=tip,
        tip_involute=None if tip is None else float(involute(tip)),
        tip_curvature=None if tip is None else size.base * tan(tip),
        pitch_curvature=size.operating * sin(found.angle_w),
        form_angle=form,
        active_angle=active,
        tip_roll=None if tip is None else tan(tip) - start,
        active_roll=tan(active) - start,
        half_angle=size.half_angle,
        arc=2 * size.reference * size.half_angle,
        operating_half_angle=psi_w,
        operating_arc=2 * size.operating * psi_w,
        operating_space=pitch - 2 * size.operating * psi_w,
        tip_half_angle=half,
        tip_arc=arc,
        tip_helix=tip_helix,
        tip_thickness=None if arc is None else arc * cos(tip_helix),
        approach=None if tip is None else sign * size.teeth * (tan(tip) - tan(found.angle_w)) / (2 * pi),
    )


def pressure_at(radius: float, base: float) -> float | None:
    """The transverse pressure angle at a radius; None within the base circle."""
    return None if radius < base else atan2(sqrt((radius - base) * (radius + base)), base)


def helix_at(radius: float, reference: float, helix: float) -> float:
    """The helix angle [rad] at a radius, ``helix`` that at the reference cylinder."""
    return atan(tan(helix) * radius / reference)


def _points(found: MeshPair, side: int) -> tuple[ContactPoint, ...]:
    """Both ends of the contact of the whole flanks, and the pitch point."""
    line = found.line
    if not 0 < line.start < line.end or (found.task.kind == "external" and line.end >= line.length):
        return ()
    at = {"A2": line.start, "P": line.pitch, "A1": line.end}
    table = sliding_at(found, [*at.values()])
    rack = found.task.kind == "rack"
    return tuple(
        ContactPoint(
            name,
            rho1,
            None if rack else line.between - side * rho1,
            float(table.theta1[k]),
            float(table.theta2[k]),
            float(table.pressure[k]),
        )
        for k, (name, rho1) in enumerate(at.items())
    )
