"""The blocking contour: which shifts x1, x2 a pair of wheels may have, and which of them to choose."""
