"""Generated code: made by `make generate` from the models of the package, never edited by hand."""
