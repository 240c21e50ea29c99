"""The folder that the studio works on: its files, and changes of them."""
