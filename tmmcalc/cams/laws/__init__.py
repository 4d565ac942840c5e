"""Laws of motion of a follower: the catalogue, and laws of the user's own."""
