"""The methods of the vibration stages, each studied beside a better reference."""
