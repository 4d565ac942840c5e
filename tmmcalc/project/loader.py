"""Reading a spec: file, TOML, overrides, tables and checks; all faults in one SpecError."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from copy import deepcopy
from pathlib import Path as FilePath
from typing import TYPE_CHECKING, Any

from pydantic import ValidationError

from tmmcalc.core.errors import Fault, SpecError, UsageError
from tmmcalc.core.files import NoFileError, read_file
from tmmcalc.project.checks import check
from tmmcalc.project.filekeys import names_files
from tmmcalc.project.root import Spec, Written
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.hidden import hidden, may_hide
from tmmcalc.spec.limits import MOST_BYTES
from tmmcalc.spec.outline import subtable
from tmmcalc.spec.phrases import Path, show, show_path
from tmmcalc.spec.quantities import BY_MOTOR, CLOCKWISE
from tmmcalc.spec.syntax import check_limits, read_toml

if TYPE_CHECKING:
    from tmmcalc.spec.outline import Rows

SAME = 1e-3  # relative difference up to which a typed size is a found one, rounded


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
        self._hides = any(map(may_hide, (text, *fixed))) and bool(hidden(self.data))

    def spec(self, assignments: Sequence[str] = ()) -> Spec:
        """Return the checked spec with these overrides too; raises as ``load_spec``."""
        return self.of(*_changed(self.data, assignments), any(map(may_hide, assignments)))

    def of(self, data: dict[str, Any], changed: Sequence[Path] = (), hiding: bool = False) -> Spec:
        """Return the checked spec of another document, of which ``changed`` paths do not stand in the text.

        ``hiding``: these paths may hold hidden characters.
        """
        hides = hidden(data) if hiding or self._hides else []
        if names_files(data):
            data = deepcopy(data)  # what is read from files takes its place in the document
        try:
            return _checked(data, self.text, self.file, [*self._fixed, *changed], self.folder, hides)
        except RecursionError:
            check_limits(self.text, self.file)
            raise


def read_text(path: str | FilePath, most: int = MOST_BYTES) -> str:
    """Return the text of a spec file; raise UsageError unless it is readable, UTF-8 and of at most so many bytes."""
    try:
        content = read_file(FilePath(path), most)
    except FileNotFoundError:
        raise UsageError(f"there is no file {path}", remedy="check the name, or start from a ready spec") from None
    except NoFileError as error:
        folder = error.kind == "a folder"
        raise UsageError(
            f"{path} is {'a directory' if folder else f'{error.kind}, not a file'}",
            remedy="name the spec file in it" if folder else "write it to a file first, and name that",
        ) from None
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise UsageError(f"{path} cannot be read: {reason}", remedy="check the name and the permissions") from None
    if len(content) > most:
        remedy = "split it, or keep long tables in CSV files that the spec names"
        raise UsageError(f"{path} is larger than {most // 10**6} MB", limit=most, remedy=remedy)
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = content.count(b"\n", 0, error.start) + 1
        column = error.start - content.rfind(b"\n", 0, error.start)
        raise UsageError(f"{path}:{line}:{column} is not UTF-8 text", remedy="save it as UTF-8") from None


def _changed(data: dict[str, Any], overrides: Sequence[str]) -> tuple[dict[str, Any], list[Path]]:
    """The document with its overrides, and the paths that they set."""
    if not overrides:
        return data, []
    from tmmcalc.spec.override import apply

    return apply(data, overrides)


def _checked(
    data: dict[str, Any], text: str, file: str, changed: list[Path], folder: FilePath, hides: list[Finding]
) -> Spec:
    places = _Places(text, file, changed)
    found, rows = _read_files(data, folder)
    checked = check(data, places.line_of, rows)
    spec = None
    try:
        spec = Spec.model_validate(data)
        found += checked
    except ValidationError as error:
        from tmmcalc.project.wording import findings  # late: only faults need it

        found += findings(error, checked)
    if hides:
        places_of_hidden = {finding.path for finding in hides}
        found = [*hides, *(finding for finding in found if finding.path not in places_of_hidden)]
    if found or spec is None:
        check_limits(text, file)  # what is nested too deeply has been read, but its faults would not say so
        raise SpecError(file, [_fault(finding, data, places) for finding in found])
    spec._written = Written(data, text, file, tuple(changed), folder)
    return _followed(_geared(spec, data, places), data)


def _geared(spec: Spec, data: dict[str, Any], places: _Places) -> Spec:
    """The spec with pitch radius and pressure angle of the gear on the crank as those of its open pair.

    A value that is given stays, if it is that of the pair to `SAME`.
    """
    drive = spec.drive
    if drive is None or drive.kind != "gear" or spec.open_pair is None:
        return spec
    from tmmcalc.gears.openpair import pitch_of_gear  # late: it solves the pair
    from tmmcalc.gears.tables.tasks.open_pair import to_open_pair

    pair = to_open_pair(spec)
    assert pair is not None
    radius, angle = pitch_of_gear(pair.pair)
    found = {"radius": radius, "mesh_angle": angle, "internal": pair.pair.kind == "internal"}
    given = {key: value for key in found if (value := getattr(drive, key)) is not None}
    others = [key for key, value in given.items() if abs(value - found[key]) > SAME * abs(found[key])]
    if others:
        told = {
            "radius": f'"{1e3 * radius:.7g} mm"',
            "mesh_angle": f'"{math.degrees(angle):.7g} deg"',
            "internal": str(found["internal"]).lower(),
        }
        wrong = (
            Finding(
                ("drive", key),
                f"{show(data['drive'][key])} is not that of the {pair.name}, which has {key} = {told[key]}",
                "remove it: [open_pair] gives it",
            )
            for key in others
        )
        raise SpecError(places.file, [_fault(finding, data, places) for finding in wrong])
    gear = drive.model_copy(update={**found, **given})
    gear._open = pair.name
    return spec.model_copy(update={"drive": gear})


def _followed(spec: Spec, data: dict[str, Any]) -> Spec:
    """The spec with the mean speed of its crank as a number, where the motor is to give it."""
    drive = subtable(data, "torque") or subtable(subtable(data, "mechanism"), "input")
    said = drive.get("speed")
    if said not in (BY_MOTOR, CLOCKWISE):
        return spec
    sense = -1.0 if said == CLOCKWISE else 1.0
    from tmmcalc.machine.followed import followed  # late: it reduces the machine

    def at(speed: float) -> Spec:
        if spec.torque is not None:
            return spec.model_copy(update={"torque": spec.torque.run_by(speed)})
        assert spec.mechanism is not None
        crank = spec.mechanism.input.model_copy(update={"speed": sense * speed})
        return spec.model_copy(update={"mechanism": spec.mechanism.model_copy(update={"input": crank})})

    return at(followed(at))


def refused(spec: Spec, findings: Sequence[Finding]) -> SpecError:
    """The error of faults that no check of the tables alone can see, each with its place in the text of the spec."""
    written = spec._written
    if written is None:
        raise UsageError("the spec was not read from a text", remedy="take load_spec or parse_spec")
    places = _Places(written.text, written.file, list(written.changed))
    return SpecError(written.file, [_fault(finding, written.document, places) for finding in findings])


def with_tables(spec: Spec, tables: dict[str, Any]) -> Spec:
    """Return the checked spec with further tables; raises as ``load_spec`` does."""
    written = spec._written
    if written is None:
        raise UsageError("the spec was not read from a text", remedy="take load_spec or parse_spec")
    document = {**deepcopy(written.document), **tables}
    changed = [*written.changed, *((name,) for name in tables)]
    return _checked(document, written.text, written.file, changed, written.folder, [])


def _read_files(data: dict[str, Any], folder: FilePath) -> tuple[list[Finding], dict[Path, Rows]]:
    if not names_files(data):
        return [], {}
    from tmmcalc.project.files import read_files  # late: most specs name no files

    return read_files(data, folder)


class _Places:
    """Places in the source, scanned when first asked for; values set by an override have none."""

    def __init__(self, text: str, file: str, changed: list[Path]) -> None:
        self._text, self.file = text, file
        self._changed = changed
        self._place_of: Callable[[Path], tuple[int, int] | None] | None = None

    def of(self, path: Path) -> tuple[int, int] | None:
        """Line and column of a path."""
        if self.is_override(path):
            return None
        if self._place_of is None:
            from tmmcalc.spec.source import Source  # late: only faults need it

            self._place_of = Source(self._text).place_of
        return self._place_of(path)

    def line_of(self, path: Path) -> int | None:
        place = self.of(path)
        return None if place is None else place[0]

    def is_override(self, path: Path) -> bool:
        return any(path[: len(changed)] == changed for changed in self._changed)


def _fault(finding: Finding, data: dict[str, Any], places: _Places) -> Fault:
    path, message, remedy = finding
    whose = _whose(path, data)
    if whose and whose not in message:
        message = f"{message} ({whose})"
    if places.is_override(path):
        message = f"{message} (set by an override, not in the file)"
    line, column = places.of(path) or (None, None)
    return Fault(show_path(path), line, message, remedy, column)


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
