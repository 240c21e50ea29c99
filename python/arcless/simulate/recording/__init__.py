"""Arrays of the core → variables of the result."""
