"""Exact derivatives of the linkage's results with respect to its inputs."""
