"""What a title block says of a sheet."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from tmmcalc.report.language import tr

if TYPE_CHECKING:
    from tmmcalc.report.tables.sheets import WhoTable


class Titles(NamedTuple):
    """Its words; ``who`` are those that the spec gives."""

    title: str  # of the project
    name: str  # of the sheet
    number: int
    total: int  # of all sheets
    format: str
    who: WhoTable

    @property
    def designation(self) -> str:
        """Of this sheet."""
        return self.who.designation.replace("{sheet}", str(self.number))


def name_of(sheet: str) -> str:
    """What a sheet is called in the language in force."""
    names = {
        "linkage": tr("Kinematics of the linkage"),
        "forces": tr("Forces and motion"),
        "gears": tr("Gears"),
        "cam": tr("Cam mechanism"),
    }
    return names[sheet]
