"""Variables of a study, and the distributions of their values."""
