/* Two cameras side by side, from above, and a landmark: the two rays, the disparity, and what a pixel leaves open.

   State: point [x, z] and base [m]; focal [px]; half a pixel [px]; plane, where the image planes are drawn [m]; far, where
   rays end [m]; sigmas, how many the ellipse has. The figure's axes are z (ahead) and x (to the right). */
Drag.add("stereo", (() => {
  /** The columns (left, right) of a point, from the principal point. */
  const columns = ([x, z], focal, base) => [focal * x / z, focal * (x - base) / z];
  /** The point of two columns. */
  function triangulate([left, right], focal, base) {
    const z = focal * base / (left - right);
    return [left * z / focal, z];
  }
  /** First-order covariance of (x, z) [m^2], for independent columns of one standard deviation [px]. */
  function covariance([x, z], focal, base, sigma) {
    const byLeft = [z / focal * (1 - x / base), -z * z / (focal * base)], byRight = [z / focal * x / base, z * z / (focal * base)];
    const entry = (i, j) => sigma * sigma * (byLeft[i] * byLeft[j] + byRight[i] * byRight[j]);
    return [[entry(0, 0), entry(0, 1)], [entry(0, 1), entry(1, 1)]];
  }
  /** The corners of what is seen within half a pixel in both images: left, near, right, far. */
  function diamond(point, focal, base, half) {
    const [left, right] = columns(point, focal, base);
    return [[-half, -half], [half, -half], [half, half], [-half, half]].map(
      ([a, b]) => triangulate([left + a, right + b], focal, base));
  }

  const shown = ([x, z]) => [z, x];
  const least = ({ half, far, focal }) => 2 * half * far / focal; // a pixel of disparity where rays end
  function wedge(from, column, { focal, half, far }) {
    const end = (side) => [far, from + far * (column + side * half) / focal];
    return [end(-1), [0, from], end(1)];
  }

  return {
    uses: ["ellipse"],
    formulas: { columns, triangulate, covariance, diamond },
    handles: {
      point: {
        label: "the landmark",
        at: ({ point }) => shown(point),
        moved: (state, [z, x]) => ({ ...state, point: [x, Math.min(Math.max(z, 2 * state.plane), state.far - 1)] }),
      },
      base: {
        label: "the right camera: the baseline",
        along: "y",
        at: ({ base }) => [0, base],
        value: ({ base }) => base,
        moved: (state, [, y]) => ({ ...state, base: Math.max(y, least(state)) }),
      },
    },
    parts(state) {
      const { point, focal, base, half, plane } = state, [left, right] = columns(point, focal, base);
      const [[xx, xz], [, zz]] = covariance(point, focal, base, half / Math.sqrt(3));
      const corners = diamond(point, focal, base, half).map(shown), at = (column, x = 0) => [plane, x + plane * column / focal];
      return {
        left: wedge(0, left, state),
        right: wedge(base, right, state),
        parallel: [[0, 0], [2 * plane, 2 * plane * right / focal]],
        disparity: [at(right), at(left)],
        "right plane": [[plane, base - 0.5], [plane, base + 0.5]],
        "right words": { at: [0, base] },
        d: { at: at(right) },
        diamond: [...corners, corners[0]],
        ellipse: Drag.kinds.ellipse.formulas.outline(shown(point), [[zz, xz], [xz, xx]], state.sigmas),
        point: { at: shown(point) },
      };
    },
    numbers({ point, focal, base, half }) {
      const [left, right] = columns(point, focal, base), [, [, zz]] = covariance(point, focal, base, half / Math.sqrt(3));
      return { z: point[1], b: base, d: left - right, sigma: Math.sqrt(zz) };
    },
  };
})());
