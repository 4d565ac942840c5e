"""The methods of the gear stages, each studied beside a better reference."""
