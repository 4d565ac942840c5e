"""A grab transloader: speeds of its ways, what is usual, loads by case; then its stresses."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial

from tmmcalc.extras.loadcases import CASES, PARTS_OF_MASS, SERIES
from tmmcalc.extras.notes.grabdata import KILO, LETTERS, hoist_way, sizes, trolley_way, usual_speed, whole, wind_data
from tmmcalc.extras.notes.grabstresses import stresses
from tmmcalc.extras.notes.told import given
from tmmcalc.extras.pictures.transloader import draw_ways, meaning_of
from tmmcalc.extras.tables.tasks.transloader import to_transloader
from tmmcalc.extras.transloader import (
    HOIST,
    MINUTE,
    SAME,
    TROLLEY,
    USUAL_SPAN,
    Drive,
    Limit,
    Transloader,
    TransloaderTask,
    Way,
    Wind,
)
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr, tr_name, tr_unit
from tmmcalc.report.manuscript import Block, Heading, Lexicon, Listing, Paragraph, Place, Result, Table
from tmmcalc.report.telling import data_of, drawn, lines, named, numeral, plainly

PEAK = "v_{p<i>} = sqrt(<L>*j_<i>)"
TIMES = {  # whether the speed is reached
    True: "t_<i> = <L>/v_<i> + v_<i>/j_<i>",
    False: "t_<i> = <L>/v_{p<i>} + v_{p<i>}/j_<i>",
}
SHORTEST = "t_{p<i>} = 2*sqrt(<L>/j_<i>)"
WIND = "W_i = q_0*n_w*c_w*gamma*beta*A_w/1000"
INERTIA = {True: "P = sum(G_k, k)*v/(g*t)", False: "P = sum(G_k, k)*j_1/g"}
SPEEDS = 55.0  # height of the diagram of a way [mm]


def blocks(order: Order) -> Iterator[Block]:
    """Speeds and what is usual, the loads by case, the stresses of the parts."""
    result: Transloader = order.results["transloader"]
    task = to_transloader(order.spec)
    lexicon = named(_quantities(result, task))
    yield Heading(tr("Grab transloader"))
    yield from given(data_of(sizes(task)), "transloader")
    nearest = min(SERIES, key=lambda each: abs(KILO * each - task.capacity))
    if abs(KILO * nearest - task.capacity) > SAME * task.capacity:
        values = {"value": plainly(task.capacity / KILO), "nearest": plainly(nearest)}
        yield Paragraph(
            tr("{value} t is not of the standard series of capacities; the nearest is {nearest} t.", **values)
        )
    if result.masses:
        yield Paragraph(tr("Its mass is usually parted between structure, mechanisms and electrical equipment by"))
        parts = zip(("c", "m", "e"), PARTS_OF_MASS.values(), strict=True)
        yield from lines([f"m_{part} = {share:g}*m" for part, share in parts], [Place("", lexicon)])
    if result.drives:
        yield Heading(tr("Speeds of trolley and hoist"), 3)
        yield from _speeds(result, task)
    if result.limits:
        yield Heading(tr("What is usual"), 3)
        yield from _limits(result.limits)
    yield Heading(tr("Loads of the transloader"), 3)
    yield from _loads(result, task, lexicon)
    yield from _cases(result)
    if result.checks:
        yield Heading(tr("Stresses of the parts"), 3)
        yield from stresses(result, task)


def data(order: Order) -> Iterator[Block]:
    """The transloader, its ways, its loads, its parts."""
    yield from whole(to_transloader(order.spec))


def _quantities(result: Transloader, task: TransloaderTask) -> Lexicon:
    found = sizes(task)
    masses = zip(
        ("m_c", "m_m", "m_e"),
        result.masses,
        (tr("mass of the structure"), tr("mass of the mechanisms"), tr("mass of the electrical equipment")),
        strict=False,
    )
    found |= {name: Given(mass / KILO, "t", said) for name, mass, said in masses}
    for load in result.loads:
        found[LETTERS[load.load]] = Given(load.value / KILO, "kN", meaning_of(load.load))
    return found


def _speeds(result: Transloader, task: TransloaderTask) -> Iterator[Block]:
    """The ways from rest to rest: the speed that they allow, the speed, times."""
    yield Paragraph(
        tr(
            "A way begins and ends at rest, with one acceleration. Where it is nothing but acceleration and braking "
            "its largest speed is reached in its middle; at a lower speed the time of the way is longer."
        )
    )
    for drive in result.drives:
        trolley = drive.what == "trolley"
        way = task.trolley if trolley else task.hoist
        assert way is not None
        lexicon = named(_of_way(drive))
        place = Place("", lexicon)
        caption = tr("Way of the trolley") if trolley else tr("Way of the hoist")
        length = "L_0" if trolley else "H"
        i = "1" if trolley else "2"
        words = {"L": length, "i": i}
        known = trolley_way(way) if trolley else hoist_way(way)
        yield from given(data_of(known), f"transloader_{drive.what}", caption)
        yield from lines([PEAK], [place], words)
        yield from _usual(drive, way, place)
        yield from lines([TIMES[drive.speed <= drive.peak], SHORTEST], [place], words)
    yield Paragraph(tr("The speeds over the time of a way are shown in figure {fig:transloader_ways}."))
    said = tr("Speeds over the time of a way")
    yield drawn(said, partial(draw_ways, result=result, across=False), SPEEDS * len(result.drives), "transloader_ways")


def _of_way(drive: Drive) -> Lexicon:
    trolley = drive.what == "trolley"
    said = tr("longest way of the trolley") if trolley else tr("height of the lift")
    speed, i = (tr("speed of the trolley"), "1") if trolley else (tr("speed of the hoist"), "2")
    return {
        "L_0" if trolley else "H": Given(drive.length, "m", said),
        f"j_{i}": Given(drive.acceleration, "m/s^2", tr("acceleration and deceleration")),
        f"v_{{p{i}}}": Given(drive.peak, "m/s", tr("speed that the way allows")),
        f"v_{i}": Given(drive.speed, "m/s", speed),
        f"t_{i}": Given(drive.time, "s", tr("time of the way")),
        f"t_{{p{i}}}": Given(drive.shortest, "s", tr("time of the way that is nothing but acceleration and braking")),
    }


def _usual(drive: Drive, way: Way, place: Place) -> Iterator[Block]:
    """The speed that is taken where none is given."""
    if way.speed is not None:
        return
    trolley = drive.what == "trolley"
    _, most = TROLLEY if trolley else HOIST
    top = plainly(MINUTE * most)
    yield Paragraph(tr("As is usual this part of it is taken, but not more than {speed} m/min:", speed=top))
    i = "1" if trolley else "2"
    yield from lines([f"v_{i} = {usual_speed(i)}"], [place])


def _limits(limits: Sequence[Limit]) -> Iterator[Block]:
    """What speeds, accelerations and sizes usually are, and whether these are."""
    yield Paragraph(tr("Speeds, accelerations and sizes beside what is usual are in table {tab:transloader_limits}."))
    rows = []
    for limit in limits:
        unit, factor = PRINTED.get(limit.unit, (limit.unit, 1.0)) if limit.name != "deflection" else ("mm", KILO)
        value, low, high = (
            "–" if each is None else f"${numeral(factor * each)}$" for each in (limit.value, limit.low, limit.high)
        )
        rows.append(
            (f"{_limited(limit.name)}, {tr_unit(unit)}", value, low, high, tr("yes") if limit.holds else tr("no"))
        )
        yield from _results(limit, unit, factor)
    head = tr("Quantity"), tr("Value"), tr("At least"), tr("At most"), tr("Kept")
    yield Table(tr("What is usual"), head, tuple(rows), "transloader_limits")
    span = next((each.value for each in limits if each.name == "span"), None)
    if span is not None and not USUAL_SPAN[0] <= span <= USUAL_SPAN[1]:
        low, high = (plainly(each) for each in USUAL_SPAN)
        yield Paragraph(tr("Most spans are from {low} to {high} m.", low=low, high=high))


PRINTED = {"m/s": ("m/min", MINUTE)}
SYMBOLS = {
    "trolley_speed": "v_1",
    "trolley_speed_by_way": "v_1",
    "hoist_speed": "v_2",
    "hoist_speed_by_height": "v_2",
    "hoist_acceleration": "j_2",
    "lift": "H",
    "lowering_speed": "v_l",
    "bridge_speed": "v_b",
    "span": "L",
    "deflection": "f",
}


def _limited(name: str) -> str:
    """What a limit is of."""
    return {
        "trolley_speed": tr("speed of the trolley"),
        "trolley_speed_by_way": tr("speed of the trolley by its way"),
        "hoist_speed": tr("speed of the hoist"),
        "hoist_speed_by_height": tr("speed of the hoist by its height"),
        "hoist_acceleration": tr("acceleration of the hoist"),
        "lift": tr("height of the lift"),
        "lowering_speed": tr("speed of lowering"),
        "bridge_speed": tr("speed of the bridge"),
        "span": tr("span of the bridge"),
        "deflection": tr("deflection of the bridge"),
    }[name]


def _results(limit: Limit, unit: str, factor: float) -> Iterator[Result]:
    """The rows of the conclusions: one for each end that is given; an end that is met but for rounding is met."""
    own = Given(factor * limit.value, unit, _limited(limit.name))
    for end, sense, nearest in ((limit.low, ">=", min), (limit.high, "<=", max)):
        if end is not None:
            bound = nearest(factor * end, factor * limit.value) if limit.holds else factor * end
            yield Result(SYMBOLS[limit.name], own, bound, sense)


def _loads(result: Transloader, task: TransloaderTask, lexicon: Lexicon) -> Iterator[Block]:
    """How each load follows; those that are given stand in the table."""
    place, known = Place("", lexicon), dict(task.loads)
    weights = [
        text
        for name, text in (("dead_weight", "G = m*g"), ("rated_load", "G_Q = Q*g"))
        if name not in known and LETTERS[name] in lexicon
    ]
    if weights:
        yield Paragraph(tr("Weights of the transloader and of its load:"))
        yield from lines(weights, [place])
    if task.inertia is not None and "inertia" not in known:
        yield from _inertia(task, result.drives, lexicon)
    winds = [(name, wind) for name, wind in task.winds if name not in known]
    if winds:
        yield Paragraph(tr("Forces of the winds on the area $A_w$:"))
        yield from lines([WIND], [_of_wind(name, wind, lexicon) for name, wind in winds])
    if known:
        yield Paragraph(tr("The other loads are given."))


def _inertia(task: TransloaderTask, drives: Sequence[Drive], lexicon: Lexicon) -> Iterator[Block]:
    """The force of inertia, by a speed and a time or by the acceleration of the trolley."""
    start = task.inertia
    assert start is not None
    found = {"G_k": Given([each / KILO for each in start.weights], "kN", tr("weight that is set into motion"))}
    if start.time is not None:
        speed = start.speed
        if speed is None:
            speed = next(each.speed for each in drives if each.what == "trolley")
        found["v"] = Given(speed, "m/s", tr("speed that the weights reach"))
        found["t"] = Given(start.time, "s", tr("time in which they reach it"))
    elif task.trolley is not None:
        found["j_1"] = Given(task.trolley.acceleration, "m/s^2", tr("acceleration of the trolley"))
    yield Paragraph(
        tr("Force of inertia of what is set into motion:")
        if start.time is not None
        else tr("Force of inertia of what is set into motion with the acceleration of the trolley:")
    )
    yield from lines([INERTIA[start.time is not None]], [Place("", lexicon | named(found))])


def _of_wind(name: str, wind: Wind, lexicon: Lexicon) -> Place:
    letter = LETTERS[name]
    found = {"W_i": lexicon[letter]._replace(meaning=tr("force of the wind"))} | wind_data(wind)
    return Place(meaning_of(name), named(found), letter.partition("_")[2])


def _cases(result: Transloader) -> Iterator[Block]:
    """The cases, and which load acts in each."""
    yield Paragraph(tr("The loads act together in these cases:"))
    said = [f"{case} – {tr_name(meaning)}" for case, meaning in CASES.items()]
    yield Listing((*(f"{each};" for each in said[:-1]), f"{said[-1]}."))
    yield Paragraph(
        tr(
            "The loads of each case are in table {tab:transloader_loads}. A question mark is a load that is left "
            "open there."
        )
        if any(each.blank for each in result.loads)
        else tr("The loads of each case are in table {tab:transloader_loads}.")
    )
    if any(each.blank for each in result.loads):
        yield Paragraph(
            tr("Loads that are left open are taken to act.")
            if result.blanks == "with"
            else tr("Loads that are left open are taken not to act.")
        )
    rows = []
    for each in result.loads:
        signs = (("+" if case in each.cases else "–") + ("?" if case in each.blank else "") for case in CASES)
        symbol = f"${LETTERS[each.load]}$"
        rows.append((meaning_of(each.load), symbol, f"${numeral(each.value / KILO)}$", *signs))
    head = tr("Load"), tr("Designation"), f"{tr('Value')}, {tr_unit('kN')}", *CASES
    yield Table(tr("Loads by case"), head, tuple(rows), "transloader_loads")
