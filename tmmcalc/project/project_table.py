"""``[project]``: what the work is called."""

from pydantic import Field

from tmmcalc.spec.table import Table


class ProjectTable(Table):
    """Title of the project."""

    title: str = Field(default="", description="Title that heads the tables and the calculation note.")
