"""The class: variants of one assignment, their keys, and what was wrong in the answers."""
