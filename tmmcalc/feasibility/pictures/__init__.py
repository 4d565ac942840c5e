"""The pictures of the feasibility stages."""
