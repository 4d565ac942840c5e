"""One hash of everything that the result of a stage depends on.

Values are fed to SHA-256 in a canonical form: a letter for the type, the length, the bytes. So ``1``,
``1.0``, ``"1"`` and ``True`` differ, and no two structures can run into each other.

The order of a dict counts: the points of a link in another order are the same mechanism, but the columns
of its results come in that order, and a stored result must be the one that a fresh run would give.
Only settings, which are options by name, are sorted.
"""

from __future__ import annotations

import hashlib
import sys
from collections.abc import Iterable, Mapping
from enum import Enum
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from tmmcalc._version import __version__
from tmmcalc.core.records import names_of

if TYPE_CHECKING:
    from tmmcalc.core.stage import Stage

FORMAT = 2  # of the stored files: a new layout makes every older file stale


def stage_hash(
    stage: Stage,
    inputs: object,
    settings: Mapping[str, Any],
    upstream: Mapping[str, str],
    version: str = __version__,
) -> str:
    """Return the hash [64 hexadecimal digits] of a stage's inputs, settings, program and upstream hashes.

    Raises TypeError for a value that is not plain.
    """
    options = sorted(settings.items())
    return content_hash(("stage", FORMAT, stage.name, version, inputs, options, sorted(upstream.items())))


def content_hash(value: object) -> str:
    """Return the SHA-256 [64 hexadecimal digits] of a plain value in canonical form.

    Plain are None, bool, int, float, complex, fractions, str, bytes, enum members, tuples, lists, sets, dicts,
    dataclasses and numpy arrays and scalars. Lists count as tuples. Raises TypeError for anything else.
    """
    return hashlib.sha256(_encoded(value)).hexdigest()


def _encoded(value: object) -> bytes:
    if isinstance(value, (str, int, float, complex, bytes, Enum)) or value is None:
        return _atom(value)
    if isinstance(value, (tuple, list)):
        return _group(b"t", (_encoded(item) for item in value))
    if isinstance(value, (set, frozenset)):
        return _group(b"u", sorted(_encoded(item) for item in value))
    if isinstance(value, Mapping):
        return _group(b"m", (_encoded(part) for item in value.items() for part in item))
    if isinstance(value, Fraction):
        return _group(b"q", (_encoded(value.numerator), _encoded(value.denominator)))
    names = names_of(type(value))
    return _numpy(value) if names is None else _dataclass(value, names)


def _atom(value: object) -> bytes:
    """Encode a value without parts; float.__repr__ because a numpy float, also a float, prints otherwise."""
    if isinstance(value, Enum):
        return _group(b"e", (_encoded(type(value).__qualname__), _encoded(value.name)))
    if value is None or isinstance(value, bool):
        return _sized(b"n", repr(value).encode())
    if isinstance(value, int):
        return _sized(b"i", int.__repr__(value).encode())
    if isinstance(value, float):
        return _sized(b"f", float.__repr__(value).encode())
    if isinstance(value, complex):
        return _group(b"c", (_encoded(value.real), _encoded(value.imag)))
    if isinstance(value, bytes):
        return _sized(b"b", value)
    if isinstance(value, str):
        return _sized(b"s", value.encode())
    raise TypeError(f"{type(value).__qualname__} is not a plain value: it cannot be hashed")


def _dataclass(value: Any, names: Iterable[str]) -> bytes:
    parts = [_encoded(type(value).__qualname__)]
    for name in names:
        parts += _encoded(name), _encoded(getattr(value, name))
    return _group(b"d", parts)


def _numpy(value: Any) -> bytes:
    """Encode an array by type, shape and bytes, a numpy scalar as the Python number."""
    numpy = sys.modules.get("numpy")
    if numpy is not None and isinstance(value, numpy.ndarray) and not value.dtype.hasobject:
        data = value.tobytes(order="C")
        return _group(b"a", (_encoded(value.dtype.str), _encoded(value.shape), _sized(b"b", data)))
    scalar = numpy is not None and isinstance(value, (numpy.number, numpy.bool_))
    return _atom(value.item() if scalar else value)


def _group(tag: bytes, parts: Iterable[bytes]) -> bytes:
    return _sized(tag, b"".join(parts))


def _sized(tag: bytes, data: bytes) -> bytes:
    return b"%b%d:%b" % (tag, len(data), data)
