"""What follows from all rows of a study together."""
