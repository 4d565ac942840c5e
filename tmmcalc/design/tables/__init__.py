"""Tables of the spec of what is asked of a design, and the standards that they name."""
