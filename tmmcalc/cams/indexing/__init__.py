"""Cam-lantern indexing mechanisms: two paired cams that turn a wheel of rollers step by step."""

from tmmcalc.cams.indexing.results import Indexing
from tmmcalc.cams.indexing.solve import solve_indexing

__all__ = ["Indexing", "solve_indexing"]
