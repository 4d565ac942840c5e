"""The start of the count, the extreme positions of the outputs, their strokes and the time ratio."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from tmmcalc.linkage.notes import extremes
from tmmcalc.linkage.notes.group import length, plain_name
from tmmcalc.linkage.notes.told import Told
from tmmcalc.linkage.pictures.cycle import TURN, along, closed
from tmmcalc.linkage.pictures.pieces import of_scheme
from tmmcalc.linkage.results import Kinematics, OutputSummary
from tmmcalc.report.drawing.lettering import point_name
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.formula.setting import spelt
from tmmcalc.report.formula.symbols import canonical
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.manuscript import Block, Lexicon, Paragraph, Place, Result
from tmmcalc.report.numbers import number
from tmmcalc.report.telling import lines, named, pictured, tabulated, titled

ROMAN = ("I", "II", "III", "IV", "V", "VI", "VII", "VIII")
ENDS = ("I", "{II}")
SAME = 1e-9  # [rad or m] of an extreme position that is position 0


def blocks(told: Told) -> Iterator[Block]:
    """The scheme in its positions, then the extreme positions of every output."""
    result = told.result
    yield Paragraph(tr("The mechanism is drawn in its positions in figure {fig:linkage_scheme}."))
    yield pictured(of_scheme(result, told.cycle, told.rows[0]), key="linkage_scheme")
    yield Paragraph(_counted(told))
    for k, summary in enumerate(result.summaries):
        if summary.dead_centres:
            yield from _extremes(told, summary, f"extremes_{k}")


def _counted(told: Told) -> str:
    """Where the count of the positions begins, and their steps."""
    result = told.result
    first, name = float(result.x[0]), f"$phi_{result.structure.input_link}$" if result.turns else "$s_0$"
    value = f"{number(math.degrees(first), 5)}°" if result.turns else f"{number(first, 5)} {tr_unit('m')}"
    words = {"name": name, "value": spelt(value)}
    centre = result.summaries[0].dead_centres if result.summaries else ()
    if centre and abs(math.remainder(centre[0].x - first, TURN) if result.turns else centre[0].x - first) < SAME:
        words["output"] = plain_name(result.summaries[0].name)
        if result.summaries[0].angular:
            return tr("Position 0 is the extreme position of link {output} at {name} = {value}.", **words)
        return tr("Position 0 is the extreme position of {output} at {name} = {value}.", **words)
    return tr("The positions are counted from that at {name} = {value}.", **words)


def _extremes(told: Told, summary: OutputSummary, key: str) -> Iterator[Block]:
    """The extreme positions of an output as a table, where they lie, the stroke, the angles of the strokes."""
    result, centres = told.result, summary.dead_centres
    full = closed(told.chain)
    counted = np.array([along(result, centre.x, full) for centre in centres])
    x, values = np.array(extremes.inputs_of(told, summary)), _values(summary)
    name, index = plain_name(summary.name), result.structure.input_link
    angles = np.degrees if result.turns else np.asarray
    heads = (f"$phi_{index}$, deg", "$phi$, deg") if result.turns else ("$s$, m", "$Deltas$, m")
    own = f"$phi_{{{name}}}$, deg" if summary.angular else f"$s_{{{name}}}$, m"
    caption = (
        tr("Extreme positions of link {output}", output=name)
        if summary.angular
        else tr("Extreme positions of {output}", output=titled(point_name(name)))
    )
    columns = dict(zip((*heads, own), (angles(x), angles(counted), values), strict=True))
    yield Paragraph(
        tr("The extreme positions of link {output} are in table {table}.", output=name, table=f"{{tab:{key}}}")
        if summary.angular
        else tr("The extreme positions of {output} are in table {table}.", output=name, table=f"{{tab:{key}}}")
    )
    yield tabulated(caption, columns, ROMAN[: len(centres)], head=tr("Extreme position"), key=key)
    lexicon: Lexicon = dict(told.lexicons[0])
    place = (Place("", lexicon),)
    if result.turns and full:
        yield from extremes.lines_of(told, summary, lexicon)
    if len(centres) == 2 and summary.stroke is not None:
        lexicon |= named(_stroke(summary, name, values))
        left = f"psi_{{{name}}}" if summary.angular else f"H_{{{name}}}"
        letter = "phi" if summary.angular else "s"
        yield from lines([f"{left} = abs({letter}_{{{name}}}^{{II}} - {letter}_{{{name}}}^I)"], place)
        yield Result(left, lexicon[canonical(left)])
    if summary.working_angle is not None and summary.idle_angle is not None and summary.time_ratio is not None:
        names = _names(result, name)
        lexicon |= named(_angles(told, summary, names))
        ends = f"phi_{index}^{{II}} - phi_{index}^I" if result.speed > 0 else f"phi_{index}^I - phi_{index}^{{II}}"
        texts = (f"{names[0]} = {ends}", f"{names[1]} = {names[0]}/(deg(360) - {names[0]})")
        yield from lines(texts, place)
        yield Result(names[1], lexicon[canonical(names[1])])


def _names(result: Kinematics, name: str) -> tuple[str, str]:
    """The angle from the first extreme position to the second one, and the time ratio."""
    if len(result.summaries) == 1:
        return "phi_{I,II}", "K"
    return f"phi_{{I,II}}^{{{name}}}", f"K_{{{name}}}"


def _values(summary: OutputSummary) -> np.ndarray:
    """Coordinates [m] or angles [deg] of the output in its extreme positions, as far apart as the stroke."""
    values = np.array([each.value for each in summary.dead_centres])
    if not summary.angular:
        return values
    if len(values) == 2 and summary.stroke is not None:
        far = values[0] + np.array([summary.stroke, -summary.stroke])
        values[1] = min(far, key=lambda one: abs(math.remainder(one - values[1], TURN)))
    return np.degrees(values)


def _stroke(summary: OutputSummary, name: str, values: np.ndarray) -> Lexicon:
    assert summary.stroke is not None
    if summary.angular:
        said = tr("extreme angle of link {output}", output=name)
        stroke = Given(math.degrees(summary.stroke), "deg", tr("swing of link {output}", output=name))
        ends = {f"phi_{{{name}}}^{mark}": Given(float(v), "deg", said) for mark, v in zip(ENDS, values, strict=True)}
        return {f"psi_{{{name}}}": stroke, **ends}
    said = tr("extreme coordinate of {output}", output=name)
    ends = {f"s_{{{name}}}^{mark}": length(v, said) for mark, v in zip(ENDS, values, strict=True)}
    return {f"H_{{{name}}}": length(summary.stroke, tr("stroke of {output}", output=name)), **ends}


def _angles(told: Told, summary: OutputSummary, names: tuple[str, str]) -> Lexicon:
    """The angles of the crank over the strokes, the second extreme position after the first."""
    assert summary.working_angle is not None
    assert summary.time_ratio is not None
    index, (first, second) = told.result.structure.input_link, extremes.inputs_of(told, summary)
    said = tr("angle of the crank in an extreme position")
    return {
        f"phi_{index}^I": Given(math.degrees(first), "deg", said),
        f"phi_{index}^{{II}}": Given(math.degrees(second), "deg", said),
        names[0]: Given(math.degrees(summary.working_angle), "deg", tr("angle of the crank over the working stroke")),
        names[1]: Given(summary.time_ratio, "", tr("time ratio, working stroke over idle stroke")),
    }
