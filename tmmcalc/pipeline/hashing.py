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
from collections.abc import Callable, Iterable, Mapping
from enum import Enum
from fractions import Fraction
from functools import cache
from typing import TYPE_CHECKING, Any

from tmmcalc._version import __version__
from tmmcalc.core.records import names_of

if TYPE_CHECKING:
    from tmmcalc.core.stage import Stage

Writer = Callable[[Any], bytes]

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


def _encoded(value: Any) -> bytes:
    return _writer(value.__class__)(value)


@cache
def _writer(kind: Any) -> Writer:
    """What encodes the values of a type; a project has thousands of values of a few types."""
    for base, writer in _WRITERS.items():
        if issubclass(kind, base):
            return writer
    names = names_of(kind)
    return _numpy if names is None else _record(kind, names)


def _record(kind: type, names: Iterable[str]) -> Writer:
    head, fields = _encoded(kind.__qualname__), [(_encoded(name), name) for name in names]

    def written(value: object) -> bytes:
        parts = [head]
        for key, name in fields:
            parts += key, _encoded(getattr(value, name))
        return _group(b"d", parts)

    return written


def _numpy(value: Any) -> bytes:
    """Encode an array by type, shape and bytes, a numpy scalar as the Python number."""
    numpy = sys.modules.get("numpy")
    if numpy is not None and isinstance(value, numpy.ndarray) and not value.dtype.hasobject:
        data = value.tobytes(order="C")
        return _group(b"a", (_encoded(value.dtype.str), _encoded(value.shape), _sized(b"b", data)))
    if numpy is not None and isinstance(value, (numpy.number, numpy.bool_)):
        number = value.item()
        if not isinstance(number, numpy.generic):  # as of extended precision it is
            return _encoded(number)
    raise TypeError(f"{type(value).__qualname__} is not a plain value: it cannot be hashed")


def _group(tag: bytes, parts: Iterable[bytes]) -> bytes:
    return _sized(tag, b"".join(parts))


def _sized(tag: bytes, data: bytes) -> bytes:
    return b"%b%d:%b" % (tag, len(data), data)


# by the first base that a type has; float.__repr__ because a numpy float, also a float, prints otherwise
_WRITERS: Mapping[type, Writer] = {
    Enum: lambda value: _group(b"e", (_encoded(type(value).__qualname__), _encoded(value.name))),
    type(None): lambda value: _sized(b"n", b"None"),
    bool: lambda value: _sized(b"n", repr(value).encode()),
    int: lambda value: _sized(b"i", int.__repr__(value).encode()),
    float: lambda value: _sized(b"f", float.__repr__(value).encode()),
    complex: lambda value: _group(b"c", (_encoded(value.real), _encoded(value.imag))),
    bytes: lambda value: _sized(b"b", value),
    str: lambda value: _sized(b"s", value.encode()),
    tuple: lambda value: _group(b"t", map(_encoded, value)),
    list: lambda value: _group(b"t", map(_encoded, value)),
    set: lambda value: _group(b"u", sorted(map(_encoded, value))),
    frozenset: lambda value: _group(b"u", sorted(map(_encoded, value))),
    Mapping: lambda value: _group(b"m", (_encoded(part) for item in value.items() for part in item)),
    Fraction: lambda value: _group(b"q", (_encoded(value.numerator), _encoded(value.denominator))),
}
