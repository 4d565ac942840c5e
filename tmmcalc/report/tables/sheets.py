"""``[sheets]``: the drawings that are handed in, and who stands in their title blocks."""

from typing import Annotated

from pydantic import Field

from tmmcalc.report.language import LANGUAGES
from tmmcalc.report.sheets.formats import FORMATS, FRAMES
from tmmcalc.spec.choices import Known, OneOrMore
from tmmcalc.spec.identifiers import Label
from tmmcalc.spec.table import Table

FormatName = Annotated[str, Known("format of a sheet", tuple(FORMATS))]
FrameName = Annotated[str, Known("frame of a sheet", FRAMES)]
Positions = Annotated[list[str], OneOrMore(Label())]
Language = Annotated[str, Known("language of drawings", tuple(LANGUAGES))]


class WhoTable(Table):
    """What stands in the title block beside the title of the project; what is left out stays empty."""

    designation: str = Field(
        default="", description="Designation of the drawing; `{sheet}` in it becomes the number of the sheet."
    )
    drawn_by: str = Field(default="", description="Who made the drawing.")
    checked_by: str = Field(default="", description="Who checked it.")
    technical_control: str = Field(default="", description="Who checked that it can be made (`gost` alone).")
    standards_control: str = Field(default="", description="Who checked that it keeps the standards (`gost` alone).")
    approved_by: str = Field(default="", description="Who approved it.")
    organisation: str = Field(default="", description="The department, the group.")
    date: str = Field(default="", description="Date, as it is to be written.")
    letter: str = Field(default="", description="Letter of the stage of design (`gost` alone).")
    material: str = Field(default="", description="Material (`gost` alone).")


class SheetsTable(Table):
    """The drawings that are handed in."""

    positions: Positions = Field(
        default=[],
        description="Positions of the plans; the first is that of the forces (default: chosen by the program).",
    )
    diagrams: list[str] = Field(
        default=[],
        description="Columns of the diagrams by name, with wildcards (default: chosen by the program).",
    )
    format: FormatName = Field(default="a1", description='Format of the paper: `"a1"`, `"a2"` or `"a3"`.')
    frame: FrameName | None = Field(
        default=None,
        description='Frame and title block: `"gost"` (GOST 2.104, form 1), `"iso"` (ISO 5457, ISO 7200) or `"none"` '
        '(default: `"gost"` in Ukrainian, else `"iso"`).',
    )
    language: Language = Field(default="en", description='Language: `"en"` or `"uk"`.')
    who: WhoTable = Field(default=WhoTable(), description="The title block.")
