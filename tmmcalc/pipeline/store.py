"""The files of a stage in the output folder: ``<stage>.toml``, ``<stage>.npz``, ``<stage>.csv``.

The toml is the manifest: it is written last and vouches for the other two by size and SHA-256, so a set
of files is believed only if it is whole. The names are the program's own: a ``<stage>.csv`` that the run
is not to have, left by an earlier run or by anybody, is removed, for it would show other numbers than
the ones beside it. A stage without arrays has no npz. The hidden file ``.lock`` keeps two runs apart.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Sequence
from contextlib import ExitStack, contextmanager, suppress
from dataclasses import replace
from functools import partial
from pathlib import Path

from tmmcalc.core.atomic import blamed_on, remove_leftovers, replace_file
from tmmcalc.core.errors import UsageError
from tmmcalc.core.files import other_kind, read_file
from tmmcalc.core.plain import plain_table
from tmmcalc.core.records import record
from tmmcalc.core.stage import CSV_ROWS
from tmmcalc.core.stored import Record, Table
from tmmcalc.pipeline import content, manifest
from tmmcalc.pipeline.lock import WAIT, locked
from tmmcalc.pipeline.manifest import Manifest, Provenance, Seal

_LARGEST = 100_000_000  # bytes of a record of a stage
_KINDS = ("toml", *manifest.DATA)


@record
class Missing:
    """There is no result of these inputs; ``reason`` says what has changed."""

    reason: str


@record
class Damaged:
    """There is a result of these inputs, but a file is not what was written: it must not be used."""

    message: str


@record
class Found:
    """A whole and valid result. The arrays are decoded only when the record is asked for."""

    manifest: Manifest
    npz: bytes | None  # checked content, so that a later run in the same folder cannot change it
    has_csv: bool

    def record(self) -> Record:
        """Return the record, equal bit for bit to the one that was saved."""
        stored = self.manifest.record
        arrays = {} if self.npz is None else content.npz_arrays(self.npz)
        return Record(stored.scalars, arrays, stored.error, stored.counters)


class Store:
    """An output folder; it is created when the first stage is saved."""

    def __init__(
        self, folder: Path, wait: float = WAIT, waiting: Callable[[float], None] = lambda seconds: None
    ) -> None:
        """Raise UsageError if ``folder`` cannot be a folder because a file is in its place.

        ``wait`` and ``waiting`` are those of `locked`.
        """
        self.folder = Path(folder)
        self._lock = partial(locked, self.folder, wait, waiting)
        with blamed_on(self.folder, "used"):
            taken = next((path for path in (self.folder, *self.folder.parents) if path.exists()), None)
        if taken is not None and not taken.is_dir():
            raise UsageError(f"{taken}: is a file, not a folder", remedy="choose another output folder")

    def path(self, stage: str, kind: str) -> Path:
        """Return the path of a stage's file of this kind: "toml", "npz" or "csv"."""
        return self.folder / f"{stage}.{kind}"

    def files(self, stage: str) -> tuple[Path, ...]:
        """Return the files that this stage has now."""
        return tuple(path for kind in _KINDS if (path := self.path(stage, kind)).exists())

    def find(self, wanted: Provenance) -> Found | Missing | Damaged:
        """Return the stored result of exactly this provenance, if it is there and every file is whole.

        Raises UsageError if a file is there but cannot be read.
        """
        path = self.path(wanted.stage, "toml")
        with blamed_on(path, "read"), self._reading():
            if not path.exists():
                return Missing("no stored result")
            try:
                stored = manifest.read(read_file(path))
            except manifest.ManifestError as fault:
                return Damaged(f"{path}: {fault}")
            if stored.provenance.hash != wanted.hash:
                return Missing(_change(stored.provenance, wanted))
            return self._verified(stored)

    def save(
        self,
        provenance: Provenance,
        record: Record,
        table: Table | None,
        csv: bool | None = None,
        columns: Sequence[str] = (),
    ) -> None:
        """Write the files of a stage, data first and manifest last; unchanged files are not touched.

        ``record`` must be plain. ``csv`` True or False forces or forbids the CSV, None writes it up to
        CSV_ROWS rows, ``columns`` names those that it has (empty: all); a CSV that is not to be is removed. Raises
        UsageError if the folder cannot be written.
        """
        contents = _contents(provenance, record, table, csv, tuple(columns))
        with blamed_on(self.folder, "written"):
            self.folder.mkdir(parents=True, exist_ok=True)
            with self._lock():
                remove_leftovers(self.folder)
                self._replace(provenance.stage, contents)

    def save_table(self, provenance: Provenance, table: Table | None, csv: bool | None, columns: Sequence[str]) -> None:
        """Write the CSV of a stage whose other files are there, and the manifest, as `save` would.

        Raises UsageError if the folder cannot be written, or has become that of another run meanwhile.
        """
        path, stage = self.path(provenance.stage, "toml"), provenance.stage
        listed = _listed(table, csv, columns)
        data = None if listed is None else content.csv_bytes(listed)
        with blamed_on(self.folder, "written"), self._lock():
            try:
                stored = manifest.read(read_file(path))
            except (manifest.ManifestError, OSError):
                stored = None
            if stored is None or stored.provenance.hash != provenance.hash:
                raise UsageError(f"{path}: another run has written it meanwhile", remedy="run again, or name a folder")
            seals = {kind: each for kind, each in stored.files.items() if kind != "csv"}
            seals |= {} if data is None else {"csv": manifest.seal(data)}
            asked = tuple(columns) if table is not None else ()
            made = replace(stored, files=seals, rows=None if table is None else table.rows, columns=asked)
            self._replace(stage, {"csv": data, "toml": manifest.written(made)})

    def remove_others(self, stages: Collection[str]) -> Iterator[tuple[str, list[str], list[str]]]:
        """Remove the files of every stage but these; yield each stage with the names of what went and what stays.

        Only files that the record of their stage vouches for are the program's own: one that was changed stays. Raises
        UsageError if a file cannot be removed.
        """
        with blamed_on(self.folder, "cleared"):
            there = [path for path in sorted(self.folder.glob("*.toml")) if path.stem not in stages]
            if not there:
                return
            with self._lock():
                for path in there:
                    with suppress(manifest.ManifestError, OSError):
                        stored = manifest.read(read_file(path, _LARGEST))
                        if stored.provenance.stage == path.stem:
                            yield path.stem, *self._remove(stored)

    def _remove(self, stored: Manifest) -> tuple[list[str], list[str]]:
        """Remove the files of a stage, the record last; names of those that went, and of those that were changed."""
        stage = stored.provenance.stage
        gone: list[str] = []
        kept: list[str] = []
        for kind, expected in stored.files.items():
            path = self.path(stage, kind)
            if not path.exists():
                continue
            own = not other_kind(path) and _mismatch(path.read_bytes(), expected) is None
            (gone if own else kept).append(path.name)
            if own:
                path.unlink()
        self.path(stage, "toml").unlink()
        return [f"{stage}.toml", *gone], kept

    def csv_differs(self, found: Found, csv: bool | None, columns: Sequence[str] = ()) -> bool:
        """Tell whether the CSV that this run is to have is not the one that is there."""
        rows = found.manifest.rows
        if rows is None:
            return found.has_csv
        if tuple(columns) != found.manifest.columns:
            return True
        return not (csv_wanted(rows, csv) == found.has_csv == ("csv" in found.manifest.files))

    @contextmanager
    def _reading(self) -> Iterator[None]:
        """Lock the folder; where nobody can write there is no lock to have, and nothing to wait for."""
        with ExitStack() as stack:
            with suppress(OSError):
                stack.enter_context(self._lock())
                remove_leftovers(self.folder)
            yield

    def _verified(self, stored: Manifest) -> Found | Damaged:
        """Check the data files. A CSV that is gone is no damage: it can be written again."""
        stage, data = stored.provenance.stage, {}
        for kind, expected in stored.files.items():
            path = self.path(stage, kind)
            if not path.exists() and kind == "csv":
                continue
            if not path.exists():
                return Damaged(f"{path}: is missing, expected {expected.size} bytes")
            data[kind] = read_file(path)
            if (fault := _mismatch(data[kind], expected)) is not None:
                return Damaged(f"{path}: {fault}")
        return Found(stored, data.get("npz"), self.path(stage, "csv").exists())

    def _replace(self, stage: str, contents: dict[str, bytes | None]) -> None:
        """Write or remove the files in the given order."""
        for kind, data in contents.items():
            path = self.path(stage, kind)
            if data is not None:
                replace_file(path, data, sealed=True)
            elif path.exists():
                path.unlink()


