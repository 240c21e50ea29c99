"""Output of a command: files in its folder, numbers on the screen."""
