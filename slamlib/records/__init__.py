"""What goes into the filter (inputs), and what comes out (snapshots): frozen, arrays only, no family of landmarks."""
