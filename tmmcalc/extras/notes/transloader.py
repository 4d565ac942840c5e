"""A grab transloader: speeds of its ways, what is usual, loads by case, stresses beside what is allowed."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial

from tmmcalc.extras.loadcases import CASES, LOADS, MECHANISMS, OF_WEIGHT, PARTS_OF_MASS, SERIES
from tmmcalc.extras.notes.told import given
from tmmcalc.extras.pictures.transloader import draw_stresses, draw_ways, meaning_of
from tmmcalc.extras.tables.tasks.transloader import to_transloader
from tmmcalc.extras.transloader import (
    HOIST,
    HOIST_PART,
    MINUTE,
    SAME,
    TROLLEY,
    TROLLEY_PART,
    USUAL_SPAN,
    Check,
    Drive,
    Limit,
    Part,
    Transloader,
    TransloaderTask,
    Way,
    Wind,
)
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr, tr_name, tr_unit
from tmmcalc.report.manuscript import Block, Heading, Lexicon, Listing, Paragraph, Place, Result, Table
from tmmcalc.report.telling import drawn, lines, named, numeral, plainly

KILO, MEGA = 1e3, 1e6
PEAK = "v_{p<i>} = sqrt(<L>*j_<i>)"
TIMES = {  # whether the speed is reached
    True: "t_<i> = <L>/v_<i> + v_<i>/j_<i>",
    False: "t_<i> = <L>/v_{p<i>} + v_{p<i>}/j_<i>",
}
SHORTEST = "t_{p<i>} = 2*sqrt(<L>/j_<i>)"
WIND = "W_i = q_0*n*c*gamma*beta*A/1000"
INERTIA = {True: "P = sum(G_k, k)*v/(g*t)", False: "P = sum(G_k, k)*j_1/g"}
MARGIN = {"sum": "K_m = K_1 + K_2", "product": "K_m = K_1*K_2"}
STRESS = ("sigma = 10*N/A", "sigma_a = sigma_0/(K_m*K_n)")
SPEEDS = 55.0  # height of the diagram of a way [mm]
BAR, FRAME = 9.0, 32.0  # heights of a stress and of what is around all [mm]


def blocks(order: Order) -> Iterator[Block]:
    """Speeds and what is usual, the loads by case, the stresses of the parts."""
    result: Transloader = order.results["transloader"]
    task = to_transloader(order.spec)
    lexicon = named(_quantities(result, task))
    yield Heading(tr("Grab transloader"))
    yield from given(lexicon, GIVEN, "transloader")
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
        yield from _stresses(result, task)


GIVEN = ("Q", "m", "g", "L", "f", "v_b", "v_l")


def _quantities(result: Transloader, task: TransloaderTask) -> Lexicon:
    found = {
        "Q": Given(task.capacity / KILO, "t", tr("rated capacity")),
        "g": Given(task.gravity, "m/s^2", tr("free-fall acceleration")),
    }
    sizes = (
        ("m", task.mass, "t", 1 / KILO, tr("mass of the whole transloader")),
        ("L", task.span, "m", 1.0, tr("span of the bridge")),
        ("f", task.deflection, "mm", KILO, tr("deflection of the bridge")),
        ("v_b", task.bridge_speed, "m/min", MINUTE, tr("speed of the bridge")),
        ("v_l", task.lowering, "m/min", MINUTE, tr("speed of lowering")),
    )
    found |= {name: Given(factor * value, unit, said) for name, value, unit, factor, said in sizes if value is not None}
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


LETTERS = {
    "dead_weight": "G",
    "rated_load": "G_Q",
    "inertia": "P",
    "wind": "W_1",
    "equivalent_wind": "W_2",
    "track": "F_1",
    "drive": "F_2",
    "shock": "F_3",
    "hurricane": "W_3",
    "seismic": "F_4",
}


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
        names = [length, f"j_{i}", *([f"v_{i}"] if way.speed is not None else [])]
        yield from given(lexicon, names, f"transloader_{drive.what}", caption)
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
    part, (_, most) = (TROLLEY_PART, TROLLEY) if trolley else (HOIST_PART, HOIST)
    top = plainly(MINUTE * most)
    yield Paragraph(tr("As is usual this part of it is taken, but not more than {speed} m/min:", speed=top))
    i = "1" if trolley else "2"
    yield from lines([f"v_{i} = min({part:g}*v_{{p{i}}}, {MINUTE * most:g}/{MINUTE:g})"], [place])


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
        yield Paragraph(tr("Forces of the winds on the area $A$:"))
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
    found = {
        "W_i": lexicon[letter]._replace(meaning=tr("force of the wind")),
        "q_0": Given(wind.pressure, "Pa", tr("pressure of the wind")),
        "n": Given(wind.height, "", tr("coefficient of the height")),
        "c": Given(wind.shape, "", tr("coefficient of the shape")),
        "gamma": Given(wind.overload, "", tr("coefficient of overload")),
        "beta": Given(wind.dynamic, "", tr("coefficient of the gusts")),
        "A": Given(wind.area, "m^2", tr("area that the wind acts on")),
    }
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


def _stresses(result: Transloader, task: TransloaderTask) -> Iterator[Block]:
    """Part by part force, stress and allowed stress; then all of them."""
    yield Paragraph(
        tr(
            "The parts are in table {tab:transloader_parts}. The force in a part is the sum of the loads of the "
            "case, each with its coefficient $c$ (table {tab:transloader_influence}); weights act as they are, other "
            "loads to either side, so that they are added at their worst. The allowed stress is $sigma_a = "
            "sigma_0/(K_m*K_n)$ with the factors of the mechanism, $K_1$, of its duty, $K_2$, and against fatigue "
            "that of how the part is made, $K_n$."
        )
    )
    yield _parts(task.parts)
    yield _influence(task.parts)
    yield Paragraph(
        tr("The factors $K_1$ and $K_2$ are added to $K_m$.")
        if result.factors == "sum"
        else tr("The factors $K_1$ and $K_2$ are multiplied to $K_m$.")
    )
    for part in task.parts:
        checks = [each for each in result.checks if each.part == part.name]
        if checks:
            yield from _part(part, checks, result)
    yield Paragraph(
        tr(
            "The stresses beside what is allowed are in table {tab:transloader_stresses} and in figure "
            "{fig:transloader_stresses}."
        )
    )
    yield _checked(result)
    unchecked = [part.name for part in task.parts if not any(_is_of(each, part, "V") for each in result.checks)]
    if unchecked:
        said = tr("Out of service no factor $K_1$ is known of {parts}: cases V1 and V2 are not checked.")
        yield Paragraph(said.replace("{parts}", ", ".join(map(tr_name, unchecked))))
    high = FRAME + BAR * len(result.checks)
    yield drawn(tr("Stresses of the parts"), partial(draw_stresses, result=result), high, "transloader_stresses")
    yield from _worst(result.checks)


def _is_of(check: Check, part: Part, letter: str) -> bool:
    return check.part == part.name and check.case[0] == letter


def _parts(parts: Sequence[Part]) -> Table:
    """Where each part belongs, how it is made, its section and limit stresses."""
    duties = [part.duty or MECHANISMS[part.mechanism].duty for part in parts]
    rows = (
        (tr("its mechanism"), *(tr_name(part.mechanism) for part in parts)),
        (tr("duty"), *map(tr_name, duties)),
        (tr("made"), *(tr_name(part.making) for part in parts)),
        (f"$A$, {tr_unit('cm^2')}", *(f"${numeral(1e4 * part.area)}$" for part in parts)),
        (f"$sigma_0$, {tr_unit('MPa')}, {_kind('strength')}", *(_megapascals(part.strength) for part in parts)),
        (f"$sigma_0$, {tr_unit('MPa')}, {_kind('endurance')}", *(_megapascals(part.endurance) for part in parts)),
    )
    head = tr("Part"), *(tr_name(part.name) for part in parts)
    return Table(tr("Parts whose stresses are looked at"), head, rows, "transloader_parts")


def _megapascals(stress: float | None) -> str:
    return "–" if stress is None else f"${numeral(stress / MEGA)}$"


def _influence(parts: Sequence[Part]) -> Table:
    """Force in each part over each load."""
    used = [name for name in LOADS if any(name in dict(part.influence) for part in parts)]
    rows = tuple(
        (
            f"{meaning_of(name)}, ${LETTERS[name]}$",
            *(f"${numeral(dict(part.influence)[name])}$" if name in dict(part.influence) else "–" for part in parts),
        )
        for name in used
    )
    head = tr("Load"), *(tr_name(part.name) for part in parts)
    return Table(tr("Force in a part over each load"), head, rows, "transloader_influence")


def _part(part: Part, checks: Sequence[Check], result: Transloader) -> Iterator[Block]:
    """Force and stress of a part by case, its allowed stresses."""
    yield Paragraph(
        tr("Part: {part}. The force by case, and the stress with the section $A$:", part=tr_name(part.name))
    )
    sizes = {each.load: each.value / KILO for each in result.loads}
    acting = {case: [each.load for each in result.loads if case in each.cases] for case in CASES}
    forces: dict[str, list[Place]] = {}
    for check in {each.case: each for each in checks}.values():
        found = _of_part(part, check)
        text = []
        own = [(ratio, sizes[name], name in OF_WEIGHT) for name, ratio in part.influence if name in acting[check.case]]
        for weight, counter, form in ((True, "i", "abs(sum(c_i*F_i, i))"), (False, "k", "sum(abs(c_k)*F_k, k)")):
            chosen = [(ratio, size) for ratio, size, kind in own if kind == weight]
            if chosen:
                text.append(form)
                said = tr("weight of the case") if weight else tr("other load of the case")
                found[f"c_{counter}"] = Given([each for each, _ in chosen], "", tr("force in the part over the load"))
                found[f"F_{counter}"] = Given([each for _, each in chosen], "kN", said)
        if text:
            place = Place(tr("in case {case}", case=check.case), named(found))
            forces.setdefault(f"N = {' + '.join(text)}", []).append(place)
    for formula, places in forces.items():
        yield from lines([formula], places)
    every = [place for places in forces.values() for place in places]
    if every:
        yield from lines(["sigma = 10*N/A"], every)
    yield Paragraph(tr("Its factors and allowed stresses:"))
    yield from lines([MARGIN[result.factors]], [_like(same, part, kind="") for same in _alike(checks, "importance")])
    yield from lines(
        ["sigma_a = sigma_0/(K_m*K_n)"],
        [_like(same, part, kind=_kind(same[0].kind)) for same in _alike(checks, "importance", "kind")],
    )


def _alike(checks: Sequence[Check], *names: str) -> list[list[Check]]:
    """Checks with the same values of these fields together."""
    found: dict[tuple[object, ...], list[Check]] = {}
    for check in checks:
        found.setdefault(tuple(getattr(check, name) for name in names), []).append(check)
    return list(found.values())


def _like(checks: Sequence[Check], part: Part, *, kind: str) -> Place:
    """The cases that have one allowed stress; of a part that is checked in two ways with the kind of the check."""
    cases = list(dict.fromkeys(each.case for each in checks))
    said = tr("in case {case}", case=cases[0])
    if len(cases) > 1:
        said = tr("in cases {cases}", cases=", ".join(cases))
    if kind and part.endurance is not None:
        said += f", {kind}"
    return Place(said, named(_of_part(part, checks[0])))


def _kind(kind: str) -> str:
    return tr("endurance") if kind == "endurance" else tr("static strength")


def _of_part(part: Part, check: Check) -> Lexicon:
    limit = part.endurance if check.kind == "endurance" else part.strength
    assert limit is not None
    return {
        "N": Given(check.force / KILO, "kN", tr("force in the part")),
        "A": Given(1e4 * part.area, "cm^2", tr("section of the part")),
        "sigma": Given(check.stress / MEGA, "MPa", tr("stress of the part")),
        "sigma_0": Given(limit / MEGA, "MPa", tr("limit stress of the material")),
        "sigma_a": Given(check.allowed / MEGA, "MPa", tr("allowed stress")),
        "K_1": Given(check.importance, "", tr("factor of the importance of the mechanism")),
        "K_2": Given(check.duty, "", tr("factor of its duty")),
        "K_m": Given(check.margin, "", tr("factor of both")),
        "K_n": Given(check.making, "", tr("factor of how the part is made")),
    }


def _checked(result: Transloader) -> Table:
    """All stresses beside what is allowed, also by the other factor."""
    other = "$K_1*K_2$" if result.factors == "sum" else "$K_1 + K_2$"
    both = {each.part for each in result.checks if each.kind == "endurance"}
    rows = tuple(
        (
            tr_name(each.part),
            f"{each.case}, {_kind(each.kind)}" if each.part in both and each.case == "A" else each.case,
            *(f"${numeral(value)}$" for value in (each.stress / MEGA, each.allowed / MEGA, each.other / MEGA)),
            f"${numeral(100 * each.use, 4)}$",
            tr("yes") if each.holds else tr("no"),
        )
        for each in result.checks
    )
    stress = f"$sigma$, {tr_unit('MPa')}", f"$sigma_a$, {tr_unit('MPa')}"
    by_other = tr("$sigma_a$ by {factor}, MPa", factor=other)
    head = tr("Part"), tr("Case"), *stress, by_other, "$sigma$/$sigma_a$, %", tr("Kept")
    return Table(tr("Stresses beside what is allowed"), head, rows, "transloader_stresses")


def _worst(checks: Sequence[Check]) -> Iterator[Result]:
    """The most strained check of each part, and every one that fails."""
    for same in _alike(checks, "part"):
        worst = max(same, key=lambda each: each.use)
        for check in same:
            if check is worst or not check.holds:
                values = {"part": tr_name(check.part), "case": check.case, "kind": _kind(check.kind)}
                given_ = Given(check.stress / MEGA, "MPa", tr("stress of the part"))
                allowed = max(check.allowed, check.stress) if check.holds else check.allowed
                said = tr("{part}, case {case}, {kind}", **values)
                yield Result("sigma", given_, allowed / MEGA, "<=", said)
