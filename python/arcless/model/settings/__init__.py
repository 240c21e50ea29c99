"""How a run moves, steps and records, and what is assessed of it."""
