"""The methods of the cam stages, each studied beside a better reference."""
