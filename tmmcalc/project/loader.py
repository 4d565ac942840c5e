"""Reading a spec: file, TOML, overrides, tables and checks; all faults in one SpecError."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path as FilePath
from typing import TYPE_CHECKING, Any

from pydantic import ValidationError

from tmmcalc.core.errors import Fault, SpecError, UsageError
from tmmcalc.project.checks import check
from tmmcalc.project.filekeys import names_files
from tmmcalc.project.root import Spec
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.phrases import Path, show_path
from tmmcalc.spec.syntax import read_toml, too_deep

if TYPE_CHECKING:
    from tmmcalc.spec.outline import Rows

LARGEST_FILE = 10_000_000  # bytes; a spec of a hundred links has some ten thousand


def load_spec(path: str | FilePath, overrides: Sequence[str] = ()) -> Spec:
    """Return the checked spec of a TOML file.

    ``overrides`` are assignments such as ``"mechanism.grid.positions=36"`` that replace values of the file.

    Raises UsageError if the file cannot be read or an override does not fit, SpecError with all faults of
    the spec and of the CSV files that it names, each with its TOML path and line.
    """
    return parse_spec(read_text(path), str(path), overrides, FilePath(path).parent)


def parse_spec(text: str, file: str = "<spec>", overrides: Sequence[str] = (), folder: str | FilePath = ".") -> Spec:
    """Return the checked spec of a TOML text; ``file`` names it in messages. Raises as ``load_spec``.

    Files that the spec names are read from ``folder``.
    """
    return Variants(text, file, FilePath(folder), overrides).spec()


class Variants:
    """Variants of one TOML text, which is read once; ``fixed`` are overrides that all of them have.

    Raises as ``load_spec`` for text that is no TOML and for overrides that do not fit.
    """

    def __init__(self, text: str, file: str, folder: FilePath, fixed: Sequence[str] = ()) -> None:
        self.text, self.file, self.folder = text, file, folder
        self.data, self._fixed = _changed(read_toml(text, file), fixed)

    def spec(self, assignments: Sequence[str] = ()) -> Spec:
        """Return the checked spec with these overrides too; raises as ``load_spec``."""
        return self.of(*_changed(self.data, assignments))

    def of(self, data: dict[str, Any], changed: Sequence[Path] = ()) -> Spec:
        """Return the checked spec of another document, of which ``changed`` paths do not stand in the text."""
        if names_files(data):
            from copy import deepcopy  # what is read from files takes its place in the document

            data = deepcopy(data)
        try:
            return _checked(data, self.text, self.file, [*self._fixed, *changed], self.folder)
        except RecursionError:
            raise SpecError(self.file, [too_deep()]) from None


def read_text(path: str | FilePath) -> str:
    """Return the text of a spec file; raise UsageError unless it is readable, UTF-8 and of sensible size."""
    try:
        with FilePath(path).open("rb") as file:
            content = file.read(LARGEST_FILE + 1)
    except FileNotFoundError:
        raise UsageError(f"there is no file {path}", remedy="check the name, or start from a ready spec") from None
    except IsADirectoryError:
        raise UsageError(f"{path} is a directory", remedy="name the spec file in it") from None
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise UsageError(f"{path} cannot be read: {reason}", remedy="check the name and the permissions") from None
    if len(content) > LARGEST_FILE:
        raise UsageError(f"{path} is larger than {LARGEST_FILE // 10**6} MB, too large for a spec")
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = content.count(b"\n", 0, error.start) + 1
        raise UsageError(f"{path} is not UTF-8 text (line {line})", remedy="save it as UTF-8") from None


def _changed(data: dict[str, Any], overrides: Sequence[str]) -> tuple[dict[str, Any], list[Path]]:
    """The document with its overrides, and the paths that they set."""
    if not overrides:
        return data, []
    from tmmcalc.spec.override import apply

    return apply(data, overrides)


def _checked(data: dict[str, Any], text: str, file: str, changed: list[Path], folder: FilePath) -> Spec:
    lines = _Lines(text, changed)
    found, rows = _read_files(data, folder)
    checked = check(data, lines.line_of, rows)
    spec = None
    try:
        spec = Spec.model_validate(data)
        found += checked
    except ValidationError as error:
        from tmmcalc.project.wording import findings  # late: only faults need it

        found += findings(error, checked)
    if found or spec is None:
        raise SpecError(file, [_fault(finding, data, lines) for finding in found])
    return spec


def _read_files(data: dict[str, Any], folder: FilePath) -> tuple[list[Finding], dict[Path, Rows]]:
    if not names_files(data):
        return [], {}
    from tmmcalc.project.files import read_files  # late: most specs name no files

    return read_files(data, folder)


class _Lines:
    """Lines of the source, scanned when first asked for; values set by an override have none."""

    def __init__(self, text: str, changed: list[Path]) -> None:
        self._text = text
        self._changed = changed
        self._line_of: Callable[[Path], int | None] | None = None

    def line_of(self, path: Path) -> int | None:
        if self.is_override(path):
            return None
        if self._line_of is None:
            from tmmcalc.spec.source import Source  # late: only faults need it

            self._line_of = Source(self._text).line_of
        return self._line_of(path)

    def is_override(self, path: Path) -> bool:
        return any(path[: len(changed)] == changed for changed in self._changed)


def _fault(finding: Finding, data: dict[str, Any], lines: _Lines) -> Fault:
    path, message, remedy = finding
    whose = _whose(path, data)
    if whose and whose not in message:
        message = f"{message} ({whose})"
    if lines.is_override(path):
        message = f"{message} (set by an override, not in the file)"
    return Fault(show_path(path), lines.line_of(path), message, remedy)


def _whose(path: Path, data: dict[str, Any]) -> str:
    """Return the element that a path with an index belongs to: ``link 3``, ``joint "D0"``, ``load "Q"``."""
    from tmmcalc.project.words import words_of  # late: only faults need it

    for inner, (key, form) in words_of(path[0]).elements.items() if path else ():
        home = (path[0], *filter(None, inner.split(".")))
        at = len(home)
        if path[:at] != home or len(path) <= at:
            continue
        listed: Any = data
        for step in home:
            listed = listed[step]
        element = listed[path[at]]
        value = element.get(key) if isinstance(element, dict) else None
        named = isinstance(value, int | str) and path[at + 1 :] != (key,) and str(value).isprintable()
        return form.format(str(value)[:40]) if named else ""
    return ""
