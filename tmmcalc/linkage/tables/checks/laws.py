"""Checks of the laws of ``[[loads]]``, beyond that each load has one."""

from __future__ import annotations

from tmmcalc.linkage.tables.checks.loads import check_by_law

CHECKS = (check_by_law,)
