"""The forms of a note: which there are, what each needs, and its bytes."""

from __future__ import annotations

from collections.abc import Sequence
from importlib.util import find_spec

from tmmcalc.core.errors import UsageError
from tmmcalc.note.tree import Written
from tmmcalc.report.language import spoken
from tmmcalc.report.sheets.gosttext import TextTitles

FORMS = {  # and the packages that each needs, with their extra
    "pdf": (("typst",), "note"),
    "docx": (("docx", "reportlab", "pypdfium2"), "docx"),
    "html": ((), ""),
    "typ": ((), ""),
    "txt": ((), ""),
}


def check_form(form: str, what: str = "a note", where: str = "-o") -> None:
    """Raise `UsageError` for a form that there is not, and for a missing package; ``where`` it is asked for."""
    if form not in FORMS:
        raise UsageError(f"{what} has no form {form!r}", where=where, remedy=f"forms: {', '.join(FORMS)}")
    packages, extra = FORMS[form]
    missing = [package for package in packages if find_spec(package) is None]
    if missing:
        from tmmcalc.core.installation import install

        said = f"{what} as {form} needs {missing[0]}, which is not installed"
        raise UsageError(said, where=where, remedy=f"{install(extra)}; html and txt need nothing")


def formed(note: Sequence[Written], form: str, title: str, frame: TextTitles | None = None) -> bytes:
    """The note in a form, in the language in force; for print in frames with these titles."""
    if form == "txt":
        from tmmcalc.note.plaintext import text

        return text(note).encode()
    if form == "html":
        from tmmcalc.note.html import page

        return page(note, title, spoken()).encode()
    if form == "docx":
        from tmmcalc.note.docx import document

        return document(note, title)
    from tmmcalc.note.typst import pdf, source

    typed = source(note, spoken(), title, frame)
    return typed.encode() if form == "typ" else pdf(typed)
