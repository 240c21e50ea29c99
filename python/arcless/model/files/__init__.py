"""Text of model files: read with line and column, changed in place, and told what is wrong."""
