"""Commands on model files: what is shipped, models of one's own, checks, line tables."""
