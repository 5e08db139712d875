"""What simulator and filter are made of, as plain data: robots and sensors (rig), and builders of them."""
