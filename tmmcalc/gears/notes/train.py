"""The search for tooth numbers: the ratio and its split, the sets that were found; of the chosen one all conditions,
its speeds and plans, its efficiency and torques."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import partial

import numpy as np

from tmmcalc.gears.chosen.choice import Chosen
from tmmcalc.gears.chosen.motion import Moving
from tmmcalc.gears.columns import ratios
from tmmcalc.gears.criteria.efficiency import MeshEfficiency
from tmmcalc.gears.details import searched_trains
from tmmcalc.gears.gearing import Gearing, solve_gearing
from tmmcalc.gears.gearingtask import layout_task
from tmmcalc.gears.notes.conditions import told_conditions
from tmmcalc.gears.notes.course import told_search
from tmmcalc.gears.notes.letters import asked_ratio, joined, letter, lowered, short_train, teeth_of
from tmmcalc.gears.notes.speeds import Told, ends_of, told_motion, told_speeds
from tmmcalc.gears.notes.torques import told_torques
from tmmcalc.gears.pictures.pieces import motion_piece
from tmmcalc.gears.pictures.placed import placed
from tmmcalc.gears.pictures.scheme import draw_scheme
from tmmcalc.gears.pictures.words import KINDS, layout_name, train_name
from tmmcalc.gears.proportion import equal_strength
from tmmcalc.gears.scheme import CARRIER
from tmmcalc.gears.search.measures import coprime_meshes
from tmmcalc.gears.selection.results import Selection
from tmmcalc.gears.split import equal_diameters, exponents
from tmmcalc.gears.tables.tasks.sizing import to_selection
from tmmcalc.gears.trains import Request, Variant
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.digits import Given, significant
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.language import tr, tr_number
from tmmcalc.report.manuscript import Block, Display, Figure, Heading, Paragraph, Place, Result, Table
from tmmcalc.report.telling import lines, named, tabulated, titled

FIRST = 10  # sets of the table
DIGITS = 6  # of numbers in sentences
SCHEME = (160.0, 130.0)  # of the train from two sides [mm]
PLANS = (160.0, 190.0)  # of the scheme with its plans


def blocks(order: Order) -> Iterator[Block]:
    """The search and the train that criteria chose; without criteria the first set of every variant."""
    variants, selection = order.results["train"].variants, order.results.get("criteria")
    results = order.results
    if "drive" in results and "power" not in results:
        results = {**results, "power": order.solved("power")}
    meshes = to_selection(order.spec).meshes
    trains = [found for _, found in searched_trains(order.spec, results, 1)]
    widths = () if selection is None else selection.winner.widths
    for k, variant in enumerate(variants):
        own = next((found for found in trains if _of(found) is variant.request), None)
        yield from _searched(variant, None if own is None else own.chosen, selection, f"train{k}")
        if own is not None:
            torque = results["strength"].variants[k].torque.value if "strength" in results else None
            yield from _chosen(own, meshes, torque, widths, f"train{k}", several=len(trains) > 1)


def _of(found: Moving) -> Request | None:
    return None if found.chosen is None else found.chosen.request


def _searched(variant: Variant, chosen: Chosen | None, selection: Selection | None, key: str) -> Iterator[Block]:
    """What is asked of a layout and what was found."""
    request, synthesis = variant.request, variant.synthesis
    yield Heading(
        tr("Numbers of teeth: {layout}", layout=lowered(layout_name(request.scheme, request.task.planets))), 2
    )
    yield from _asked(request)
    if not request.scheme.branched and not request.scheme.planetary:
        yield from _split(request, selection)
    elif request.scheme.stepped and request.task.nominal > 1:
        yield from _proportion(request)
    if request.task.teeth is None:
        yield from told_search(variant, key)
    if synthesis.count > 1:
        yield from _sets(variant, chosen, selection, key)


def _asked(request: Request) -> Iterator[Block]:
    """The ratio and its tolerance, the tooth ratio that follows."""
    kind, nominal = asked_ratio(request.kind), float(request.nominal)
    low, high, value = (_number(float(x)) for x in (request.admitted.low, request.admitted.high, nominal))
    said = {"ratio": f"${kind}$ = {value}", "low": low, "high": high}
    if request.origin:
        yield Paragraph(tr("The speeds of the machine ask for the ratio {ratio}; {low} to {high} is admitted.", **said))
    else:
        yield Paragraph(tr("The ratio that is asked for is {ratio}; {low} to {high} is admitted.", **said))
    if request.kind in ("i_1H", "i_H1"):
        lexicon = named(
            {
                kind: Given(nominal, "", tr("ratio that is asked for")),
                "U": Given(float(request.task.nominal), "", tr("ratio of the numbers of teeth")),
            }
        )
        own = kind if request.kind == "i_1H" else f"1/{kind}"
        text = f"U = {own} - 1" if request.scheme.sign > 0 else f"U = 1 - {own}"
        yield from lines([text], [Place("", lexicon)])


def _split(request: Request, selection: Selection | None) -> Iterator[Block]:
    """How the ratio falls to the stages for wheels of equal diameter, and for the least mass, inertia, size."""
    stages, whole = request.scheme.stages, float(request.task.nominal)
    found = equal_diameters(whole, stages)
    yield Paragraph(tr("With equal pinions the wheels are of equal diameter if the ratio is split so:"))
    lexicon = named({"U": Given(whole, "", tr("ratio that is asked for"))})
    texts = []
    for k, power in enumerate(exponents(stages), 1):
        said = tr("ratio of stage {stage}", stage=k)
        lexicon |= named({f"u_{k}": Given(float(found.ratios[k - 1]), "", said)})
        texts.append(f"u_{k} = U**({power})")
    yield from lines(texts, [Place("", lexicon)])
    guide = next((each for each in selection.guides if each.layout == request.task.layout), None) if selection else None
    if guide is not None and len(guide.splits) > 1:
        yield Paragraph(tr("Other criteria split it as in table {tab}.", tab="{tab:split}"))
        columns = {f"$u_{k}$": [each.ratios[k - 1] for each in guide.splits] for k in range(1, stages + 1)}
        labels = [_split_name(each.criterion) for each in guide.splits]
        yield tabulated(
            tr("Splits of the ratio between the stages"), columns, labels, head=tr("Criterion"), key="split"
        )


def _split_name(criterion: str) -> str:
    return {
        "mass": tr("least mass"),
        "inertia": tr("least inertia"),
        "size": tr("least size"),
    }.get(criterion, tr("equal diameters"))


def _proportion(request: Request) -> Iterator[Block]:
    """The modules' proportion of equal strength, before numbers of teeth are known."""
    whole, internal = float(request.task.nominal), bool(request.scheme.rings)
    found = equal_strength(whole, internal=internal)
    sign = "-" if internal else "+"
    yield Paragraph(
        tr(
            "The modules stand well if both stages are equally loaded in contact. With the least numbers of teeth "
            "of the pinions the ratio of the modules $mu^{*} = m_2/m_1$ and the ratios of the stages follow from"
        )
    )
    yield Display(read(f"u_1 + 1 = mu^{{*}}*(u_2 {sign} 1)"))
    lexicon = named(
        {
            "U": Given(whole, "", tr("ratio of the numbers of teeth")),
            "u_1": Given(float(found.first[0]), "", tr("ratio of stage {stage}", stage=1)),
            "u_2": Given(float(found.second[0]), "", tr("ratio of stage {stage}", stage=2)),
            "mu^{*}": Given(float(found.modules[0]), "", tr("ratio of the modules of equal strength")),
        }
    )
    yield from lines(["u_2 = U/u_1", "mu^{*} = (u_1**2/u_2)**(1/4)"], [Place("", lexicon)])


