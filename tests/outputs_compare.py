"""Compares two recordings of ``outputs.py``: what is the same, what differs in hashes, in numbers, in words."""

from __future__ import annotations

import difflib
import io
import re
import sqlite3
import zlib
from collections import Counter
from pathlib import Path

import numpy as np

Output = dict[str, bytes]  # exit, stdout, stderr, files (their names), and the contents of files by their name
KINDS = ("the same", "other provenance", "other numbers", "other text")  # from the least to the greatest difference
HASH = re.compile(r"\b[0-9a-f]{64}\b")
NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
BLANK = re.compile(r" +|-{2,}")


def compare(old: Path, new: Path, lines: int) -> int:
    """Print what differs between two recordings; return 0 if nothing does, otherwise 1."""
    one, two = _outputs(old), _outputs(new)
    kinds = Counter[str]()
    for folder, own, other in ((old, one, two), (new, two, one)):
        for command in own.keys() - other.keys():
            print(f"only in {folder}: {command}")
            kinds["only in one"] += 1
    for command in (command for command in one if command in two):
        worst, told = "the same", []
        for name in dict.fromkeys([*one[command], *two[command]]):
            kind, words = difference(name, one[command].get(name), two[command].get(name), lines)
            worst = max(worst, kind, key=KINDS.index)
            told += [f"    {name}: {words[0]}", *(f"        {line}" for line in words[1:])] if words else []
        kinds[worst] += 1
        if told:
            print(command, *told, sep="\n")
    print(", ".join(f"{kind}: {kinds[kind]}" for kind in (*KINDS, "only in one")))
    return 0 if kinds.keys() <= {"the same"} else 1


def _outputs(folder: Path) -> dict[str, Output]:
    """All outputs by command, in the order in which they were recorded; decompressed where they are used."""
    found: dict[str, Output] = {}
    with sqlite3.connect(folder / "outputs.sqlite") as store:
        for command, name, data in store.execute("select command, name, data from outputs order by rowid"):
            found.setdefault(command, {})[name] = data
    return found


def difference(name: str, old: bytes | None, new: bytes | None, lines: int) -> tuple[str, list[str]]:
    """Return the kind of the difference between two compressed outputs and some lines that tell it."""
    if old == new:
        return "the same", []
    if old is None or new is None:
        return "other text", ["is new" if old is None else "is no longer written"]
    old, new = zlib.decompress(old), zlib.decompress(new)
    if name.endswith(".npz"):
        return _arrays(old, new, lines)
    one, two = text_of(old), text_of(new)
    if one is None or two is None:
        return "other text", [f"{len(old)} and {len(new)} bytes differ"]
    one, two = HASH.sub("<hash>", one), HASH.sub("<hash>", two)
    if one == two:
        return "other provenance", []
    skeletons = [BLANK.sub(" ", NUMBER.sub("0", text)) for text in (one, two)]
    if skeletons[0] == skeletons[1]:
        pairs = [pair for pair in zip(NUMBER.findall(one), NUMBER.findall(two), strict=True) if pair[0] != pair[1]]
        if not pairs:
            return "other text", ["blanks differ"]
        off = [abs(float(a) - float(b)) / (max(abs(float(a)), abs(float(b))) or 1.0) for a, b in pairs]
        worst = off.index(max(off))
        first, second = pairs[worst]
        return "other numbers", [f"{len(pairs)} numbers differ, by {off[worst]:.1e} at most: {first} -> {second}"]
    changes = difflib.unified_diff(one.splitlines(), two.splitlines(), "", "", n=0, lineterm="")
    changed = [line[:160] for line in changes if not line.startswith(("---", "+++", "@@"))]
    return "other text", [f"{len(changed)} lines differ", *changed[:lines]]


def _arrays(old: bytes, new: bytes, lines: int) -> tuple[str, list[str]]:
    """Compare two npz files: of every array the largest difference relative to its largest magnitude."""
    one, two = np.load(io.BytesIO(old)), np.load(io.BytesIO(new))
    kind, told = "other provenance", [f"{name}: only in one" for name in sorted(set(one.files) ^ set(two.files))]
    for name in (name for name in one.files if name in two.files):
        a, b = one[name], two[name]
        if a.shape != b.shape or a.dtype != b.dtype:
            told.append(f"{name}: {a.dtype} {a.shape} -> {b.dtype} {b.shape}")
        elif a.tobytes() != b.tobytes():
            count = np.count_nonzero(a != b)
            if a.dtype.kind in "US":
                told.append(f"{name}: {count} of {a.size} texts differ")
                continue
            kind = "other numbers"
            off = np.nanmax(np.abs(a.astype(complex) - b)) / (np.nanmax(np.abs(a)) or 1.0)
            told.append(f"{name}: {count} of {a.size} numbers differ, by {off:.1e} of the largest at most")
    if any("numbers differ" not in line for line in told):
        kind = "other text"
    return kind, [f"{len(told)} arrays differ", *told[:lines]] if told else []


def text_of(data: bytes) -> str | None:
    try:
        return data.decode()
    except UnicodeDecodeError:
        return None
