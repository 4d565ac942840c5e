"""A class as one question for each asked result, with a set of data for each variant (type ``calculated``).

All names of data are shared by the questions of the category and synchronised: in a quiz a student has the same variant
in each of them. Known mistakes have no numbers here: what they give is no formula of the data.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from hashlib import sha256
from typing import TYPE_CHECKING

from tmmcalc.classroom.moodle import elements
from tmmcalc.classroom.moodle.numerical import SCHEME, asked_in, units_of
from tmmcalc.classroom.moodle.scenes import Told, markup, senses, sentences, table
from tmmcalc.core.errors import UsageError
from tmmcalc.report.language import tr
from tmmcalc.spec.units import conversion, kind_of

if TYPE_CHECKING:
    from tmmcalc.classroom.marking import Rules
    from tmmcalc.classroom.model import Item, Keybook

MOST = 100  # sets of data that a question may have
RELATIVE, NOMINAL = "1", "2"  # kinds of tolerance
DECIMALS = 6  # of values that Moodle would draw by itself
SIGNIFICANT = "2"  # digits of the right answer: significant ones

Columns = dict[str, list[float]]  # values of all variants by the names of data


def dataset_questions_of(book: Keybook, scenes: Sequence[Told], title: str, name: str, rules: Rules) -> Iterator[str]:
    """The questions, in the language in force; raises UsageError for more variants than a question may have."""
    if len(book.keys) > MOST:
        rule = f"a question of Moodle has {MOST} sets of data at most, the class has {len(book.keys)} variants"
        raise UsageError(rule, where="--moodle-dataset", value=len(book.keys), limit=MOST, remedy="take --moodle")
    name, of = elements.stem(name), _digest(book, scenes)
    columns: Columns = {f"v{of}": [float(key.number) for key in book.keys]}
    told = dict.fromkeys((what, names) for scene in scenes for what, names, _ in scene.own)
    rows = [_row(columns, scenes, mark, number, of) for number, mark in enumerate(told, 1)]
    text = f"<p>{tr('Variant {number}', number=f'{{v{of}}}')}</p>"
    if scenes[0].scheme:
        text += f'<p><img src="@@PLUGINFILE@@/{SCHEME}" alt="{markup(tr("Scheme of the mechanism"))}"></p>'
        first = tr("The lengths of the scheme are those of variant {number}.", number=f"{book.keys[0].number:02d}")
        text += f"<p>{markup(first)}</p>"
    text += sentences(scenes[0].said) + table(rows, tr("Data of this variant alone"), cell=str)
    text += table(scenes[0].common, tr("Data of all variants")) + senses(book.items)
    picture = elements.file(SCHEME, scenes[0].scheme.encode()) if scenes[0].scheme else ""
    yield elements.category((title,), "")
    for at, (item, meaning) in enumerate(zip(book.items, scenes[0].meanings, strict=True)):
        right = [float(f"{key.values[at]:.10g}") for key in book.keys]
        yield elements.question(
            "calculated",
            item.name,
            text + asked_in(item, meaning),
            elements.element("synchronize", "1"),
            elements.element("single", "0"),
            elements.element("answernumbering", "abc"),
            elements.element("shuffleanswers", "0"),
            *_combined(),
            *_answers(item, f"{{a{at + 1}{of}}}", right, rules),
            *elements.units(units_of(item.unit)),
            _definitions(columns | {f"a{at + 1}{of}": right}),
            files=picture,
            points=item.weight,
            key=f"{name}-all-{at + 1}",
        )


def _digest(book: Keybook, scenes: Sequence[Told]) -> str:
    """What the names of data end with. Shared data of a name that a category has already would stay as they are."""
    told = repr([(key.number, key.values, scene.numbers) for key, scene in zip(book.keys, scenes, strict=True)])
    return f"_{sha256(told.encode()).hexdigest()[:6]}"


def _row(columns: Columns, scenes: Sequence[Told], mark: tuple[str, str], number: int, of: str) -> list[str]:
    """A row of data as HTML, with names in place of what differs; what they stand for is added to the columns."""
    places = [[k for k, row in enumerate(scene.own) if (row[0], row[1]) == mark][:1] for scene in scenes]
    head = [*map(markup, mark)]
    sizes = {len(scene.numbers[at[0]]) if at else 0 for scene, at in zip(scenes, places, strict=True)}
    if sizes == {0} or len(sizes) > 1:
        texts = {scene.own[at[0]][2] if at else "" for scene, at in zip(scenes, places, strict=True)}
        return [*head, markup(texts.pop() if len(texts) == 1 else tr("see the task sheet"))]
    (count,) = sizes
    own = [f"d{number}{f'_{k}' if count > 1 else ''}{of}" for k in range(1, count + 1)]
    values = [scene.numbers[at] for scene, (at,) in zip(scenes, places, strict=True)]
    columns |= {name: [*column] for name, column in zip(own, zip(*values, strict=True), strict=True)}
    shown = "; ".join(f"{{{name}}}" for name in own)
    return [*head, f"{shown} {markup(scenes[0].units[places[0][0]])}".strip()]


def _combined() -> Iterator[str]:
    for name in ("correctfeedback", "partiallycorrectfeedback", "incorrectfeedback"):
        yield elements.element(name, elements.html(""), format="html")


def _answers(item: Item, formula: str, values: Sequence[float], rules: Rules) -> Iterator[str]:
    """What is right, of the other sign too where that is left open, then what is right by plans, then all else.

    An angle a whole turn aside is right within what the least of the ``values`` of all variants allows: a relative
    tolerance would be one of the turned angle.
    """
    either = [formula, f"-{formula}"] if item.either_sense else [formula]
    turn = conversion("rev", item.unit) if kind_of(item.unit) == "angle" else 0.0
    turned = max(item.within, item.tolerance * min(map(abs, values)))
    for each in either:
        yield _answer(item, each, 100.0, RELATIVE, item.tolerance, tr("Right."))
        if item.within:
            yield _answer(item, each, 100.0, NOMINAL, item.within, tr("Right."))
        if turn and turned:
            for sign in "-+":
                yield _answer(item, f"{each}{sign}{turn:.12g}", 100.0, NOMINAL, turned, tr("Right."))
    if item.plans > item.tolerance and rules.for_plans:
        for each in either:
            said = tr("Right within the accuracy of plans.")
            yield _answer(item, each, elements.grade(rules.for_plans), RELATIVE, item.plans, said)
    yield _answer(item, "*", 0.0, RELATIVE, 0.0, "")


def _answer(item: Item, formula: str, part: float, kind: str, within: float, feedback: str) -> str:
    return elements.answer(
        formula,
        part,
        feedback,
        elements.element("tolerance", elements.shown(float(f"{within:.6g}"))),
        elements.element("tolerancetype", kind),
        elements.element("correctanswerformat", SIGNIFICANT),
        elements.element("correctanswerlength", str(item.digits)),
    )


def _definitions(columns: Columns) -> str:
    """What the names stand for: a value of each for every variant, under its number from 1 on."""
    return elements.element("dataset_definitions", "".join(_definition(*each) for each in columns.items()))


def _definition(name: str, values: Sequence[float]) -> str:
    items = "".join(
        elements.element("dataset_item", elements.element("number", str(k)) + elements.element("value", shown))
        for k, shown in enumerate(map(elements.shown, values), 1)
    )
    return elements.element(
        "dataset_definition",
        "".join(
            (
                elements.element("status", elements.words("shared")),
                elements.element("name", elements.words(name)),
                elements.element("type", "calculated"),
                elements.element("distribution", elements.words("uniform")),
                elements.element("minimum", elements.words(elements.shown(min(values)))),
                elements.element("maximum", elements.words(elements.shown(max(values)))),
                elements.element("decimals", elements.words(str(DECIMALS))),
                elements.element("itemcount", str(len(values))),
                elements.element("dataset_items", items),
                elements.element("number_of_items", str(len(values))),
            )
        ),
    )
