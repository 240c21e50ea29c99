"""The server: its routes put together, who may ask, what the page is."""
