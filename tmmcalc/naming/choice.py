"""Facts by choice: what a stage tells beyond its documents, and only when it is asked for by name.

They are the details of its own (`details` of a stage), and of every stage what it knows of itself:

    error.NAME          estimated relative error, as the stage file has it
    last_digit.NAME     relative change by a unit in the last place of the data: how well conditioned the scene is
    counters.NAME       steps, iterations, evaluations
    warnings, notes     how many of them its document has
    warnings.N.value    value and limit of a warning or note, counted from 1, where it has them
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from math import nan
from typing import Any, NamedTuple, get_args, get_origin, get_type_hints

from tmmcalc.core.facts import named
from tmmcalc.core.notes import Note, Phrase, graded
from tmmcalc.core.quantity import Quantity, in_degrees, quantities
from tmmcalc.core.stage import STAGES, Stage
from tmmcalc.core.stored import LAST_DIGIT
from tmmcalc.naming.scene import Scene

ERROR, ESTIMATED = "error", "estimated relative error: {name}"
HOW_MANY = {"warnings": "how many warnings its document has", "notes": "how many notes its document has"}
HELD = {  # by a note: of a quantity that has a name, and of others
    "value": ("value of {name}: {note}", "its value: {note}"),
    "limit": ("limit of {name}: {note}", "its limit: {note}"),
}
WHEEL = "wheel"  # field of a record that says of which wheel it is
IN_RADIANS = ("gears", "vibration")  # rooms whose angles are told as they are kept; elsewhere they are in deg


class Chosen(NamedTuple):
    """One fact by choice."""

    name: str
    unit: str
    value: float  # NaN where it was not computed, and where it has none
    meaning: str
    symbol: str = ""


def chosen_facts(stage: str, scene: Scene) -> Iterator[Chosen]:
    """All facts by choice of a stage with their values."""
    yield from details_of(stage, scene)
    yield from of_itself(stage, scene.results[stage])


def details_of(stage: str, scene: Scene) -> Iterator[Chosen]:
    """What the records of its details give out; a record within one has the name of its field before its own."""
    radians = in_radians(STAGES[stage])
    for word, each in scene.details(stage).items():
        yield from _given_out(each, f"{word}." if word else "", {}, radians)


def in_radians(stage: Stage) -> bool:
    """Whether the angles of a stage are told in rad."""
    return stage.facts.split(".")[1:2] in [[room] for room in IN_RADIANS]


def _given_out(of: Any, path: str, places: Mapping[str, object], radians: bool) -> Iterator[Chosen]:
    """The numbers of a record; its fields, and those of the record that holds it, fill the places of its keys."""
    told = quantities(type(of))
    own = {**places, **{name: value for name, value in vars(of).items() if isinstance(value, str | int)}}
    for name in dict.fromkeys((*type(of).__record__.fields, *told)):
        value = getattr(of, name)
        quantity = told[name].of(**own) if name in told else None
        if isinstance(value, int | float):
            if quantity is not None:
                yield _fact(path, quantity, value, radians)
        elif quantity is not None and isinstance(value, tuple | list) and _numbers(value):
            name, bracket, unit = quantity.key.partition("[")
            each = (quantity._replace(key=f"{name}.{k}{bracket}{unit}") for k in range(len(value)))
            yield from (_fact(path, one, number, radians) for one, number in zip(each, value, strict=True))
        else:
            word = quantity.name if quantity is not None else name
            for key, part in _records(value):
                for fact in _given_out(part, f"{path}{word}{key}.", own, radians):
                    yield fact._replace(meaning=_of_wheel(fact.meaning, part))


def _of_wheel(meaning: str, part: Any) -> str:
    """A meaning with the name of the wheel that the record is of; itself of other records."""
    wheel = getattr(part, WHEEL, None)
    return Phrase("{quantity}, wheel {wheel}", quantity=meaning, wheel=wheel) if isinstance(wheel, str) else meaning


def _numbers(values: tuple[Any, ...] | list[Any]) -> bool:
    return all(isinstance(value, int | float) for value in values)


def _records(value: Any) -> Iterator[tuple[str, Any]]:
    """The records in a value with what follows its name: of several their names, or their numbers from 0.

    Those that share a name are told apart by their number among them.
    """
    if hasattr(value, "__record__"):
        yield "", value
    elif isinstance(value, Mapping):
        yield from ((f".{key}", part) for key, part in value.items() if hasattr(part, "__record__"))
    elif isinstance(value, tuple | list):
        words = [str(getattr(part, "name", number)) for number, part in enumerate(value)]
        for number, (word, part) in enumerate(zip(words, value, strict=True)):
            if hasattr(part, "__record__"):
                among = f".{words[:number].count(word)}" if words.count(word) > 1 else ""
                yield f".{word}{among}", part


def _fact(path: str, told: Quantity, value: float, radians: bool) -> Chosen:
    given = told.value(float(value))
    ((key, shown),) = given.items() if radians else in_degrees(given).items()
    name, unit = named(key)
    return Chosen(path + name, unit, shown, told.meaning, told.symbol)


def forms_of_details(stage: str, scene: Scene) -> Iterator[Chosen]:
    """What the details of a stage may give out, without a value: as the record declares it that they say they return.

    Details that do not say so are computed.
    """
    made = STAGES[stage].part("details")
    if made is None:
        return
    try:
        kind = get_type_hints(made).get("return")
    except NameError:  # a class that only type checkers import
        kind = None
    forms = [(path, kind) for path, kind in _kinds(kind)]
    if not forms:
        yield from details_of(stage, scene)
    for path, each in forms:
        yield from _forms(each, path.removeprefix(".") and f"{path[1:]}.", in_radians(STAGES[stage]))


def _forms(kind: Any, path: str, radians: bool) -> Iterator[Chosen]:
    """What a kind of record gives out; names that the scene has, or that are counted, stand in braces."""
    told, hints = quantities(kind), get_type_hints(kind)
    for name in dict.fromkeys((*kind.__record__.fields, *told)):
        inner = [*_kinds(hints.get(name))]
        word = told[name].name if name in told else name
        for number, each in inner:
            yield from _forms(each, f"{path}{word}{number}.", radians)
        if name in told and not inner:
            yield _fact(path, told[name], nan, radians)


def _kinds(hint: Any, several: str = "") -> Iterator[tuple[str, Any]]:
    """The kinds of records in a type, with what follows the name of each."""
    if hasattr(hint, "__record__"):
        yield several, hint
        return
    origin = get_origin(hint)
    several = ".{name}" if isinstance(origin, type) and issubclass(origin, Mapping | tuple | list) else several
    for each in get_args(hint):
        yield from _kinds(each, several)


def of_itself(stage: str, result: Any) -> Iterator[Chosen]:
    """What a stage knows of its own computation: errors, counters, warnings and notes."""
    record = STAGES[stage].dump(result)
    error = {name: value for name, value in record.error.items() if name != LAST_DIGIT}
    yield from _flat(ERROR, error, ESTIMATED)
    yield from _flat(LAST_DIGIT, record.error.get(LAST_DIGIT, {}), "change by the last digit of the data: {name}")
    yield from _flat("counters", record.counters, "counted: {name}")
    document = STAGES[stage].summary(result, stage)
    notes = [note for part in (document, *document.parts) for note in part.notes]
    warnings = [note for note in notes if note.startswith("warning")]
    for word, some in (("warnings", warnings), ("notes", [note for note in notes if note not in warnings])):
        yield Chosen(word, "", float(len(some)), HOW_MANY[word])
        yield from (each for number, note in enumerate(some, 1) for each in _held(f"{word}.{number}", note))


def _held(path: str, note: str) -> Iterator[Chosen]:
    """Value and limit of a note."""
    if isinstance(note, Note):
        for word, number in (("value", note.value), ("limit", note.limit)):
            if number is not None:
                meaning = Phrase(HELD[word][not note.name], name=note.name, note=graded(note)[1])
                yield Chosen(f"{path}.{word}", note.unit, float(number), meaning)


def _flat(path: str, values: Mapping[str, Any], meaning: str) -> Iterator[Chosen]:
    for key, value in values.items():
        if isinstance(value, Mapping):
            yield from _flat(f"{path}.{key}", value, meaning)
        elif isinstance(value, int | float):
            name, unit = named(key)
            yield Chosen(f"{path}.{name}", unit, float(value), Phrase(meaning, name=_of_what(f"{path}.{name}")))


def _of_what(name: str) -> str:
    path, _, last = name.partition(".")[2].rpartition(".")
    return f"{path} {last}".strip().replace("_", " ").replace(".", ", ")


def error_meaning(name: str) -> str:
    """What a fact ``error.NAME`` of a summary means, as that by choice; empty for other facts.

    NAME alone says too little: what the last digit does to the positions is called ``position`` as well.

    >>> error_meaning("error.position"), error_meaning("start-up.error.speed"), error_meaning("S_error")
    ('estimated relative error: position', 'estimated relative error: speed', '')
    """
    start = 0 if name.startswith(f"{ERROR}.") else name.find(f".{ERROR}.") + 1
    return Phrase(ESTIMATED, name=_of_what(name[start:])) if name.startswith(f"{ERROR}.", start) else ""
