"""Formulas of one or several variables, read without running them as a program."""

from tmmcalc.core.expression.formula import Field, Formula, parse, parse_field

__all__ = ["Field", "Formula", "parse", "parse_field"]
