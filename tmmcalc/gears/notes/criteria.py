"""The choice of the train: masses, inertia, size of the chosen one; all by their criteria, and why it won."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial

import numpy as np

from tmmcalc.gears.criteria.comparison import Comparison
from tmmcalc.gears.criteria.objectives import OBJECTIVES
from tmmcalc.gears.criteria.size import orbits
from tmmcalc.gears.criteria.speeds import speeds
from tmmcalc.gears.criteria.wheels import Build, radii, stage_of, wheels
from tmmcalc.gears.model import ToothSets
from tmmcalc.gears.notes.course import told_best, told_sieve
from tmmcalc.gears.notes.letters import joined, noted, short_train, teeth
from tmmcalc.gears.pictures.front import draw_pareto
from tmmcalc.gears.pictures.words import CRITERIA, layout_word, short_name, teeth_text
from tmmcalc.gears.scheme import CARRIER, Mesh
from tmmcalc.gears.selection.results import Selection
from tmmcalc.gears.selection.solve import assumptions_of
from tmmcalc.gears.selection.task import ROW, WEIGHTED
from tmmcalc.gears.sizing import rows_of
from tmmcalc.gears.tables.tasks.sizing import to_selection
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.formula.digits import RESULT, Given, significant
from tmmcalc.report.language import tr, tr_number, tr_unit
from tmmcalc.report.manuscript import Block, Figure, Heading, Lexicon, Paragraph, Place, Result, Table
from tmmcalc.report.telling import lines, named

MM = 1e3
SHOWN = 12  # trains of the table
PARETO, SIDE, UNDER = (160.0, 118.0), 5.0, 3.0  # size of the picture, and room beside and below its axes [mm]
SHAPES = {  # mass [kg] and inertia [kg*m^2] of a wheel, lengths in mm (4.43), (4.44)
    "pinion": ("M = pi*rho*b*r**2/10**9", "J = M*r**2/(2*10**6)"),
    "wheel": ("M = alpha_M*pi*rho*b*r**2/10**9", "J = alpha_J*M*r**2/(2*10**6)"),
    "ring": ("M = pi*rho*b*h*(2*r + h)/10**9", "J = M*(r**2 + (r + h)**2)/(2*10**6)"),
}


def blocks(order: Order) -> Iterator[Block]:
    """The chosen train by every criterion, then the choice."""
    selection: Selection = order.results["criteria"]
    winner, variant = selection.winner, selection.variants[selection.winner.variant]
    request = order.results["train"].variants[winner.variant].request
    row = int(selection.pool.row[winner.place])
    one = rows_of(variant.sets, np.array([row]))
    to = assumptions_of(request, to_selection(order.spec)).reduced_to or one.scheme.output
    yield Heading(tr("Choice of the train by its criteria"), 2)
    yield Heading(tr("Masses, inertia, size"), 3)
    yield Paragraph(tr("The chosen train: {train}.", train=short_train(one)))
    chosen = _Chosen(selection, one, variant.criteria.centre_distances[row].tolist(), request.task.pressure_angle, to)
    yield from chosen.distances()
    yield from chosen.wheels()
    yield from chosen.sums()
    yield Heading(tr("Comparison and choice"), 3)
    yield from told_sieve(selection, order.results["train"].variants, order.results["strength"].variants)
    yield from _compared(selection)
    yield from _weights(selection)
    for key, found in (("planets", selection.by_planets), ("layouts", selection.by_layouts)):
        yield from _options(key, found)
    yield from _series(selection)
    yield from _why(selection)


class _Chosen:
    """The chosen train with its sizes in mm."""

    def __init__(self, selection: Selection, one: ToothSets, distances: Sequence[float], rack: float, to: str) -> None:
        self.winner, self.one, self.to, self.rack = selection.winner, one, to, rack
        self.scheme, self.build = one.scheme, Build()
        self.module, self.width = (np.array([each]) for each in (self.winner.modules, self.winner.widths))
        self.made = wheels(one, self.module, self.width, self.build)
        self.apart = np.array([distances])
        self.lexicon: Lexicon = teeth({wheel: float(z[0]) for wheel, z in one.by_wheel.items()})
        for k, module in enumerate(self.winner.modules, 1):
            self.lexicon[f"m_{k}"] = Given(MM * module, "mm", tr("module of stage {stage}", stage=k))
        angles = dict(zip(self.scheme.meshes, one.angles[0].tolist(), strict=True))
        self.raised = {mesh: angle for mesh, angle in angles.items() if angle != rack}
        for mesh, value in zip(self.scheme.meshes, distances, strict=True):
            pair = f"{mesh.first}–{mesh.second}"
            self.lexicon[_distance(mesh)] = Given(MM * value, "mm", tr("centre distance of the pair {pair}", pair=pair))
        self.lexicon = named(self.lexicon)

    def lines(self, *texts: str) -> Iterator[Block]:
        """Formulas worked out."""
        return lines(texts, [Place("", self.lexicon)])

    def distances(self) -> Iterator[Block]:
        """Centre distances of the pairs."""
        for mesh in self.scheme.meshes:
            first, second = (f"z_{{{wheel}}}" for wheel in (mesh.first, mesh.second))
            total = f"{first} + {second}"
            if mesh.internal:
                total = f"{first} - {second}" if mesh.first in self.scheme.rings else f"{second} - {first}"
            angle = f"alpha_{{w{joined((mesh.first, mesh.second))}}}"
            stretch = f"*cos(alpha)/cos({angle})" if mesh in self.raised else ""
            if mesh in self.raised:
                said = tr("operating pressure angle of the pair {pair}", pair=f"{mesh.first}–{mesh.second}")
                found = {angle: Given(float(np.degrees(self.raised[mesh])), "deg", said)}
                found["alpha"] = Given(float(np.degrees(self.rack)), "deg", tr("profile angle of the rack"))
                self.lexicon |= named(found)
            yield from self.lines(f"{_distance(mesh)} = m_{mesh.stage + 1}*({total})/2{stretch}")

    def wheels(self) -> Iterator[Block]:
        """Radius, mass and inertia of each moving wheel."""
        yield Paragraph(
            tr(
                "Pinions are solid cylinders of their reference diameter, wheels are webbed, lighter by $alpha_M$ and "
                "with their mass farther out by $alpha_J$; the carrier and the shafts are neglected."
            )
        )
        made = self.made
        places: dict[str, list[Place]] = {}
        every: list[Place] = []
        for wheel, part in self.scheme.moving.items():
            stage, column = stage_of(self.one, wheel), self.scheme.index(wheel)
            values = {
                "z": (float(self.one.of(wheel)[0]), "", tr("number of teeth of the wheel")),
                "m": (MM * float(self.module[0, stage]), "mm", tr("module")),
                "b": (MM * float(self.width[0, stage]) * part.widths, "mm", tr("face width")),
                "h": (MM * self.build.rim * float(self.module[0, stage]), "mm", tr("depth of the ring and its rim")),
                "r": (MM * float(radii(self.one, self.module)[0, column]), "mm", tr("reference radius")),
                "rho": (self.build.density, "kg/m^3", tr("density of steel")),
                "alpha_M": (self.build.webbed_mass, "", tr("coefficient of the mass of a webbed wheel")),
                "alpha_J": (self.build.webbed_inertia, "", tr("coefficient of the inertia of a webbed wheel")),
                "M": (float(made.masses[0, column]), "kg", tr("mass of the wheel")),
                "J": (float(made.inertias[0, column]), "kg*m^2", tr("moment of inertia of the wheel about its axis")),
            }
            own = named({name: Given(*value) for name, value in values.items()})
            every.append(Place(tr("for wheel {wheel}", wheel=wheel), own))
            places.setdefault(part.shape, []).append(every[-1])
        yield from lines(["r = m*z/2"], every)
        for shape, of_shape in places.items():
            yield from lines(SHAPES[shape], of_shape)

    def sums(self) -> Iterator[Block]:
        """Mass of all, inertia reduced to a shaft, size, inertia on the crank."""
        scheme, winner, made = self.scheme, self.winner, self.made
        moving = [scheme.index(wheel) for wheel in scheme.moving]
        turning = speeds(self.one, self.to)
        planets = [wheel for wheel in scheme.planets if scheme.planetary]
        circles = orbits(self.one, self.apart)
        carried = float(turning.of(CARRIER)[0])
        found: dict[str, tuple[float | list[float], str, str]] = {
            "n_j": ([float(made.numbers[k]) for k in moving], "", tr("number of wheels {wheels}", wheels="$j$")),
            "M_j": ([float(made.masses[0, k]) for k in moving], "kg", tr("mass of the wheel")),
            "J_j": (
                [float(made.inertias[0, k]) for k in moving],
                "kg*m^2",
                tr("moment of inertia of the wheel about its axis"),
            ),
            "i_j": (
                [float(turning.of(scheme.wheels[k])[0]) for k in moving],
                "",
                tr("speed of the wheel over that of the shaft {shaft}", shaft=self.to),
            ),
            "M_p": ([float(made.masses[0, scheme.index(wheel)]) for wheel in planets], "kg", tr("mass of a planet")),
            "a_p": (
                [MM * float(circles[wheel][0]) for wheel in planets],
                "mm",
                tr("radius of the circle of its axis"),
            ),
            "K": (float(self.one.planets), "", tr("number of planets")),
            "i_H": (carried, "", tr("speed of the carrier over that of the shaft {shaft}", shaft=self.to)),
            "M_Σ": (winner.values["mass"], "kg", tr("mass of the moving wheels")),
            "J_Σ": (winner.inertia, "kg*m^2", tr("inertia reduced to the shaft {shaft}", shaft=self.to)),
            "D": (MM * winner.values["size"], "mm", tr("size of the train")),
            "i_c": (winner.beyond, "", tr("speed of the output shaft over that of the crank")),
            "J_c": (winner.on_crank, "kg*m^2", tr("inertia reduced to the crank")),
        }
        self.lexicon |= named({name: Given(*value) for name, value in found.items()})
        yield Paragraph(tr("The moving wheels are in table {tab}.", tab="{tab:criteria_wheels}"))
        yield self._table(moving)
        yield from self.lines("M_Σ = sum(n_j*M_j, j)")
        whole = "J_Σ = sum(n_j*J_j*i_j**2, j)"
        if planets:
            turn = "" if carried == 1 else "*i_H**2"
            whole += f" + K{turn}*sum(M_p*a_p**2, p)/10**6"
        yield from self.lines(whole)
        if winner.beyond != 1:
            yield from self.lines("J_c = J_Σ*i_c**2")
        lone = scheme.lone_size_letters if self.one.planets == 1 else ""
        yield from self.lines(f"D = {noted(lone or scheme.size_letters)}")
        for name in ("M_Σ", "J_Σ", "D"):
            yield Result(name, self.lexicon[name])

    def _table(self, moving: Sequence[int]) -> Table:
        """The moving wheels."""
        numbers = [self.lexicon[name].value for name in ("M_j", "J_j", "i_j")]
        rows = []
        for k, column in enumerate(moving):
            cells = (f"${significant(values[k], RESULT)}$" for values in numbers if isinstance(values, Sequence))
            rows.append((self.scheme.wheels[column], f"{self.made.numbers[column]:.0f}", *cells))
        head = (tr("Wheel"), "$n_j$", f"$M_j$, {tr_unit('kg')}", f"$J_j$, {tr_unit('kg*m^2')}", "$i_j$")
        return Table(tr("Moving wheels"), head, tuple(rows), "criteria_wheels")


def _distance(mesh: Mesh) -> str:
    return f"a_{{{joined((mesh.first, mesh.second))}}}"


def _shown(key: str, value: float) -> str:
    """A criterion with its unit."""
    factor, unit = CRITERIA[key]
    return f"{tr_number(significant(factor * value, RESULT))} {tr_unit(unit)}".strip()


def _head(key: str) -> str:
    unit = CRITERIA[key][1]
    return short_name(key) + (f", {tr_unit(unit)}" if unit else "")


def _compared(selection: Selection) -> Iterator[Block]:
    """How many trains there are, the front, the best by each criterion."""
    pool, objectives = selection.pool, selection.objectives
    told = {"count": len(pool), "front": len(selection.front), "criteria": ", ".join(map(short_name, objectives))}
    yield Paragraph(
        tr(
            "{count} trains are strong enough; they are numbered by themselves, as the rows of the tables, and "
            "compared by: {criteria}. The Pareto front has {front} of them: no other train is better in all of these "
            "criteria (figure {fig}, table {tab}).",
            fig="{fig:criteria_front}",
            tab="{tab:criteria_front}",
            **told,
        )
    )
    yield Figure(tr("Mass and inertia of the trains"), partial(_front, found=selection), PARETO, "criteria_front")
    rows = [row for row in selection.front.tolist() if row != selection.winner.place]
    shown = [selection.winner.place, *rows][:SHOWN]
    body = tuple(_train(selection, row) for row in shown)
    yield Table(tr("The chosen train, then the Pareto front"), _heads(selection), body, "criteria_front")
    for each in selection.minima:
        said = {"criterion": short_name(each.criterion), "value": _shown(each.criterion, each.value)}
        teeth = _sizes(selection, each.winner)[1]
        yield Paragraph(tr("The best {criterion}: {value}, train {teeth}.", teeth=teeth, **said))


def _heads(selection: Selection) -> tuple[str, ...]:
    """Over the cells of one train."""
    objectives = map(_head, selection.objectives)
    return tr("Row"), tr("Train"), "$m$, " + tr_unit("mm"), "$b$, " + tr_unit("mm"), *objectives


def _train(selection: Selection, row: int) -> tuple[str, ...]:
    """One train: its row, teeth, modules, widths, criteria."""
    return (*_sizes(selection, row), *_criteria(selection, row))


def _front(drawing: Drawing, box: Box, found: Selection) -> None:
    draw_pareto(drawing, box.inset(SIDE, UNDER, 0, 0), found, found.winner.place)


def _sizes(selection: Selection, row: int) -> tuple[str, ...]:
    """Row, layout with teeth, modules, widths of one train."""
    pool = selection.pool
    at, place = int(pool.variant[row]), int(pool.row[row])
    of = selection.variants[at]
    several = len({each.sets.layout for each in selection.variants}) > 1
    name = teeth_text(of.sets.teeth[place].tolist())
    sizes = [
        "; ".join(tr_number(significant(MM * value, RESULT)) for value in values[place].tolist())
        for values in (of.module, of.width)
    ]
    return str(row + 1), f"{layout_word(of.sets.layout)} {name}" if several else name, *sizes


def _criteria(selection: Selection, row: int) -> tuple[str, ...]:
    """The objectives of one train."""
    pool = selection.pool
    values = ((key, CRITERIA[key][0] * float(getattr(pool, key)[row])) for key in selection.objectives)
    return tuple(tr_number(significant(value, RESULT)) for _, value in values)


def _weights(selection: Selection) -> Iterator[Block]:
    """The weighted sum of the chosen train, where weights chose it."""
    if selection.choose != WEIGHTED:
        return
    pool, place = selection.pool, selection.winner.place
    columns = {key: np.asarray(getattr(pool, key)) * CRITERIA[key][0] for key in selection.ranking.weights}
    used = [key for key, values in columns.items() if np.ptp(values) > 0]
    best = {key: max if OBJECTIVES[key].largest else min for key in used}
    worst = {key: min if OBJECTIVES[key].largest else max for key in used}
    lexicon = named(
        {
            "S": Given(float(selection.ranking.scores[place]), "", tr("weighted sum of the criteria")),
            "w_j": Given([selection.ranking.weights[key] for key in used], "", tr("weight of the criterion")),
            "x_j": Given([float(columns[key][place]) for key in used], "", tr("value of the criterion")),
            "b_j": Given([float(best[key](columns[key])) for key in used], "", tr("its best value of all trains")),
            "c_j": Given([float(worst[key](columns[key])) for key in used], "", tr("its worst value of all trains")),
        }
    )
    yield Paragraph(tr("The trains are ranked by {criteria}:", criteria=", ".join(map(_head, used))))
    yield from lines(["S = sum(w_j*(x_j - b_j)/(c_j - b_j), j)"], [Place("", lexicon)])


def _options(key: str, found: Sequence[Comparison]) -> Iterator[Block]:
    """Numbers of planets, or layouts, each by the best value of every criterion."""
    if not found:
        return
    caption = tr("Numbers of planets") if key == "planets" else tr("Layouts")
    rows = []
    for k, option in enumerate(found[0].options):
        values = [
            _shown(each.criterion, each.options[k].values[each.criterion]) if each.options[k].values else "–"
            for each in found
        ]
        rows.append(
            (" + ".join(layout_word(part) for part in str(option.option).split(" + ")), str(option.count), *values)
        )
    tab = f"{{tab:criteria_{key}}}"
    yield Paragraph(tr("The best values by option are in table {tab}.", tab=tab))
    head = (tr("Option"), tr("Trains"), *(short_name(each.criterion) for each in found))
    yield Table(caption, head, tuple(rows), f"criteria_{key}")


def _series(selection: Selection) -> Iterator[Block]:
    """Two trains in series in place of one."""
    pairs = selection.pairs
    if pairs is None or pairs.best is None:
        return
    ratio = tr_number(significant(float(pairs.single), RESULT))
    told = {"ratio": ratio, "planets": pairs.planets, "admitted": pairs.admitted, "tried": pairs.tried}
    yield Paragraph(
        tr(
            "In place of one train two with single planets in series are looked at, each of the ratio {ratio} with "
            "{planets} planets: of {tried} pairs {admitted} are within the tolerance.",
            **told,
        )
    )
    best = "; ".join(f"{short_name(key)} {_shown(key, value)}" for key, value in pairs.best.items())
    said = tr("Their best values: {values}.", values=best)
    yield Paragraph(f"{said} {tr('They are for comparison; the choice is among single trains.')}")


def _why(selection: Selection) -> Iterator[Block]:
    """What decided."""
    winner, reason = selection.winner, selection.reason
    row = int(selection.pool.row[winner.place])
    name = short_train(rows_of(selection.variants[winner.variant].sets, np.array([row])))
    sizes = [
        tr_number("; ".join(significant(MM * value, RESULT) for value in each))
        for each in (winner.modules, winner.widths)
    ]
    told = {"name": name, "modules": sizes[0], "widths": sizes[1]}
    if reason.criterion in CRITERIA:
        told |= {"criterion": short_name(reason.criterion), "value": _shown(reason.criterion, reason.value)}
        said = tr("By the criterion “{criterion}” the train {name} is chosen: {value}.", **told)
    elif selection.choose == WEIGHTED:
        said = tr("By the least weighted sum the train {name} is chosen.", **told)
    else:
        said = tr("The train {name} is chosen as the task asks.", **told)
    if reason.tied and selection.choose != ROW:
        said += " " + tr("Others as good by it: {tied}; the first in the list is taken.", tied=reason.tied)
    elif reason.runner_up_value is not None and reason.criterion in CRITERIA:
        said += " " + tr("The next best has {value}.", value=_shown(reason.criterion, reason.runner_up_value))
    elif reason.runner_up_value is not None and selection.choose == WEIGHTED:
        value = tr_number(significant(reason.runner_up_value, RESULT))
        said += " " + tr("The next best has {value}.", value=value)
    yield Paragraph(f"{said} " + tr("Its modules are {modules} mm, its face widths {widths} mm.", **told))
    yield from told_best(selection, partial(_train, selection), _heads(selection))
