"""The pressure angle: its formulas and extremes (angle), over the turn (solve), what rounding leaves of it (errors)."""