def _number(value: float) -> str:
    return tr_number(significant(value, DIGITS)).replace("-", "−")


def _sets(variant: Variant, chosen: Chosen | None, selection: Selection | None, key: str) -> Iterator[Block]:
    """The first sets, and the chosen one if it is not among them."""
    request, sets = variant.request, variant.sets
    rows = [*range(min(FIRST, len(sets)))]
    own = -1
    if chosen is not None:
        same = (sets.teeth == chosen.sets.teeth).all(axis=1) & (sets.modules == chosen.sets.modules).all(axis=1)
        own = int(np.flatnonzero(same)[0])
        rows = sorted({*rows, own})
    tab = f"{{tab:{key}_sets}}"
    said = tr("The first sets by $z_1 + z_2$ are listed in table {tab}.", tab=tab)
    if chosen is not None:
        told = {"number": own + 1, "count": variant.synthesis.count}
        chose = tr("The criteria chose set {number} of {count}; it is worked out here.", **told)
        least = tr("Further on set {number} of {count} is taken, that of the least $z_1 + z_2$.", **told)
        said += " " + (least if selection is None else chose)
    yield Paragraph(said)
    ratio, error = ratios(request, sets)
    parts = sets.modules[rows]
    proportion = request.scheme.branched and request.scheme.stages > 1
    coprime = coprime_meshes(sets)
    yield Table(
        tr("Sets of numbers of teeth"),
        (
            tr("Set"),
            *(f"${teeth_of(wheel)}$" for wheel in request.scheme.wheels),
            *(["$m_1$:$m_2$"] if proportion else []),
            f"${KINDS[request.kind]}$",
            tr("Error, %"),
            tr("Coprime"),
        ),
        tuple(
            (
                str(row + 1),
                *map(str, sets.teeth[row].tolist()),
                *([":".join(map(str, part))] if proportion else []),
                _number(float(ratio[row])),
                tr_number(f"{100 * float(error[row]):.3f}").replace("-", "−"),
                tr("yes") if coprime[row] else tr("no"),
            )
            for row, part in zip(rows, parts.tolist(), strict=True)
        ),
        f"{key}_sets",
    )


