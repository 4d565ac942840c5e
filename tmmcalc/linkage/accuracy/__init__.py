"""The methods of the linkage stages, each studied beside a better reference."""
