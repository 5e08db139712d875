/* A pin-hole camera from the side: the row at which it sees a point, by similar triangles.

   State: point [depth, y], y downwards; focal, the depth of the image plane, drawn as large as the world; half, half the
   height of the image on that plane; rows, its height in pixels; ends, how far to the right, up and down lines are drawn. */
Drag.add("camera", (() => {
  /** The row of a point, with the focal length and the middle in pixels. */
  const row = (y, z, alpha, v0) => v0 + alpha * y / z;
  /** Half of the view, in degrees. */
  const view = (focal, half) => Math.atan2(half, focal) * 180 / Math.PI;
  const within = (value, least, most) => Math.min(Math.max(value, least), most);

  return {
    formulas: { row, view },
    handles: {
      point: {
        label: "point",
        at: (state) => state.point,
        moved: (state, [z, y]) => ({ ...state, point: [Math.max(z, 0.4), y] }),
      },
      plane: {
        label: "focal length",
        along: "x",
        at: ({ focal, half }) => [focal, half],
        moved: (state, [z]) => ({ ...state, focal: within(z, 0.5, 4) }),
      },
    },
    parts({ point: [z, y], focal, half, ends: [right, down] }) {
      const through = (slope) => {
        const to = Math.min(right, down / Math.abs(slope));
        return [[0, 0], [to, to * slope]];
      };
      return {
        "upper edge": through(-half / focal), "lower edge": through(half / focal), ray: through(y / z),
        plane: [[focal, -half], [focal, half]], image: [[focal, 0], [focal, within(focal * y / z, -down, down)]], height: [[z, 0], [z, y]],
        point: { at: [z, y] }, "plane words": { at: [focal, 0] }, "height words": { at: [z, y / 2] }, "point words": { at: [z, y] },
      };
    },
    numbers({ point: [z, y], focal, half, rows }) {
      const alpha = focal * rows / 2 / half;
      return { z, y, alpha, v: row(y, z, alpha, rows / 2), angle: view(focal, half) };
    },
  };
})());
