"""A run laid out and stepped: its forces, its state, its failures."""
