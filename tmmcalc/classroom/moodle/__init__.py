"""Classes as questions of Moodle, in its XML: see ``elements`` for the format."""
