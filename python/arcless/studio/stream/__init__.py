"""The stream: one WebSocket a page, for messages and for frames of motion."""
