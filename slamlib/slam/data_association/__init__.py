"""Data association: which landmarks to observe, which matches pass the gates, which are inliers."""
