"""All columns by choice of the kinematics table: terms of vector equations, special points, outputs by differences."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache, partial

from tmmcalc.core.columns import Column, column
from tmmcalc.core.plane import Real
from tmmcalc.core.quantity import Quantity
from tmmcalc.linkage.chain import chain_of
from tmmcalc.linkage.columns import units_of
from tmmcalc.linkage.differentiation import differentiate
from tmmcalc.linkage.kinematics import default_step, output_row
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.outputs import default_outputs
from tmmcalc.linkage.relative import relative_columns
from tmmcalc.linkage.results import Kinematics
from tmmcalc.linkage.special import special_columns

DIFFERENCES = (
    Quantity("vS_{output}_differences[{unit}]", "velocity of output {output} by central differences", source="(2.62)"),
    Quantity(
        "aS_{output}_differences[{unit}]", "acceleration of output {output} by central differences", source="(2.63)"
    ),
)


def further_columns(mechanism: Mechanism, result: Kinematics, *, dimensionless: bool = False) -> list[Column]:
    """Columns that are made when they are asked for by name; raises `UsageError` for dimensionless driven sliders."""
    return [
        *relative_columns(mechanism, result, dimensionless=dimensionless),
        *special_columns(mechanism, result, dimensionless=dimensionless),
        *_difference_columns(mechanism, result, dimensionless),
    ]


def _difference_columns(mechanism: Mechanism, result: Kinematics, dimensionless: bool) -> Iterator[Column]:
    """Velocity and acceleration of every output by differences of positions with the textbook's step."""
    units = units_of(result, dimensionless)

    @cache
    def rates(k: int) -> tuple[Real, Real]:
        chain = chain_of(mechanism, result)
        trace = differentiate(chain, result.x, default_step(chain))
        _, *both = output_row(default_outputs(chain)[k], trace)
        velocity, acceleration = result.in_time(*both)
        return velocity, acceleration

    def made(k: int, part: int, factor: float) -> Real:
        return rates(k)[part] * factor

    for k, (name, angular) in enumerate(zip(result.outputs, result.angular, strict=True)):
        both = (units.omega, units.eps) if angular else (units.velocity, units.acceleration)
        for part, (told, (unit, factor)) in enumerate(zip(DIFFERENCES, both, strict=True)):
            yield column(told.of(output=name, unit=unit), partial(made, k, part, factor))
