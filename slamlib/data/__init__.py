"""The filter's inputs (records), outputs (snapshots), and setup (rig of robots and sensors)."""
