"""Results that follow from all rows of a study together."""
