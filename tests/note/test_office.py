"""The document of Word as another program reads it: LibreOffice turns it to PDF, and that is read back."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
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


@pytest.fixture(scope="module", params=[(name, language) for name in NAMES for language in ("en", "uk")])
def turned(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Any:
    """A note, and the PDF that LibreOffice makes of it; CI has LibreOffice with its formulas."""
    if OFFICE is None:
        assert not os.environ.get("CI"), "LibreOffice is not installed"
        pytest.skip("LibreOffice is not installed")
    reader = pytest.importorskip("pypdfium2")
    name, language = request.param
    folder = tmp_path_factory.mktemp("office")
    with speaking(language):
        note = written(name)
        (folder / "my.docx").write_bytes(document(note, name))
    profile = f"-env:UserInstallation={(folder / 'profile').as_uri()}"
    command = [OFFICE, profile, "--headless", "--convert-to", "pdf", "--outdir", str(folder), str(folder / "my.docx")]
    subprocess.run(command, check=True, capture_output=True, timeout=300)
    return note, reader.PdfDocument(folder / "my.pdf")


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
