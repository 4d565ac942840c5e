"""The pictures of the manipulator stages."""
