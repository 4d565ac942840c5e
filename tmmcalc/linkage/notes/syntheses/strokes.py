"""Times, angles and mean speeds of both strokes of a linkage that was found."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.linkage.notes.syntheses.told import NOISE, Told, angle, length, meanings, ratio
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Heading, Paragraph, Result

ANGLES = ("alpha_p = deg(360)*K/(K + 1)", "alpha_x = deg(360)/(K + 1)")
TIMES = ("t_p = t*K/(K + 1)", "t_x = t/(K + 1)")
FAR = {  # the crank at the far end of the stroke
    "slider_crank": "phi_I = asin(e/(l + r))",
    "slotted_link": "phi_I = -phi",
    "rotating_slotted_link": "phi_I = -asin(L/r)",
}
ALIKE = ("t_p = t/2", "t_x = t/2")  # where K = 1


def blocks(told: Told) -> Iterator[Block]:
    """The speed of the crank by the mean speed of the working stroke, or the other way round; times and speeds."""
    times = told.design.times
    if times is None:
        return
    words = meanings()
    turns = times.unit == "rad"
    unit, letter, stroke = ("rad/s", "omega", "rad(Theta)") if turns else ("m/s", "v", "S")
    mean = tr("mean angular velocity on the working stroke") if turns else words["v_p"]
    back = tr("mean angular velocity on the idle stroke") if turns else tr("mean speed on the idle stroke")
    told.give(
        {
            "K": ratio(times.time_ratio, words["K"]),
            "psi": angle(times.overlap, words["psi"]),
            "S": length(times.stroke, words["S"]),
            **told.lexicon,
            "n_1": Given(times.rpm, "rpm", words["n_1"]),
            "t": Given(times.period, "s", tr("time of the cycle")),
            "t_p": Given(times.working_time, "s", tr("time of the working stroke")),
            "t_x": Given(times.idle_time, "s", tr("time of the idle stroke")),
            "alpha_p": angle(times.working_angle, tr("angle of the crank over the working stroke")),
            "alpha_x": angle(times.idle_angle, tr("angle of the crank over the idle stroke")),
            f"{letter}_p": Given(times.working_speed, unit, mean),
            f"{letter}_x": Given(times.idle_speed, unit, back),
            f"{letter}_m": Given(
                times.mean_speed,
                unit,
                tr("mean angular velocity over the cycle") if turns else tr("mean speed over the cycle"),
            ),
        }
    )
    yield Heading(tr("Times and speeds of the strokes"))
    if told.task.crank_speed is None and told.task.working_speed is None:
        yield Paragraph(tr("No speed is given: the crank is taken to turn at 1 rad/s."))
    if told.task.working_speed is not None:
        yield from told.lines("n_1 = 60*v_p/(S*(1 + 1/K))")
    yield from told.lines("t = 60/n_1")
    alike = abs(times.time_ratio - 1) < NOISE
    if alike:
        yield Paragraph(tr("Both strokes take half a turn of the crank:"))
        yield from told.lines(*ALIKE)
    else:
        yield from told.lines(*ANGLES, *TIMES)
    far = FAR.get(told.found.kind)
    if far is not None and not (told.found.kind == "rotating_slotted_link" and told.asked.guide):
        yield Paragraph(tr("At the far and at the near end of the stroke the crank stands at"))
        turned = "deg(180)" if alike else "alpha_p"
        yield from told.lines(far, f"phi_{{II}} = phi_I + {turned}")
    if told.task.working_speed is None:
        yield from told.lines(f"{letter}_p = {stroke}/t_p")
    yield from told.lines(f"{letter}_x = {stroke}/t_x", f"{letter}_m = 2*{stroke}/t")
    yield Result("n_1", told.lexicon["n_1"])