def _chosen(
    moving: Moving, meshes: MeshEfficiency, torque: float | None, widths: tuple[float, ...], key: str, *, several: bool
) -> Iterator[Block]:
    """Everything of one set."""
    chosen = moving.chosen
    assert chosen is not None
    yield Heading(titled(train_name(chosen.sets)), 2)
    yield from told_conditions(chosen, f"{key}_conditions")
    yield from _reached(chosen, several=several)
    yield Paragraph(tr("Figure {fig} shows the train from two sides.", fig=f"{{fig:{key}_scheme}}"))
    yield _scheme(chosen, widths, f"{key}_scheme")
    found = _driven(moving, meshes, torque)
    told = told_motion(Moving(found.task, found.motion, chosen, moving.remarks))
    yield from told_speeds(told, f"{key}_speeds")
    yield from told_plans(told.moving, f"{key}_plans")
    yield from _efficiency(told, found, chosen)
    if found.task.torques or chosen.sets.scheme.three_centrals:
        yield from told_torques(told, found, f"{key}_meshes", sized=torque is not None)


def _reached(chosen: Chosen, *, several: bool) -> Iterator[Block]:
    """The ratio with its error among the main results."""
    request = chosen.request
    if request is None:
        return
    ratio, error = (float(each[0]) for each in ratios(request, chosen.sets))
    nominal = float(request.nominal)
    most = 100 * max(abs(float(end) / nominal - 1) for end in (request.admitted.low, request.admitted.high))
    train = short_train(chosen.sets) if several else ""
    yield Result(KINDS[request.kind], Given(ratio, "", tr("ratio of the train")), place=train)
    yield Result("delta", Given(100 * abs(error), "%", tr("error of the ratio")), most, "<=", train)


