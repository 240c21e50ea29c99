"""Page of a pantograph that was fitted to a measured receptance."""
