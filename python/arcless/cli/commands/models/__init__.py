"""Commands on model files: shipped models, own models, checks, line tables."""
