"""What the strength and the working of a cam ask: named margins of roller, shaft, stem, guide, pin and contact."""
