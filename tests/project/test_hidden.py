"""Characters that nobody sees: refused in specs, written out wherever something of a user is shown."""

from __future__ import annotations

import io
import json
import tomllib
import xml.etree.ElementTree as ET
from pathlib import Path

import pytest
from faults import Faults

from tmmcalc.core.errors import SpecError
from tmmcalc.core.printable import hidden, printable
from tmmcalc.project import parse_spec
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.outlinefiles import circle, svg
from tmmcalc.report.render import render
from tmmcalc.report.terminal import draw
from tmmcalc.spec.hidden import may_hide

WRITTEN = {
    "\\u001b[31m": "the control character \\x1b",
    "\\u0007": "the control character \\x07",
    "\\b": "the control character \\x08",
    "\\u007F": "the control character \\x7f",
    "\\u0085": "the control character \\x85",
    "\\t": "a tab",
    "\t": "a tab",
    "\\n": "a line break",
    "\\u202E": "the hidden character \\u202e, right-to-left override",
    "\u202e": "the hidden character \\u202e, right-to-left override",
    "\u2066": "the hidden character \\u2066, left-to-right isolate",
    "\u200b": "the hidden character \\u200b, zero width space",
    "\ufeff": "the hidden character \\ufeff, zero width no-break space",
    "\\uFFFF": "the control character \\uffff",
}


@pytest.mark.parametrize("written", WRITTEN)
def test_a_title_with_one_is_refused(shaper: str, faults_of: Faults, written: str) -> None:
    (fault,) = faults_of(shaper.replace('"Shaper"', f'"Sha{written}per"'))
    assert (fault.path, fault.line, fault.column) == ("project.title", 16, 1)
    assert fault.message.endswith(f" holds {WRITTEN[written]}")
    assert not hidden(fault.message)
    assert fault.remedy


@pytest.mark.parametrize("quotes", ['"""', "'''"])
def test_a_title_of_two_lines_is_refused(shaper: str, faults_of: Faults, quotes: str) -> None:
    (fault,) = faults_of(shaper.replace('"Shaper"', f"{quotes}Sha\nper{quotes}"))
    assert fault.remedy == "write it on one line"


def test_a_key_with_one_is_one_fault(shaper: str, faults_of: Faults) -> None:
    (fault,) = faults_of(shaper.replace("[project]", '[project]\n"ti\\u202Etle" = 1'))
    assert "the key 'ti\\u202etle' holds" in fault.message


def test_an_override_with_one_is_refused(shaper: str) -> None:
    for value in ('"a\\u001bb"', '"a\u202eb"'):
        with pytest.raises(SpecError, match=r"project\.title: 'a.*b' holds the .* character .*set by an override"):
            parse_spec(shaper, overrides=[f"project.title={value}"])


@pytest.mark.parametrize(
    "title", ["Ковальський, ϕ = 30°", "[red]x[/red] :bomb:", "a<b>&c", "नमस्ते", "👩‍🔧", "C:\\\\dir"]
)
def test_other_texts_are_not(shaper: str, title: str) -> None:
    assert parse_spec(shaper.replace('"Shaper"', f'"{title}"')).project.title


def test_most_specs_are_not_looked_through(shaper: str) -> None:
    assert not may_hide(shaper.replace("\t", " "))


HOSTILE = "a\x1b[31m[red]:bomb:\u202e\x07\ud800&<"
TOLD = r"a\x1b[31m[red]:bomb:\u202e\x07\ud800&<"
DOCUMENT = Document(
    HOSTILE, (Fact(HOSTILE, HOSTILE, {HOSTILE: HOSTILE}),), (HOSTILE,), View([HOSTILE, "x[m]"], [[HOSTILE], [1.0]])
)


def rendered(form: str) -> str:
    stream = io.StringIO()
    render(DOCUMENT, form, stream)
    return stream.getvalue()


@pytest.mark.parametrize("form", ["table", "csv", "json", "toml"])
def test_every_format_writes_them_out(form: str) -> None:
    text = rendered(form)
    assert not hidden(text.replace("\n", ""))
    text.encode()
    assert ":bomb:" in text


def test_programs_read_what_is_written() -> None:
    assert json.loads(rendered("json"))["title"] == HOSTILE.replace("\ud800", "\\ud800")
    assert tomllib.loads(rendered("toml"))["title"] == HOSTILE.replace("\ud800", "\\ud800")


def test_a_terminal_shows_markup_as_it_is() -> None:
    stream = io.StringIO()
    draw(DOCUMENT, stream)
    text = stream.getvalue()
    assert text.count(TOLD) >= 4
    assert not hidden(text.replace("\n", ""))


def test_a_drawing_is_xml_whatever_its_title() -> None:
    tree = ET.fromstring(svg([circle("a", 0.01)], 1e-5, HOSTILE))
    assert tree[0].text == TOLD


def test_line_breaks_of_messages_stay() -> None:
    assert printable("a\n\tb") == "a\n\\tb"
    assert printable(str(Path("b\r"))) == "b\\r"
