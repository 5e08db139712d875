"""Tools that build and check the book; run from the top of the repository by make."""
