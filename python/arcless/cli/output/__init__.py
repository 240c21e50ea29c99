"""What a command leaves: files in its folder, numbers on the screen."""
