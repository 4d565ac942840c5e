"""A wheel by itself, without a mate: its circles, its limits, what is measured on it, its profile."""
