"""What is looked for in what students get: the first digits of right values, whatever their units and signs.

One that begins as a given number does cannot be told from it and is left out.
"""

from __future__ import annotations

import math
import re
import zipfile
from collections.abc import Iterator
from io import BytesIO
from pathlib import Path
from xml.etree import ElementTree

import pytest

from classroom.school import School

DIGITS = 4
NUMBER = re.compile(r"(?<![\w.,])[-−+]?(\d[\d\u00a0\u202f]*(?:[.,]\d+)?)(?:[eE]([-+]?\d+))?")
GEOMETRY = {"d", "points", "x", "y", "x1", "x2", "y1", "y2", "cx", "cy", "r", "width", "height", "viewBox", "transform"}


def beginning(value: float) -> str:
    """The first digits of a number, whatever its size and sign.

    >>> beginning(-0.0571429), beginning(571.43)
    ('5714', '5714')
    """
    return f"{abs(value):.{DIGITS - 1}e}"[: DIGITS + 1].replace(".", "") if value else ""


def numbers_in(text: str) -> Iterator[str]:
    """Beginnings of the numbers of a text that have so many digits."""
    for found in NUMBER.finditer(text):
        digits = re.sub(r"[\u00a0\u202f]", "", found[1]).replace(",", ".")
        if len(digits.replace(".", "").lstrip("0")) >= DIGITS:
            yield beginning(float(digits))


def leaks(text: str, school: School, given: set[str]) -> set[tuple[int, str]]:
    """Variants and items whose right value stands in a text."""
    seen = {*numbers_in(text)} - given
    return {
        (key.number, item.name)
        for key in school.book.keys
        for item, value in zip(school.items, key.values, strict=True)
        if {beginning(value), beginning(math.nextafter(value, math.inf) * (1 + 1e-5))} & seen
    }


def words_of(file: Path) -> str:
    """All that can be read in a file, with what is said of it."""
    data = file.read_bytes()
    match file.suffix:
        case ".pdf":
            reader = pytest.importorskip("pypdfium2")
            document = reader.PdfDocument(data)
            pages = [page.get_textpage().get_text_range() for page in document]
            return "\n".join([*pages, *map(str, document.get_metadata_dict().values())])
        case ".docx" | ".xlsx":
            with zipfile.ZipFile(BytesIO(data)) as archive:
                parts = [archive.read(name) for name in archive.namelist() if name.endswith((".xml", ".rels", ".svg"))]
            return "\n".join(" ".join(ElementTree.fromstring(part).itertext()) for part in parts)
        case ".svg":
            root = ElementTree.fromstring(data)
            said = [value for each in root.iter() for name, value in each.attrib.items() if name not in GEOMETRY]
            return " ".join([*root.itertext(), *(value for value in said if not re.search(r"\d,\d|#|px", value))])
        case ".html":
            return re.sub(r"<[^>]*>", " ", data.decode())
        case ".png":
            return "\n".join(part.decode("latin-1") for part in re.findall(rb"(?:tEXt|iTXt)([^\x00]*\x00[ -~]*)", data))
        case _:
            return data.decode("utf-8-sig")


def given_in(school: School) -> set[str]:
    """Beginnings of what is given: of the assignment, and of the numbers of all variants."""
    texts = [school.made.file(school.folder).read_text(encoding="utf-8")]
    texts += [each for variant in school.made.variants for each in variant.assignments]
    found = re.findall(r"\d+(?:\.\d+)?(?:e[-+]?\d+)?", " ".join(texts))
    return {beginning(float(each)) for each in found}
