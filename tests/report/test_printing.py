"""The same document as plain text, on a terminal, and in the three formats for programs."""

from __future__ import annotations

import csv
import io
import json
import math
import re
import tomllib

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.plaintext import lines
from tmmcalc.report.render import render

STROKE = Fact("stroke of D", "0.6580645 m", {"stroke_D[m]": 0.6580645161290324, "nothing": None})
PLACES = Fact("velocity", "min -1 m/s at angle_1 = 3 deg\nmax 1 m/s at angle_1 = 9 deg", {"centres[deg]": [3.0, 9.0]})
TABLE = View(["i", "phi[deg]"], [["0", "1'"], [0.1 + 0.2, 1e-17]])
WHOLE = Document(
    "Shaper: kinematics", (STROKE, PLACES), ("warning: group RRR(2,3): nearly singular",), TABLE, more="see the file"
)
RUN = Document("Shaper: run", parts=(Document("structure", (STROKE,)), Document("kinematics", (PLACES,))))


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


def printed(document: Document, form: str, stream: io.StringIO | None = None) -> str:
    stream = stream or io.StringIO()
    render(document, form, stream)  # a parameter of the test, one of the four
    return stream.getvalue()


def test_plain_text() -> None:
    assert printed(WHOLE, "table").splitlines() == [
        "Shaper: kinematics",
        "",
        "stroke of D  0.6580645 m",
        "velocity     min -1 m/s at angle_1 = 3 deg",
        "             max 1 m/s at angle_1 = 9 deg",
        "",
        "warning: group RRR(2,3): nearly singular",
        "",
        "i   phi",
        "    deg",
        "--  ---",
        "0   0.3",
        "1'  0.0",
    ]


def test_plain_parts_stand_under_their_titles() -> None:
    text = list(lines(RUN))
    assert text[:5] == ["Shaper: run", "", "structure", "", "stroke of D  0.6580645 m"]
    assert text[5:7] == ["", "kinematics"]
    assert text[-1] != ""


def test_plain_texts_side_by_side_stay_on_the_page() -> None:
    reason, gift = "needed by all that follows " * 3, "a long list of many things " * 3
    view = View(["i", "why", "gives"], [["0", "1"], [reason, "asked for"], [gift, gift]])
    text = list(lines(Document("t", table=view)))
    assert max(map(len, text)) <= 80
    rows = text[text.index("") + 3 :]
    assert " ".join(row[3:58].strip() for row in rows).split() == [*reason.split(), "asked", "for"]
    assert rows[0].startswith("0  needed by")


def test_plain_text_says_what_was_cut() -> None:
    view = View(["i", *(f"x_{k}[m]" for k in range(30))], [["0"], *([0.123456] for _ in range(30))])
    text = list(lines(Document("t", table=view, wide=True, more="see the file")))
    assert max(map(len, text)) <= 80
    shown = len(text[2].split()) - 1
    assert text[-1] == f"{30 - shown} more columns: see the file"


@given(st.lists(st.text(st.characters(codec="ascii", categories=["L", "N"]), min_size=1, max_size=12), max_size=60))
def test_long_facts_wrap_between_words_in_80_columns(words: list[str]) -> None:
    text = list(lines(Document("t", (Fact("label", " ".join(words)),))))
    assert max(map(len, text)) <= 80
    assert " ".join(text).split()[2:] == words


def test_a_last_column_of_text_is_wrapped() -> None:
    view = View(["stage", "gives"], [["structure"], ["mobility, groups, " * 8 + "order"]])
    text = list(lines(Document("t", table=view)))
    assert max(map(len, text)) <= 80
    assert text[4].startswith("structure  mobility")
    assert text[5].startswith("           ")


def test_no_column_is_narrower_than_its_longest_word() -> None:
    """Texts too wide for the page: columns stay in line, and the words that there are stay whole."""
    long = "mechanism.links[id=3].points.C[0]"
    view = View(
        ["what varies", "by", "told"], [[long, "all of " * 5 + "it"], ["b" * 25, "b"], ["word " * 9 + "w" * 30] * 2]
    )
    text = list(lines(Document("t", table=view)))
    rule = next(line for line in text if line.startswith("---"))
    first, second, third = (len(dashes) for dashes in rule.split())
    assert (first, second, third) == (len(long), 25, 30)
    for line in text[text.index(rule) + 1 :]:
        assert line[first : first + 2].strip() == ""
        assert line[first + second + 2 : first + second + 4].strip() == ""
    assert " ".join(text).split().count(long) == 1


