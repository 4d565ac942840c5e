"""The stages of the feasibility room, one module each."""
