"""Elements of Moodle XML.

A file is one ``<quiz>`` of ``<question>``; one of the type ``category`` says where those after it go. Texts stand in
``<text>``, HTML in CDATA; a picture is a ``<file>`` beside the text that refers to it by ``@@PLUGINFILE@@``. Grades are
parts of a whole in per cent, of which Moodle takes those in `GRADES` alone. Source: ``question/format/xml/format.php``
of Moodle 2.1 to 4.5.
"""

from __future__ import annotations

import re
from base64 import b64encode
from collections.abc import Iterable, Sequence

from tmmcalc.core.escaping import escape, quoteattr

GRADES = (
    *(100.0, 90.0, 83.33333, 80.0, 75.0, 70.0, 66.66667, 60.0, 50.0, 40.0, 33.33333, 30.0, 25.0, 20.0),
    *(16.66667, 14.28571, 12.5, 11.11111, 10.0, 5.0, 0.0),
)
LONGEST_NAME = 255  # characters of the name of a question, of each level of a category
STEM, LONGEST_ID = 80, 100  # characters of an idnumber: of what those of a class have alike, of all
_OPENED = str.maketrans("<>", "‹›")  # in names, of which Moodle strips tags
_BARRED = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\ufffe\uffff\ud800-\udfff]")  # what XML cannot hold


def grade(part: float) -> float:
    """The grade that Moodle has nearest to a part of a whole.

    >>> grade(0.5), grade(0.85), grade(1 / 3)
    (50.0, 83.33333, 33.33333)
    """
    return min(GRADES, key=lambda each: abs(each - 100 * part))


def shown(number: float) -> str:
    """A number with its shortest digits that give it again."""
    return repr(number + 0.0).removesuffix(".0")


def words(text: str) -> str:
    """``<text>`` with plain words."""
    return f"<text>{escape(_held(text))}</text>"


def html(markup: str) -> str:
    """``<text>`` with HTML, in which the end of a CDATA section cannot end it."""
    inside = _held(markup).replace("]]>", "]]]]><![CDATA[>")
    return f"<text><![CDATA[{inside}]]></text>"


def element(tag: str, content: str, /, **attributes: str) -> str:
    """An element with its content, which is XML."""
    said = "".join(f" {key}={quoteattr(value)}" for key, value in attributes.items())
    return f"<{tag}{said}>{content}</{tag}>"


def file(name: str, data: bytes) -> str:
    """A file within the text that refers to it."""
    return element("file", b64encode(data).decode(), name=name, path="/", encoding="base64")


def question(kind: str, name: str, text: str, *parts: str, files: str = "", points: float = 1.0, key: str = "") -> str:
    """A question: its name, its text as HTML with files, and what its kind has."""
    head = (
        element("name", words(name.translate(_OPENED)[:LONGEST_NAME])),
        element("questiontext", html(text) + files, format="html"),
        element("generalfeedback", html(""), format="html"),
        element("defaultgrade", shown(points)),
        element("penalty", "0.3333333" if points else "0"),
        element("hidden", "0"),
        element("idnumber", escape(_held(key[:LONGEST_ID]))),
    )
    return element("question", "\n    ".join(("", *head, *parts)) + "\n  ", type=kind)


def category(levels: Sequence[str], info: str) -> str:
    """Where the questions after it go. It has no idnumber: a course takes each but once, and refuses the file else."""
    path = element("category", words("/".join(("$course$", "top", *map(_level, levels)))))
    said = element("info", words(info), format="moodle_auto_format")
    return element("question", f"\n    {path}\n    {said}\n  ", type="category")


def _level(name: str) -> str:
    """The name of a category within its path, in which a slash of its own parts no levels.

    >>> _level("A/B"), _level("/A")
    ('A//B', ' //A')
    """
    cut = name.translate(_OPENED)[:LONGEST_NAME].strip()
    ends = (" " * cut.startswith("/"), " " * cut.endswith("/"))  # three slashes in a row would part before the second
    return cut.replace("/", "//").join(ends)


def stem(name: str) -> str:
    """What the idnumbers of a class begin with, so short that their ends are not cut."""
    return name[:STEM]


def answer(value: str, part: float, feedback: str, *more: str) -> str:
    """An answer with its grade [%] and what is said of it."""
    said = element("feedback", html(feedback), format="html")
    return element("answer", "".join((words(value), *more, said)), fraction=shown(part), format="moodle_auto_format")


def units(named: Sequence[tuple[str, float]]) -> Iterable[str]:
    """Units with how many of each make one of the first; how units are asked for: they may be left out."""
    yield element("unitgradingtype", "0")
    yield element("unitpenalty", "0.1")
    yield element("showunits", "0" if named else "3")  # typed with the number, or none
    yield element("unitsleft", "0")
    if named:
        each = (element("multiplier", shown(by)) + element("unit_name", escape(unit)) for unit, by in named)
        yield element("units", "".join(element("unit", one) for one in each))


def quiz(questions: Iterable[str]) -> bytes:
    """The whole file."""
    body = "\n  ".join(("", *questions))
    return f'<?xml version="1.0" encoding="UTF-8"?>\n<quiz>{body}\n</quiz>\n'.encode()


def _held(text: str) -> str:
    return _BARRED.sub("", text)
