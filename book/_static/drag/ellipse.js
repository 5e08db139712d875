/* The ellipse of a covariance, held by its axes, and a point whose Mahalanobis distance is told.

   State: mean [x, y]; axis, from the mean to the end of one half-axis, and across, the length of the other [one sigma];
   sigmas, how many are drawn; point [x, y]; least, the shortest half-axis. */
Drag.add("ellipse", (() => {
  /** The eigenvalues of a symmetric matrix [[a, b], [b, c]], greater first, and a unit eigenvector of the greater. */
  function eigen([[a, b], [, c]]) {
    const middle = (a + c) / 2, half = Math.hypot((a - c) / 2, b), turn = Math.atan2(2 * b, a - c) / 2;
    const greater = middle + half; // the other from their product, which loses no digits; of nothing both are zero
    return { values: [greater, greater ? (a * c - b * b) / greater : 0], vector: [Math.cos(turn), Math.sin(turn)] };
  }
  /** The outline of the ellipse of k sigmas. */
  function outline(mean, P, k, count = 73) {
    const { values, vector: [vx, vy] } = eigen(P), [a, b] = values.map((v) => k * Math.sqrt(Math.max(v, 0)));
    return Array.from({ length: count }, (_, i) => {
      const turn = (2 * Math.PI * i) / (count - 1), [u, w] = [a * Math.cos(turn), b * Math.sin(turn)];
      return [mean[0] + vx * u - vy * w, mean[1] + vy * u + vx * w];
    });
  }
  /** The covariance whose ellipse has a half-axis (x, y) and, at right angles to it, one of a length. */
  function covariance([x, y], across) {
    const other = (across * across) / (x * x + y * y);
    const xy = x * y * (1 - other);
    return [[x * x + other * y * y, xy], [xy, y * y + other * x * x]];
  }
  /** The squared Mahalanobis distance of a deviation. */
  function squared([x, y], [[a, b], [, c]]) {
    return (c * x * x - 2 * b * x * y + a * y * y) / (a * c - b * b);
  }

  const from = ({ mean }, [x, y]) => [x - mean[0], y - mean[1]];
  const plus = ({ mean }, [x, y]) => [mean[0] + x, mean[1] + y];
  const least = (state) => state.least ?? 0.05;
  const sigmas = (state) => state.sigmas ?? 1;
  const all = (state) => {
    const P = covariance(state.axis, state.across), length = Math.hypot(...state.axis);
    const side = [-state.axis[1], state.axis[0]].map((v) => (v / length) * state.across);
    return { P, side, length, D: state.point ? Math.sqrt(squared(from(state, state.point), P)) : 0 };
  };
  const times = (k, [x, y]) => [k * x, k * y];
  const end = (state, way) => plus(state, times(sigmas(state), way));

  return {
    formulas: { eigen, outline, covariance, squared },
    handles: {
      axis: {
        label: "end of the first half-axis",
        at: (state) => end(state, state.axis),
        moved(state, point) {
          const way = times(1 / sigmas(state), from(state, point)), length = Math.hypot(...way);
          return length < least(state) ? state : { ...state, axis: way };
        },
      },
      across: {
        label: "end of the second half-axis",
        at: (state) => end(state, all(state).side),
        moved(state, point) {
          const { length } = all(state), [x, y] = from(state, point);
          const across = (state.axis[0] * y - state.axis[1] * x) / length / sigmas(state);
          return { ...state, across: Math.max(across, least(state)) };
        },
      },
      point: {
        label: "the point",
        at: (state) => state.point,
        moved: (state, point) => ({ ...state, point }),
      },
    },
    parts(state) {
      const { P, side, D } = all(state), k = sigmas(state);
      const [sx, sy] = [k * Math.sqrt(P[0][0]), k * Math.sqrt(P[1][1])];
      return {
        ellipse: outline(state.mean, P, k),
        box: [[-sx, -sy], [sx, -sy], [sx, sy], [-sx, sy], [-sx, -sy]].map((corner) => plus(state, corner)),
        "half-axis": [state.mean, end(state, state.axis)],
        "other half-axis": [state.mean, end(state, side)],
        point: { at: state.point },
        contour: outline(state.mean, P, D),
      };
    },
    numbers(state) {
      const { P: [[xx, xy], [, yy]], length, D } = all(state), [sx, sy] = [Math.sqrt(xx), Math.sqrt(yy)];
      return { xx, xy, yy, sx, sy, rho: xy / (sx * sy), first: length, second: state.across, D, D2: D * D };
    },
  };
})());
