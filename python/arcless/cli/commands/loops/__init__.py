"""Commands for lines that are stepped from outside."""
