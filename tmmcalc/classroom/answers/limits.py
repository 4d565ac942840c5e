"""How large what is handed in may be, and the fault of a file."""

from __future__ import annotations

BYTES = 5_000_000  # of a file
UNZIPPED = 30_000_000  # bytes of a workbook
TAGS = 1_500_000  # of the XML of a part
PARTS = 2_000  # files within a workbook
ROWS, COLUMNS = 20_000, 300
CELLS = 200_000  # filled ones of a file
WIDEST = 2_000  # characters of a cell
FILES = 5_000
DEEPEST = 4  # folders within each other


class UnreadableError(Exception):
    """What is wrong with a file, after its name, and what to do about it."""

    def __init__(self, message: str, remedy: str = "") -> None:
        self.message, self.remedy = message, remedy
        super().__init__(message)
