"""What is allowed in a model but deserves a word to the user."""
