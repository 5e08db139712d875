"""What goes into the filter (records), what comes out (snapshots), and what it is built of (setup)."""
