"""The students of a class: the file that names them, and who has which variant."""

from __future__ import annotations

import unicodedata
from collections import Counter
from collections.abc import Sequence
from pathlib import Path

from tmmcalc.core.errors import Fault, SpecError
from tmmcalc.core.printable import hidden
from tmmcalc.project.loader import read_text

MOST = 1000  # students of a class
MOST_BYTES = 200_000
LONGEST = 80  # characters of a name
IN_FILES = 40  # of those in the name of a file
REMEDY = "write a name or a number a line"
APOSTROPHES = "'’ʼ`´"


def roster_of(path: Path) -> tuple[str, ...]:
    """The students that a file names, one a line; lines without a name count for nothing.

    Raises UsageError for what is no such file, SpecError with all lines that are no names, or for too many.
    """
    names, faults = list[str](), list[Fault]()
    for number, line in enumerate(read_text(path, MOST_BYTES).splitlines(), 1):
        name = " ".join(unicodedata.normalize("NFC", line).split())
        if not name:
            continue
        if len(name) > LONGEST or hidden(name):
            what = f"is longer than {LONGEST} characters" if len(name) > LONGEST else "has hidden characters"
            faults.append(Fault("", number, f"the name {what}", REMEDY))
        names.append(name)
    if not names:
        faults.append(Fault("", None, "no student is named", REMEDY))
    if len(names) > MOST:
        faults.append(Fault("", None, f"{len(names)} students are more than {MOST}", "make several classes"))
    if faults:
        raise SpecError(str(path), faults)
    return tuple(names)


def newcomers(roster: Sequence[str], known: Sequence[str]) -> tuple[str, ...]:
    """The students of a roster who have no variant yet, in its order; of one name the first ones are those known.

    >>> newcomers(["Ada", "Ivan", "Ada", "Olha"], ["Ada", "Petro"])
    ('Ivan', 'Ada', 'Olha')
    """
    left, fresh = Counter(known), []
    for name in roster:
        if left[name] > 0:
            left[name] -= 1
        else:
            fresh.append(name)
    return tuple(fresh)


def stem(number: int, student: str) -> str:
    """How the files of a variant are called: its number, and what of the name may stand in the name of a file.

    Letters and digits of any alphabet stay; nothing is left that would lead to another folder.

    >>> stem(7, "Лук'яненко Марія"), stem(12, "../etc/passwd"), stem(3, "")
    ('07-Лукяненко_Марія', '12-etc_passwd', '03')
    """
    bare = unicodedata.normalize("NFC", student).translate(dict.fromkeys(map(ord, APOSTROPHES)))
    kept = "".join(sign if unicodedata.category(sign)[0] in "LNM" else " " for sign in bare)
    word = "_".join(kept.split())[:IN_FILES].rstrip("_")
    return f"{number:02d}-{word}" if word else f"{number:02d}"
