"""The algebra of the Kalman filter on blocks: state, measurement update, checked linear algebra."""
