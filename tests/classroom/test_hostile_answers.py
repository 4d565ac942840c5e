"""Answers come from strangers: whatever a file is, it costs one clear message, and the rest is read."""

from __future__ import annotations

import io
import os
import resource
import time
import zipfile
from collections.abc import Callable
from pathlib import Path

import pytest

from classroom.books import press_class
from tmmcalc.classroom.answers.reading import read_answers

BOOK = press_class()
GOOD = "H;120,5;мм\nK;1,213\n"
HEAD = '<?xml version="1.0"?>'
BOMB = "".join(f'<!ENTITY l{k + 1} "{f"&l{k};" * 10}">' for k in range(12))


def zipped(parts: dict[str, bytes | str]) -> bytes:
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in parts.items():
            archive.writestr(name, content)
    return buffer.getvalue()


def workbook(sheet: bytes | str, **more: bytes | str) -> bytes:
    book = f'{HEAD}<workbook><sheets><sheet name="a" id="r1"/></sheets></workbook>'
    return zipped(
        {"xl/workbook.xml": book, "xl/worksheets/sheet1.xml": sheet} | {f"xl/{k}.xml": v for k, v in more.items()}
    )


def lying(content: bytes) -> bytes:
    """An archive whose headers say that its parts are small."""
    size = (60_000_000).to_bytes(4, "little")
    return content.replace(size, (100).to_bytes(4, "little"))


FILES: dict[str, tuple[bytes, str]] = {
    "empty.csv": (b"", "is empty"),
    "blank.csv": (b" \r\n\t\r\n", "is empty"),
    "mark.csv": (b"\xef\xbb\xbf", "is empty"),
    "large.csv": (b"H;1\n" * 1_500_000, "is larger than 5 MB"),
    "rows.csv": (b"H;1\n" * 20_001, "20001 lines"),
    "columns.csv": (b"H" + b";1" * 400, "columns"),
    "cell.csv": (b"H;" + b"1" * 5000, "characters"),
    "quote.csv": (b'H;"' + b"1;\n" * 19_000, "characters"),
    "nul.csv": (b"H;1\x00\x00\x002\nK;2\n", "no text"),
    "binary.csv": (bytes(range(256)) * 40, "no text"),
    "half.csv": (b"\xff\xfeH\x00;\x001", "no text"),
    "words.csv": ("Кохаймося, браття".encode(), "names no result"),
    "photo.jpg": (b"\xff\xd8\xff\xe0" + bytes(900), "is a picture"),
    "photo.csv": (b"\x89PNG\r\n" + bytes(900), "is a picture"),
    "report.pdf": (b"%PDF-1.7 ...", "is a PDF"),
    "old.xls": (b"\xd0\xcf\x11\xe0" + bytes(900), "old kind"),
    "program.csv": (b"\x7fELF" + bytes(900), "a program"),
    "archive.zip": (zipped({"a.csv": GOOD}), "is an archive"),
    "letter.xlsx": (zipped({"word/document.xml": "<w/>"}), "is an archive"),
    "text.xlsx": (b"not a workbook", "names no result"),
    "cut.xlsx": (workbook("<worksheet/>")[:200], "damaged"),
    "blank.xlsx": (workbook("<worksheet/>"), "empty workbook"),
    "bomb.xlsx": (workbook(b" " * 60_000_000), "MB when unzipped"),
    "liar.xlsx": (lying(workbook(b" " * 60_000_000)), "damaged"),
    "tags.xlsx": (workbook(b"<worksheet>" + b"<row/>" * 2_000_000 + b"</worksheet>"), "MB when unzipped"),
    "deep.xlsx": (workbook(b"<row>" * 500_000 + b"</row>" * 500_000), "workbook"),
    "laughs.xlsx": (
        workbook(f'{HEAD}<!DOCTYPE l [<!ENTITY l0 "ha">{BOMB}]><worksheet>&l12;</worksheet>'),
        "defines entities",
    ),
    "wide.xlsx": (workbook((f'{HEAD}<!DOCTYPE l [<!ENTITY a "b">]><row/>').encode("utf-16")), "defines entities"),
    "outside.xlsx": (
        workbook(f'{HEAD}<!DOCTYPE l [<!ENTITY x SYSTEM "file:///etc/passwd">]><row><c t="str"><v>&x;</v></c></row>'),
        "defines entities",
    ),
    "far.xlsx": (workbook('<row r="1048576"><c r="XFD1048576"><v>1</v></c></row>'), "rows"),
    "index.xlsx": (workbook('<row><c t="s"><v>99</v></c></row>'), "no workbook"),
    "number.xlsx": (workbook('<row r="one"><c><v>x</v></c></row>'), "no workbook"),
    "broken.toml": (b"H = = 1", "is no TOML"),
    "nested.toml": (b"a = " + b"[" * 5000 + b"]" * 5000, "is no TOML"),
    "tables.toml": (b"[a]\n[a]\n", "is no TOML"),
    "other.toml": (b"x = 1", "names no result"),
    "student.csv": ("студент;Нетака Людина\nH;1\nK;2\n".encode(), "does not say whose it is"),
    "99.csv": (GOOD.encode(), "does not say whose it is"),
    "Бондар.csv": ("студент;Коваль\nH;1\nK;2\n".encode(), "another student"),
    "several.csv": (b"H;K\n1;2\n3;4\n", "no column of students"),
}


