"""How a model finds its generated code and runs it: kernels, code in memory, fingerprints, registries."""
