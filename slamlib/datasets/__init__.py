"""Image sequences and calibrations as files hold them: public layouts, folders, videos, pairs."""
