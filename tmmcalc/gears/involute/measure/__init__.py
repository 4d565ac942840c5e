"""What is measured on a wheel: thickness and chords, span over teeth, size over balls or pins; angles as printed."""
