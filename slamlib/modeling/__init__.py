"""Running a model's generated code: kernels, code in memory, fingerprints, registries."""
