"""How a model finds its generated code and runs it: kernels, specialized copies, fingerprints, registries."""
