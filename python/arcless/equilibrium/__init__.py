"""The line at rest, and why it may have no shape."""
