"""The methods of the extras stages, each studied beside a better reference."""