def csv_wanted(rows: int, csv: bool | None) -> bool:
    """Tell whether a table of ``rows`` rows is written as CSV: as asked, or up to CSV_ROWS rows."""
    return rows <= CSV_ROWS if csv is None else csv


def _contents(
    provenance: Provenance, record: Record, table: Table | None, csv: bool | None, columns: tuple[str, ...]
) -> dict[str, bytes | None]:
    """Return the bytes of every file of a stage, None for one that is not to be; the manifest comes last."""
    rows = None if table is None else table.rows
    listed = _listed(table, csv, columns)
    data = {
        "npz": content.npz_bytes(record.arrays) if record.arrays else None,
        "csv": content.csv_bytes(listed) if listed is not None else None,
    }
    seals = {kind: manifest.seal(part) for kind, part in data.items() if part is not None}
    asked = columns if table is not None else ()
    return {**data, "toml": manifest.written(Manifest(provenance, record, seals, rows, asked))}


def _listed(table: Table | None, csv: bool | None, columns: Sequence[str]) -> Table | None:
    """What of a table a CSV has; None where there is to be none."""
    return table.selected(columns) if table is not None and csv_wanted(table.rows, csv) else None


def _mismatch(data: bytes, expected: Seal) -> str | None:
    """Return how a data file differs from what was written, None if it does not."""
    if len(data) != expected.size:
        return f"has {len(data)} bytes, expected {expected.size}: truncated or changed"
    found = manifest.seal(data).sha256
    if found != expected.sha256:
        return f"SHA-256 is {found[:12]}..., expected {expected.sha256[:12]}...: changed"
    return None


def _change(old: Provenance, new: Provenance) -> str:
    """Say what makes a stored result stale."""
    if old.program != new.program:
        return f"made by version {old.program}, this is {new.program}"
    if old.settings != plain_table(new.settings, "settings"):
        return "settings changed"
    changed = [name for name, value in new.upstream.items() if old.upstream.get(name) != value]
    return f"{', '.join(changed)} changed" if changed else "inputs changed"
