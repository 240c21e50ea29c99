"""Parts of the page of a line at rest."""