@pytest.mark.parametrize("name", FILES)
def test_one_clear_message(tmp_path: Path, name: str) -> None:
    content, message = FILES[name]
    (tmp_path / name).write_bytes(content)
    (tmp_path / "Коваль.csv").write_text(GOOD, encoding="utf-8")
    began = time.process_time()
    pile = read_answers(tmp_path, BOOK.items, BOOK.keys)
    assert time.process_time() - began < 5.0
    assert [each.number for each in pile.hand_ins] == [2]
    (refused,) = pile.refused
    assert refused.source == name
    assert message in refused.message
    assert "\n" not in refused.message


def linked(folder: Path) -> None:
    (folder / "outside").write_text(GOOD, encoding="utf-8")
    (folder / "answers").mkdir()
    (folder / "answers" / "1.csv").symlink_to(folder / "outside")


def looped(folder: Path) -> None:
    (folder / "answers").mkdir()
    (folder / "answers" / "1").symlink_to(folder / "answers", target_is_directory=True)


def piped(folder: Path) -> None:
    (folder / "answers").mkdir()
    os.mkfifo(folder / "answers" / "1.csv")


def deep(folder: Path) -> None:
    (folder / "answers" / "a/b/c/d/e/f").mkdir(parents=True)


@pytest.mark.parametrize(
    ("make", "message"), [(linked, "a link"), (looped, "a link"), (piped, "a pipe"), (deep, "deep")]
)
def test_what_is_no_file(tmp_path: Path, make: Callable[[Path], None], message: str) -> None:
    make(tmp_path)
    (tmp_path / "answers" / "Коваль.csv").write_text(GOOD, encoding="utf-8")
    pile = read_answers(tmp_path / "answers", BOOK.items, BOOK.keys)
    assert [each.number for each in pile.hand_ins] == [2]
    (refused,) = pile.refused
    assert message in refused.message


def test_a_folder_named_as_a_file_is_a_folder(tmp_path: Path) -> None:
    (tmp_path / "1.csv").mkdir()
    assert read_answers(tmp_path, BOOK.items, BOOK.keys).refused == ()


def test_no_permission(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from tmmcalc.classroom.answers import reading

    def refuse(path: Path, most: int) -> bytes:
        raise PermissionError(13, "Permission denied", str(path))

    (tmp_path / "1.csv").write_text(GOOD, encoding="utf-8")
    monkeypatch.setattr(reading, "read_file", refuse)
    (refused,) = read_answers(tmp_path, BOOK.items, BOOK.keys).refused
    assert refused.message == "cannot be read: Permission denied"


def test_unseen_files_are_no_answers(tmp_path: Path) -> None:
    for name in (".DS_Store", "~$1.xlsx", "__MACOSX/1.csv", "Thumbs.db"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_bytes(b"\x00\x01")
    pile = read_answers(tmp_path, BOOK.items, BOOK.keys)
    assert (pile.hand_ins, pile.refused) == ((), ())


@pytest.mark.slow
def test_strange_names_cost_one_line(tmp_path: Path) -> None:
    rows = "".join(f"nobody {'abcdefgh'[k % 8]}{k};1;2\n" for k in range(100, 10_000))
    (tmp_path / "all.csv").write_text("student;H;K\nКоваль;1;2\n" + rows, encoding="utf-8")
    pile = read_answers(tmp_path, BOOK.items, BOOK.keys)
    assert [each.number for each in pile.hand_ins] == [2]
    (refused,) = pile.refused
    assert refused.message.endswith("and 9895 more")
    assert len(refused.message) < 300


@pytest.mark.slow
def test_a_bomb_needs_no_memory(tmp_path: Path) -> None:
    for name in ("bomb.xlsx", "tags.xlsx", "deep.xlsx", "laughs.xlsx"):
        (tmp_path / name).write_bytes(FILES[name][0])
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    read_answers(tmp_path, BOOK.items, BOOK.keys)
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < 400_000  # kB
