"""Manipulators: arms in a vertical plane with or without a turning base, their direct and inverse problems (2.10.3)."""
