"""The chain rule, written once: sensors on robots observe points and lines."""
