"""`python -m pieper` is the same as `pieper`."""

from pieper.cli import main

if __name__ == "__main__":
    main()