def test_terminal_shows_the_same_facts_and_numbers(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", "80")
    monkeypatch.setenv("TERM", "dumb")
    words = printed(WHOLE, "table", Terminal()).split()
    for word in ("Shaper:", "0.6580645", "nearly", "phi", "deg", "0.3", "1'"):
        assert word in words
    assert "structure" in printed(RUN, "table", Terminal())


@pytest.mark.parametrize("width", [30, 50, 80, 120])
def test_terminal_loses_no_digit(monkeypatch: pytest.MonkeyPatch, width: int) -> None:
    monkeypatch.setenv("COLUMNS", str(width))
    monkeypatch.setenv("TERM", "xterm")
    view = View(["i", *(f"x_{k}[m]" for k in range(30))], [["0"], *([-0.123456] for _ in range(30))])
    shown = re.sub(
        r"\x1b\[[0-9;]*m", "", printed(Document("t", table=view, wide=True), "table", Terminal())
    ).splitlines()
    assert max(map(len, shown)) <= width
    cells = shown[-1].split()
    assert cells[0] == "0"
    assert set(cells[1:]) == {"-0.123456"}
    assert len(cells) - 1 == (width - 1) // 11


def test_json_and_toml_keep_every_digit() -> None:
    as_json, as_toml = json.loads(printed(WHOLE, "json")), tomllib.loads(printed(WHOLE, "toml"))
    assert as_json == as_toml
    assert as_json == {
        "title": "Shaper: kinematics",
        "stroke_D[m]": 0.6580645161290324,
        "centres[deg]": [3.0, 9.0],
        "notes": ["warning: group RRR(2,3): nearly singular"],
        "findings": [{"level": "warning", "text": "group RRR(2,3): nearly singular"}],
        "columns": {"i": ["0", "1'"], "phi[deg]": [0.1 + 0.2, 1e-17]},
    }


def test_toml_has_no_null() -> None:
    """What has no value is null in JSON; in TOML its key is left out, and in a list an empty cell stands for it."""
    limits = Fact(
        "limits", "at most 3", {"limits": [{"low": None, "high": 3.0}], "of": {"least": None, "ends": [None, 1]}}
    )
    document = Document("Crane", (limits,), table=View(["at", "low"], [["0", "1"], [None, 2.5]]))
    told, read = (form(printed(document, name)) for form, name in ((json.loads, "json"), (tomllib.loads, "toml")))
    assert told["limits"] == [{"low": None, "high": 3.0}]
    assert read["limits"] == [{"high": 3.0}]
    assert read["of"] == {"ends": ["", 1]}
    assert (told["columns"]["low"], read["columns"]["low"]) == ([None, 2.5], ["", 2.5])


def test_parts_are_found_by_their_titles() -> None:
    found = json.loads(printed(RUN, "json"))
    assert found["structure"] == {"stroke_D[m]": 0.6580645161290324}
    assert tomllib.loads(printed(RUN, "toml")) == found


def test_csv_is_the_table_alone() -> None:
    header, *rows = csv.reader(io.StringIO(printed(WHOLE, "csv")))
    assert header == ["i", "phi[deg]"]
    assert [[label, float(phi)] for label, phi in rows] == [["0", 0.1 + 0.2], ["1'", 1e-17]]


def test_csv_without_a_table_lists_names_and_values() -> None:
    rows = list(csv.reader(io.StringIO(printed(RUN, "csv"))))
    assert rows == [
        ["name", "value"],
        ["structure.stroke_D[m]", "0.6580645161290324"],
        ["kinematics.centres[deg].0", "3.0"],
        ["kinematics.centres[deg].1", "9.0"],
    ]


@given(st.lists(st.floats(allow_nan=False, allow_infinity=False), min_size=1, max_size=6))
def test_any_number_comes_back_to_the_last_bit(values: list[float]) -> None:
    document = Document("t", table=View(["x[m]"], [values]))
    assert json.loads(printed(document, "json"))["columns"]["x[m]"] == values
    assert tomllib.loads(printed(document, "toml"))["columns"]["x[m]"] == values
    assert [float(row[0]) for row in list(csv.reader(io.StringIO(printed(document, "csv"))))[1:]] == values
    assert len(printed(document, "table").splitlines()) == 5 + len(values)


@pytest.mark.parametrize("value", [math.nan, math.inf])
def test_json_refuses_what_is_no_number(value: float) -> None:
    with pytest.raises(ValueError):
        printed(Document("t", table=View(["x"], [[value]])), "json")
