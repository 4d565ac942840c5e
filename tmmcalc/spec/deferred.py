"""Tables whose classes are built only when a spec has them.

pydantic takes half a millisecond for each table class and its validator, and most specs have few of the tables. In
the root a deferred table is a plain function; it imports the table's module when the first value comes.
"""

from __future__ import annotations

from functools import cached_property
from importlib import import_module
from typing import TYPE_CHECKING, Annotated, Any

from pydantic_core import core_schema

if TYPE_CHECKING:
    from pydantic import GetCoreSchemaHandler, GetJsonSchemaHandler

    from tmmcalc.spec.table import Table


class DeferredTable:
    """An annotation that stands for the table class ``name`` of ``module``."""

    def __init__(self, module: str, name: str) -> None:
        self.module = module
        self.name = name

    @cached_property
    def table(self) -> type[Table]:
        """The table class."""
        found: type[Table] = getattr(import_module(self.module), self.name)
        return found

    def read(self, value: object) -> Table:
        """Return the validated table; pydantic takes the places of its faults over."""
        return self.table.model_validate(value)

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> core_schema.CoreSchema:
        return core_schema.no_info_plain_validator_function(self.read)

    def __get_pydantic_json_schema__(
        self, schema: core_schema.CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        self.table.model_rebuild()
        return handler(self.table.__pydantic_core_schema__)


def deferred(module: str, name: str) -> Any:
    """Return the annotation of a deferred table."""
    return Annotated[Any, DeferredTable(module, name)]
