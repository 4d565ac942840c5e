"""The methods of the machine stages, each studied beside a better reference."""
