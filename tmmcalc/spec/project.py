"""``[project]``: what the work is called."""

from pydantic import Field

from tmmcalc.spec.table import Table


class ProjectTable(Table):
    """Title of the project."""

    title: str = Field(default="", description="Title that heads the tables and the calculation note.")


class Titled:
    """The table of the root that belongs to no room, as the tables of rooms see it."""

    project: ProjectTable
