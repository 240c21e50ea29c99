"""What the core returns → variables of the result."""
