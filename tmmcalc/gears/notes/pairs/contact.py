"""The contact of a pair: the line of action, contact ratios, sliding and specific pressure."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.gears.involute.internal.interference import tip_crossing
from tmmcalc.gears.meshing.geometry import internal_pair
from tmmcalc.gears.notes.pairs.lexicon import Told, angle, length, shortened
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Paragraph

TIP, PITCH_POINT = "rho_a<i> = r_b<i>*tan(alpha_a<i>)", "rho_w<i> = r_w<i>*sin(alpha_tw)"
RACK_PITCH_POINT = "rho_w<i> = r<_i>*sin(<t>)"
BASE_PITCH = "p_b = pi*m*cos(<t>)/cos(beta)"
ENDS = {  # where the active flanks end, and how long the active part of the line of action is
    "external": ("rho_p1 = g - rho_a2", "rho_p2 = g - rho_a1", "g_alpha = rho_a1 + rho_a2 - g"),
    "internal": ("rho_p1 = rho_a2 - g", "rho_p2 = rho_a1 + g", "g_alpha = rho_a1 - rho_a2 + g"),
    "rack": ("rho_p1 = r_1*sin(<t>) - m*(<hr> - x_1)/sin(<t>)", "g_alpha = rho_a1 - rho_p1"),
}
RATIO = "eps_alpha = g_alpha/p_b"
BY_ANGLES = "eps_alpha = (z_1*tan(alpha_a1) <+> z_2*tan(alpha_a2) <-> <z>*tan(alpha_tw))/(2*pi)"
OVERLAP = ("eps_beta = b*sin(beta)/(pi*m)", "eps_gamma = eps_alpha + eps_beta")
LEFT = {  # the contact that undercut and fillets leave
    "external": (
        *("rho_s1 = max(rho_p1, <end1>)", "rho_s2 = g - rho_s1"),
        *("rho_e2 = max(rho_p2, <end2>)", "rho_e1 = g - rho_e2"),
    ),
    "internal": (
        *("rho_s1 = max(rho_p1, <end1>)", "rho_s2 = g + rho_s1"),
        *("rho_e1 = min(rho_a1, rho_F2 - g)", "rho_e2 = g + rho_e1"),
    ),
    "rack": ("rho_s1 = max(rho_p1, <end1>)",),
}
LEFT_RATIO = "eps'_alpha = (<e1> - <s1>)/p_b"
TEETH = "u = z_2/z_1"
SLIDING = ("theta_1 = 1 - <s2>/(u*<s1>)", "theta_2 = 1 - u*<e1>/<e2>")
RACK_SLIDING = ("theta_1 = 1 - rho_w1/<s1>", "theta_2 = 1 - <e1>/rho_w1")
PRESSURE = (
    "lambda_s = m*(1/<s1> <+> 1/<s2>)",
    "lambda_P = m*(1/rho_w1 <+> 1/rho_w2)",
    "lambda_e = m*(1/<e1> <+> 1/<e2>)",
)
RACK_PRESSURE = ("lambda_s = m/<s1>", "lambda_P = m/rho_w1", "lambda_e = m/<e1>")
RACK_LIMITS = (
    "rho_R = rho_w1 + m*(<hl> + x_1)/sin(<t>)",
    "<sna2> = m*(pi/2 - 2*<hr>*tan(alpha))",
)
CLEARANCES = {
    "external": ("c_1 = a_w - r_a2 - r_f1", "c_2 = a_w - r_a1 - r_f2"),
    "internal": ("c_1 = r_a2 - a_w - r_f1", "c_2 = r_f2 - a_w - r_a1"),
    "rack": ("c_1 = H - m*<hr> - r_f1", "c_2 = H + m*(h_a^{*} + c^{*}) - r_a1"),
}
CROSSING = (
    "delta_1 = acos((r_a2**2 - r_a1**2 - a_w**2)/(2*a_w*r_a1))",
    "delta_2 = acos((r_a2**2 + a_w**2 - r_a1**2)/(2*a_w*r_a2))",
    "Gamma = r_a2*((rad(delta_1) + inv(alpha_a1) - inv(alpha_tw))/u - rad(delta_2) - inv(alpha_a2) + inv(alpha_tw))",
)


def contact(told: Told) -> Iterator[Block]:
    """The ends of the contact and the contact ratios."""
    kind = told.found.task.kind
    for wheels in told.shared:
        yield from wheels.lines(TIP)
    yield from told.lines(BASE_PITCH, *ENDS[kind], RATIO)
    if kind != "rack":
        yield Paragraph(tr("The same by the angles at the tips, as a check:"))
        yield from told.lines(BY_ANGLES)
    if told.found.overlap:
        yield from told.lines(*OVERLAP)
    if shortened(told.found):
        yield Paragraph(tr("Undercut or a fillet takes the ends of the flanks from the contact; what is left of it:"))
        yield from told.lines(*LEFT[kind], LEFT_RATIO)


def quality(told: Told) -> Iterator[Block]:
    """Sliding and specific pressure at the ends of the contact and at the pitch point."""
    rack = told.found.task.kind == "rack"
    for wheels in told.shared:
        yield from wheels.lines(RACK_PITCH_POINT if rack else PITCH_POINT)
    if not rack:
        yield from told.lines(TEETH)
    yield from told.lines(*(RACK_SLIDING if rack else SLIDING))
    yield from told.lines(*(RACK_PRESSURE if rack else PRESSURE))
    if rack:
        yield from told.lines(*RACK_LIMITS)


def interference(told: Told) -> Iterator[Block]:
    """Clearances, and what the conditions of internal pairs and of a rack ask for beside the rest."""
    found = told.found
    yield from told.lines(*CLEARANCES[found.task.kind])
    checks = {check.name: check for check in found.checks}
    if "trochoid interference" not in checks:
        return
    pair, m = internal_pair(found), found.task.module
    crossing = tip_crossing(pair)
    margin = length(m * checks["trochoid interference"].margin, tr("distance of the tips outside the line of action"))
    told.lexicon["Gamma"] = margin
    if crossing is None:
        yield from told.lines("Gamma = r_a2 - a_w - r_a1")
        return
    meaning = tr("angle from the line of centres to where the tip circles cross")
    told.lexicon.update(delta_1=angle(crossing[0], meaning), delta_2=angle(crossing[1], meaning))
    yield from told.lines(*CROSSING)
