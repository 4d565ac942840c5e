"""The pictures of the linkage stages."""
