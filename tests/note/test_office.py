"""The document of Word as another program reads it: LibreOffice turns it to PDF, and that is read back."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
from pathlib import Path
from typing import Any

import pytest

from note.scenes import written
from tmmcalc.note.docx import document
from tmmcalc.note.tree import Equation, Grid, Image, Title
from tmmcalc.report.language import speaking

pytestmark = pytest.mark.slow
OFFICE = shutil.which("soffice")
NAMES = ("shaper", "pair-helical")
MM = 72 / 25.4


NOTES = [(name, language) for name in NAMES for language in ("en", "uk")]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """All notes as PDF, which LibreOffice makes of them in one go; CI has LibreOffice with its formulas."""
    if OFFICE is None:
        assert not os.environ.get("CI"), "LibreOffice is not installed"
        pytest.skip("LibreOffice is not installed")
    folder, files = tmp_path_factory.mktemp("office"), list[str]()
    for name, language in NOTES:
        files.append(str(folder / f"{name}-{language}.docx"))
        with speaking(language):
            Path(files[-1]).write_bytes(document(written(name), name))
    profile = f"-env:UserInstallation={(folder / 'profile').as_uri()}"
    command = [OFFICE, profile, "--headless", "--convert-to", "pdf", "--outdir", str(folder), *files]
    subprocess.run(command, check=True, capture_output=True, timeout=300)
    return folder


@pytest.fixture(scope="module", params=NOTES)
def turned(request: pytest.FixtureRequest, folder: Path) -> Any:
    """A note, and the PDF that LibreOffice makes of it."""
    reader = pytest.importorskip("pypdfium2")
    name, language = request.param
    with speaking(language):
        note = written(name)
    return note, reader.PdfDocument(folder / f"{name}-{language}.pdf")


def text_of(read: Any) -> str:
    return "\n".join(page.get_textpage().get_text_bounded() for page in read)


def test_all_of_it_is_there(turned: Any) -> None:
    note, read = turned
    said = re.sub(r"\s+", " ", text_of(read))
    for title in (each for each in note if isinstance(each, Title)):
        assert all(part.strip() in said for part in title.text.parts if isinstance(part, str)), title
    for each in note:
        if isinstance(each, Equation) and each.number:
            assert f"({each.number})" in said
        if isinstance(each, Grid | Image):
            assert f"{each.caption.word} {each.caption.number}" in said


def test_formulas_are_read_without_a_fault(turned: Any) -> None:
    """What LibreOffice cannot read of a formula it shows as a question mark upside down."""
    _, read = turned
    said = text_of(read)
    assert "¿" not in said
    assert "ERROR" not in said
    assert "Error:" not in said


def test_nothing_crosses_the_edge_of_a_page(turned: Any) -> None:
    _, read = turned
    for page in read:
        wide, high = page.get_size()
        found = page.get_textpage()
        for k in range(found.count_rects()):
            left, bottom, right, top = found.get_rect(k)
            assert left >= 15 * MM
            assert right <= wide - 5 * MM
            assert 5 * MM <= bottom <= top <= high - 5 * MM
