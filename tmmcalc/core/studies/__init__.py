"""What a study of accuracy is made of: methods at their settings, a reference, errors and times."""
