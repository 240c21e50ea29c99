"""Numbers, tables and objects as a reader sees them in pages and notebooks."""
