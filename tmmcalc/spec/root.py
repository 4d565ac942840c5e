"""The root of the spec: the tables of one project."""

from pydantic import Field

from .mechanism import MechanismTable
from .project import ProjectTable
from .table import Table


class Spec(Table):
    """A project spec of tmmcalc: one TOML file that holds the whole task."""

    project: ProjectTable = Field(default_factory=ProjectTable, description="What the work is called.")
    mechanism: MechanismTable = Field(description="The linkage.")
