"""How a line differs from its design: as built, and in the weather."""
