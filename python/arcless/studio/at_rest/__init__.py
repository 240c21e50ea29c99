"""The line at rest as plain data: what the page draws, and what it shows as numbers."""
