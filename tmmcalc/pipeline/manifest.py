"""OUT/<stage>.toml: what a person reads about a stage, and what vouches for its files.

[provenance]  program version, hash of the inputs, hashes of the stages it needs
[settings]    options of the method
[result]      scalars
[error]       error estimate
[counters]    steps, iterations, evaluations
[table]       rows of the table; the columns that the csv was asked to have, if not all
[files.*]     size and SHA-256 of the npz and of the csv
[digest]      SHA-256 of everything above, in the last line
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import asdict
from typing import Any

from tmmcalc.core.plain import plain_table
from tmmcalc.core.records import record
from tmmcalc.core.stored import Record

_HEAD = "# Written by tmmcalc. A change by hand is noticed, and the stage is computed again.\n\n"
DATA = ("npz", "csv")  # the files that a manifest vouches for, by extension
_DIGEST = b'\n[digest]\nsha256 = "'
_END = b'"\n'


class ManifestError(Exception):
    """The file is not what the program wrote; the text says what was expected."""


@record
class Provenance:
    """What a result depends on; ``hash`` covers all of it and the inputs."""

    stage: str
    program: str  # version
    hash: str
    upstream: Mapping[str, str]  # hash of each stage that it needs
    settings: Mapping[str, Any]


@record
class Seal:
    """Size [bytes] and SHA-256 of a data file."""

    size: int
    sha256: str


@record
class Manifest:
    """The content of OUT/<stage>.toml."""

    provenance: Provenance
    record: Record  # without its arrays
    files: Mapping[str, Seal]  # by extension: "npz", "csv"
    rows: int | None  # of the table; None: the stage has none
    columns: tuple[str, ...] = ()  # names and wildcards of the columns of the csv; empty: all


def seal(data: bytes) -> Seal:
    """Return size and SHA-256 of the content of a file."""
    return Seal(len(data), hashlib.sha256(data).hexdigest())


def written(manifest: Manifest) -> bytes:
    """Return the manifest as TOML, its digest in the last line."""
    import tomli_w

    body = (_HEAD + tomli_w.dumps(_tables(manifest))).encode()
    return body + _DIGEST + hashlib.sha256(body).hexdigest().encode() + _END


def read(data: bytes) -> Manifest:
    """Return the manifest that :func:`written` made; raises ManifestError if it is not that any more."""
    body, mark, tail = data.rpartition(_DIGEST)
    if not mark or not tail.endswith(_END):
        raise ManifestError("the digest in the last line is missing: the file is truncated or was edited")
    expected, found = tail[: -len(_END)].decode(errors="replace"), hashlib.sha256(body).hexdigest()
    if expected != found:
        raise ManifestError(f"SHA-256 is {found[:12]}..., expected {expected[:12]}...: edited by hand")
    try:
        return _manifest(body.decode())
    except (ValueError, AttributeError, TypeError) as error:  # the digest is right: somebody has made it
        raise ManifestError(f"it is no record of a stage ({error})") from None


def _tables(manifest: Manifest) -> dict[str, Any]:
    origin, record = manifest.provenance, manifest.record
    provenance = {"stage": origin.stage, "program": origin.program, "hash": origin.hash}
    tables: dict[str, Any] = {
        "provenance": {**provenance, "upstream": dict(origin.upstream)},
        "settings": plain_table(origin.settings, "settings"),
        "result": record.scalars,
        "error": record.error,
        "counters": record.counters,
        "files": {kind: asdict(value) for kind, value in manifest.files.items()},
    }
    if manifest.rows is not None:
        tables["table"] = {"rows": manifest.rows} | ({"columns": list(manifest.columns)} if manifest.columns else {})
    return {name: table for name, table in tables.items() if table}


def _check(name: str, value: Any, *kinds: type) -> Any:
    """The value; raises TypeError if it is of none of the kinds."""
    if not isinstance(value, kinds):
        raise TypeError(f"{name} is of another type")
    return value


def _sealed(kind: str, value: Any) -> Seal:
    if kind not in DATA:
        raise ValueError(f"no file of a stage ends in .{kind}")
    return Seal(_check("size", value.get("size", 0), int), _check("sha256", value.get("sha256", ""), str))


def _manifest(text: str) -> Manifest:
    """Read a text whose digest is right; a field that another version of the program lacks reads as empty."""
    import tomllib

    tables = tomllib.loads(text)
    for name, table in tables.items():
        _check(name, table, dict)
    origin = tables.get("provenance", {})
    return Manifest(
        Provenance(
            stage=_check("stage", origin.get("stage", ""), str),
            program=_check("program", origin.get("program", ""), str),
            hash=_check("hash", origin.get("hash", ""), str),
            upstream=_check("upstream", origin.get("upstream", {}), dict),
            settings=tables.get("settings", {}),
        ),
        Record(
            scalars=tables.get("result", {}),
            error=tables.get("error", {}),
            counters=tables.get("counters", {}),
        ),
        {kind: _sealed(kind, value) for kind, value in tables.get("files", {}).items()},
        _check("rows", tables.get("table", {}).get("rows"), int, type(None)),
        tuple(tables.get("table", {}).get("columns", ())),
    )
