"""FMUs that stand in model files: their description, and how a model names their variables."""