def _driven(moving: Moving, meshes: MeshEfficiency, torque: float | None) -> Gearing:
    """The train with the losses of its meshes, under the torque on wheel 1 where that drives."""
    chosen = moving.chosen
    assert chosen is not None
    scheme = chosen.sets.scheme
    etas = [meshes.internal if mesh.internal else meshes.external for mesh in scheme.meshes]
    driver, speed = next((name, value) for name, value in moving.task.speeds.items() if value)
    teeth = chosen.sets.teeth[0].tolist()
    task = layout_task(scheme.key, teeth, chosen.sets.planets, {driver: speed}, efficiency=etas)
    return solve_gearing(replace(task, torques={"1": torque}) if torque is not None and driver == "1" else task)


def told_plans(moving: Moving, key: str) -> Iterator[Block]:
    """The scheme with the plans of velocities and of speeds."""
    yield Paragraph(
        tr(
            "Figure {fig} shows the plan of velocities, in which every link has a straight line through the ends of "
            "the velocities of its points, and the plan of speeds with rays parallel to these lines.",
            fig=f"{{fig:{key}}}",
        )
    )
    caption = tr("Kinematic scheme, plans of velocities and of speeds")
    yield Figure(caption, motion_piece(moving).draw, PLANS, key)


def _scheme(chosen: Chosen, widths: tuple[float, ...], key: str) -> Figure:
    """The train to scale from two sides."""
    modules, width = (np.array(each) if each else None for each in (chosen.modules, widths))
    driver = CARRIER if chosen.request is not None and chosen.request.kind == "i_H1" else "1"
    rack, addendum = chosen.task.pressure_angle, float(chosen.task.addendum)
    train = placed(chosen.sets, 0, modules, width, rack=rack, addendum=addendum, driver=driver)
    return Figure(tr("The train from two sides, to scale"), partial(draw_scheme, train=train), SCHEME, key)


def _efficiency(told: Told, found: Gearing, chosen: Chosen) -> Iterator[Block]:
    """The efficiency by its closed formula; that of three central wheels is found with the torques."""
    scheme = chosen.sets.scheme
    if scheme.three_centrals or not found.ways:
        return
    yield Heading(tr("Efficiency"), 3)
    product = []
    for mesh, own in zip(scheme.meshes, found.task.network.meshes, strict=True):
        name = f"eta_{{{joined((mesh.first, mesh.second))}}}"
        pair = f"{mesh.first}–{mesh.second}"
        told.lexicon.update(named({name: Given(own.efficiency, "", tr("efficiency of the mesh {mesh}", mesh=pair))}))
        product.append(name)
    way, basic = found.ways[0], found.basic
    if basic is None or way.formula is None:
        told.lexicon.update(named({"eta": Given(way.efficiency, "", tr("efficiency of the train"))}))
        yield from told.lines(f"eta = {'*'.join(product)}")
        return
    i = letter("i_1H")
    exact = way.ratio if way.driver == "1" else 1 / way.ratio
    told.lexicon.update(
        named(
            {
                "eta_0": Given(basic.efficiency, "", tr("efficiency of the train with the carrier stopped")),
                "eta": Given(way.formula, "", tr("efficiency of the train")),
                i: Given(float(exact), "", tr("ratio of the train")),
            }
        )
    )
    yield from told.lines(f"eta_0 = {'*'.join(product)}")
    pair_of_ends = ends_of(told.moving)
    if way.driver != "1" and pair_of_ends is not None:
        yield from told.lines(f"{i} = 1/i_{{{joined(pair_of_ends)}}}")
    yield from told.lines(f"eta = {_formula(way.driver, 0 < exact < 1, i)}")
    yield Result("eta", told.lexicon["eta"])
    if way.self_locking:
        yield Paragraph(tr("The train locks itself in this direction."))


def _formula(driver: str, slow: bool, i: str) -> str:
    """The efficiency of a planetary train of two central wheels (table 4.6)."""
    if driver == "1":
        return f"(1 - (1 - {i})/eta_0)/{i}" if slow else f"(1 - eta_0*(1 - {i}))/{i}"
    return f"{i}/(1 - eta_0*(1 - {i}))" if slow else f"{i}/(1 - (1 - {i})/eta_0)"
