"""Tables of the mesh: rows for the core, and the names behind them."""
