"""Balancing of a linkage on its foundation: shaking force and moment, counterweights, redistributed masses."""
