"""Marks for the grade book of a course: a row a student, who it is, the grade, what is said of it.

Moodle takes such a table under Grades, Import, CSV file, and asks which column says who a student is. It knows students
by ID number, user name or e-mail address: a roster of these is imported as it stands.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from tmmcalc.classroom.marking import Marked, Marks
from tmmcalc.classroom.marksheets import hints_of
from tmmcalc.classroom.verdicts import Standing
from tmmcalc.classroom.wording import standing_said
from tmmcalc.core.printable import printable
from tmmcalc.report.language import tr
from tmmcalc.report.worksheets import Worksheet

EMAIL = re.compile(r"\S+@\S+\.\S+")
NUMBER = re.compile(r"[\w-]*\d[\w-]*")


def gradebook(marks: Marks, title: str) -> Worksheet:
    """The marks that count, of the whole class, in the language in force; nothing of the key.

    Who handed in nothing has no grade: the grade book leaves it as it is.
    """
    rows: list[tuple[int, str, float | None, str]] = [
        (each.number, each.student, round(each.total, 6), "; ".join(_feedback(marks, each))) for each in marks.counting
    ]
    rows += [(key.number, key.student, None, tr("Nothing was handed in.")) for key in marks.absent]
    rows.sort(key=lambda row: row[0])
    numbers, students, grades, said = zip(*rows, strict=True)
    who = [student or f"{number:02d}" for number, student in zip(numbers, students, strict=True)]
    headers = (identifier(students), f"{title} (0–{marks.most:g})", f"{title} ({tr('feedback')})")
    return Worksheet("grades", headers, [who, [*grades], [*said]])


def identifier(students: Sequence[str]) -> str:
    """What a roster names students by, in the words of Moodle's own tables.

    >>> identifier(["ada@example.org"]), identifier(["KM-2301", "17"]), identifier(["Ada Lovelace", "17"])
    ('Email address', 'ID number', 'Full name')
    """
    known = [name for name in students if name]
    if known and all(EMAIL.fullmatch(name) for name in known):
        return "Email address"
    return "ID number" if all(NUMBER.fullmatch(name) for name in known) else "Full name"


def _feedback(marks: Marks, each: Marked) -> list[str]:
    told = [
        f"{item.name}: {standing_said(standing)}"
        for item, standing in zip(marks.items, each.standings, strict=True)
        if standing is not Standing.right
    ]
    return [printable(line) for line in (*told, *hints_of(marks.items, marks.mistakes, each))] or [
        tr("All answers are right.")
    ]
