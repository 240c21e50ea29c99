"""`python -m arcless` is the command `arcless`."""

from arcless.cli import main

if __name__ == "__main__":
    main()
