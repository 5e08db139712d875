"""Is an estimate consistent, and how far is it off: NEES, NIS and their bands; trajectories, aligned and compared."""
