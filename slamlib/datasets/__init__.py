"""Image sequences and calibrations from files: public layouts, folders, videos, pairs."""
