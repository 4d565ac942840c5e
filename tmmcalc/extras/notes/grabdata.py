"""What is given of a grab transloader: its sizes, its ways, what its loads follow from, its parts."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.extras.loadcases import CASES, DUTIES, LOADS, MAKINGS, MECHANISMS, PARTS_OF_MASS, acts
from tmmcalc.extras.pictures.transloader import meaning_of
from tmmcalc.extras.transloader import (
    HOIST,
    HOIST_PART,
    MINUTE,
    TROLLEY,
    TROLLEY_PART,
    Part,
    Start,
    TransloaderTask,
    Way,
    Wind,
)
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr, tr_name, tr_unit
from tmmcalc.report.manuscript import Block, Datum, Lexicon, Paragraph
from tmmcalc.report.telling import data_of, owned

KILO, MEGA = 1e3, 1e6
LETTERS = {  # of the loads
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


def sizes(task: TransloaderTask) -> Lexicon:
    """The transloader as a whole, the sizes that are given."""
    found = {
        "Q": (task.capacity, "t", 1 / KILO, tr("rated capacity")),
        "m": (task.mass, "t", 1 / KILO, tr("mass of the whole transloader")),
        "g": (task.gravity, "m/s^2", 1.0, tr("free-fall acceleration")),
        "L": (task.span, "m", 1.0, tr("span of the bridge")),
        "f": (task.deflection, "mm", KILO, tr("deflection of the bridge")),
        "v_b": (task.bridge_speed, "m/min", MINUTE, tr("speed of the bridge")),
        "v_l": (task.lowering, "m/min", MINUTE, tr("speed of lowering")),
    }
    return {
        name: Given(factor * value, unit, said)
        for name, (value, unit, factor, said) in found.items()
        if value is not None
    }


def trolley_way(way: Way) -> Lexicon:
    """What is given of the way of the trolley."""
    found = {
        "L_0": Given(way.length, "m", tr("longest way of the trolley")),
        "j_1": Given(way.acceleration, "m/s^2", tr("acceleration and deceleration")),
    }
    return found if way.speed is None else found | {"v_1": Given(way.speed, "m/s", tr("speed of the trolley"))}


def hoist_way(way: Way) -> Lexicon:
    """What is given of the way of the hoist."""
    found = {
        "H": Given(way.length, "m", tr("height of the lift")),
        "j_2": Given(way.acceleration, "m/s^2", tr("acceleration and deceleration")),
    }
    return found if way.speed is None else found | {"v_2": Given(way.speed, "m/s", tr("speed of the hoist"))}


def usual_speed(index: str) -> str:
    """The speed [m/s] that is taken where none is given, over that which the way allows."""
    part, (_, most) = (TROLLEY_PART, TROLLEY) if index == "1" else (HOIST_PART, HOIST)
    return f"min({part:g}*v_{{p{index}}}, {MINUTE * most:g}/{MINUTE:g})"


def wind_data(wind: Wind) -> Lexicon:
    """A wind by its letters."""
    return {
        "q_0": Given(wind.pressure, "Pa", tr("pressure of the wind")),
        "n_w": Given(wind.height, "", tr("coefficient of the height")),
        "c_w": Given(wind.shape, "", tr("coefficient of the shape")),
        "gamma": Given(wind.overload, "", tr("coefficient of overload")),
        "beta": Given(wind.dynamic, "", tr("coefficient of the gusts")),
        "A_w": Given(wind.area, "m^2", tr("area that the wind acts on")),
    }


def whole(task: TransloaderTask) -> Iterator[Block]:
    """All that is given of a transloader, with the tables of the source that its loads and stresses are by."""
    yield Paragraph(
        tr(
            "A grab transloader has a trolley on its bridge and a hoist. Their ways begin and end at rest, with one "
            "acceleration and deceleration; $v_{p1} = sqrt(L_0*j_1)$ and $v_{p2} = sqrt(H*j_2)$ are the speeds that "
            "ways of nothing but these would reach."
        )
    )
    yield from data_of(sizes(task))
    if task.mass is not None:
        said = tr("parts of structure, mechanisms and electrical equipment in the mass")
        yield Datum(said, (), tuple(PARTS_OF_MASS.values()))
    if task.trolley is not None:
        yield from _way(
            tr("Way of the trolley"), tr("speed of the trolley"), "1", task.trolley, trolley_way(task.trolley)
        )
    if task.hoist is not None:
        yield from _way(tr("Way of the hoist"), tr("speed of the hoist"), "2", task.hoist, hoist_way(task.hoist))
    known = dict(task.loads)
    if task.inertia is not None and "inertia" not in known:
        yield from _start(task.inertia)
    for name, wind in task.winds:
        if name not in known:
            yield from data_of(wind_data(wind), of=owned(meaning_of(name)))
    for name, value in known.items():
        yield Datum(meaning_of(name), (LETTERS[name],), (value / KILO,), "kN")
    yield from _stressed(task)


def _way(caption: str, speed: str, index: str, way: Way, known: Lexicon) -> Iterator[Datum]:
    """A way, and by what its speed is where none is given."""
    yield from data_of(known, of=owned(caption))
    if way.speed is None:
        yield Datum(f"{caption}: {speed}", (f"v_{index}",), text=f"${usual_speed(index)}$ {tr_unit('m/s')}")


def _start(start: Start) -> Iterator[Datum]:
    """What is set into motion, and how."""
    weights = tuple(each / KILO for each in start.weights)
    yield Datum(tr("weights that are set into motion, which gives the load of inertia"), ("G_k",), weights, "kN")
    if start.time is None:
        yield Datum(tr("acceleration of these weights"), text=tr("that of the trolley"))
        return
    if start.speed is None:
        yield Datum(tr("speed that the weights reach"), ("v",), text=tr("that of the trolley"))
    else:
        yield Datum(tr("speed that the weights reach"), ("v",), (start.speed,), "m/s")
    yield Datum(tr("time in which they reach it"), ("t",), (start.time,), "s")


def _stressed(task: TransloaderTask) -> Iterator[Block]:
    """The cases of loads; the parts, with what their forces and allowed stresses are by."""
    cases = "; ".join(f"{case} – {tr_name(meaning)}" for case, meaning in CASES.items())
    yield Paragraph(tr("The loads act together in these cases: {cases}.", cases=cases))
    for name in _named(task):
        own = [case for case in CASES if acts(name, case, task.blanks == "with")]
        said = tr("cases in which this load acts: {load}", load=meaning_of(name))
        yield Datum(said, (LETTERS[name],), text=", ".join(own) or "–")
    if not task.parts:
        return
    yield Paragraph(
        tr(
            "The force in a part is the sum of the loads of the case, each with its coefficient $c$; weights act as "
            "they are, other loads to either side, so that they are added at their worst. The allowed stress is "
            "$sigma_0/(K_m*K_n)$ with the factors of the mechanism, $K_1$, of its duty, $K_2$, and against fatigue, "
            "in case A, that of how the part is made, $K_n$; against static stress $K_n = 1$."
        )
    )
    together = "K_1 + K_2" if task.factors == "sum" else "K_1*K_2"
    yield Datum(tr("factor of both"), ("K_m",), text=f"${together}$")
    for part in task.parts:
        name = tr_name(part.name)
        yield from (each._replace(what=f"{name}: {each.what}") for each in (*of_part(part), *factors(part)))
        for each in influence(part):
            said = tr("{part}: force in the part over the load: {load}", part=name, load=each.what)
            yield each._replace(what=said, keys=("c",))


def _named(task: TransloaderTask) -> list[str]:
    """The loads that the transloader has, in the order of the source."""
    found = {"rated_load", *(name for name, _ in (*task.loads, *task.winds))}
    found |= {name for name, of in (("dead_weight", task.mass), ("inertia", task.inertia)) if of is not None}
    return [name for name in LOADS if name in found]


def of_part(part: Part) -> Iterator[Datum]:
    """Where a part belongs, how it is made, its section and limit stresses."""
    yield Datum(tr("its mechanism"), text=tr_name(part.mechanism))
    yield Datum(tr("duty"), text=tr_name(part.duty or MECHANISMS[part.mechanism].duty))
    yield Datum(tr("made"), text=tr_name(part.making))
    yield Datum(tr("section of the part"), ("A",), (1e4 * part.area,), "cm^2")
    for kind, stress in (("strength", part.strength), ("endurance", part.endurance)):
        if stress is not None:
            said = f"{tr('limit stress of the material')}, {kind_of(kind)}"
            yield Datum(said, ("sigma_0",), (stress / MEGA,), "MPa")


def factors(part: Part) -> Iterator[Datum]:
    """The factors of the allowed stresses of a part, by the tables of the source where they are not given."""
    mechanism = MECHANISMS[part.mechanism]
    for letter, value in zip("ABV", part.importance or mechanism.importance, strict=True):
        if value is not None:
            cases = ", ".join(case for case in CASES if case[0] == letter)
            said = tr("factor of the importance of the mechanism, cases {cases}", cases=cases)
            yield Datum(said, ("K_1",), (value,))
    yield Datum(tr("factor of its duty"), ("K_2",), (DUTIES[part.duty or mechanism.duty],))
    yield Datum(tr("factor of how the part is made"), ("K_n",), (MAKINGS[part.making],))


def influence(part: Part) -> Iterator[Datum]:
    """Force in a part over each load."""
    yield from (Datum(lettered(name), values=(ratio,)) for name, ratio in part.influence)


def lettered(load: str) -> str:
    """A load with its letter."""
    return f"{meaning_of(load)}, ${LETTERS[load]}$"


def kind_of(kind: str) -> str:
    """What a limit stress is against."""
    return tr("endurance") if kind == "endurance" else tr("static strength")
