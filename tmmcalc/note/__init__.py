"""The explanatory note: what the rooms say, numbered, worked out, checked and written."""
