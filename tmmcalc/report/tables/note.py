"""``[note]``: the explanatory note that is handed in, and what stands on its title page."""

from typing import Annotated

from pydantic import Field

from tmmcalc.report.language import LANGUAGES
from tmmcalc.report.printing import DEPTHS, FRAMES
from tmmcalc.spec.choices import Known, OneOrMore
from tmmcalc.spec.identifiers import Label
from tmmcalc.spec.table import Table

Depth = Annotated[str, Known("depth of a note", DEPTHS)]
Frame = Annotated[str, Known("frame of a note", FRAMES)]
Language = Annotated[str, Known("language of notes", tuple(LANGUAGES))]
Positions = Annotated[list[str], OneOrMore(Label())]


class AuthorTable(Table):
    """What stands on the title page beside the title of the project; what is left out is not there."""

    organisation: list[str] = Field(
        default=[], description="Who the work is handed in to, a line each: ministry, university, department."
    )
    work: str = Field(default="", description="What the work is (default: to the course project).")
    course: str = Field(default="", description="Of what course (default: theory of mechanisms and machines).")
    designation: str = Field(default="", description="Designation of the note.")
    done_by: str = Field(default="", description="Who did the work.")
    group: str = Field(default="", description="The group of students.")
    checked_by: str = Field(default="", description="Who checked it.")
    place: str = Field(default="", description="The town.")
    year: str = Field(default="", description="The year, as it is to be written.")


class NoteTable(Table):
    """The explanatory note that is handed in."""

    positions: Positions = Field(
        default=[],
        description="Positions that are worked out (default: one of the working and one of the idle stroke).",
    )
    chapters: list[str] = Field(default=[], description="Chapters by name (default: all that the scene has).")
    depth: Depth = Field(
        default="full",
        description='`"full"`; `"short"`: each formula with the numbers of one position; '
        '`"answers"`: tables of results, no formulas.',
    )
    frame: Frame = Field(default="none", description='`"gost"`: frame of GOST 2.104, forms 2 and 2a; or `"none"`.')
    language: Language | None = Field(default=None, description='`"en"` or `"uk"` (default: that of `[sheets]`).')
    texts: str = Field(default="note", description="Folder beside the spec with texts of your own.")
    units: list[str] = Field(
        default=[],
        description="Units in which results are told as well, and in which tables have them, such as `mm` and `MPa`.",
    )
    who: AuthorTable = Field(default=AuthorTable(), description="The title page.")
