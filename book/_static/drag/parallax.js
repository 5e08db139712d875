/* Two images of a point straight ahead of the first camera, the second taken a base line to the left: the angle between
   the rays, and what the noise of the two pixels leaves of the distance d, and of its inverse w.

   State: distance and base [m], focal and noise [px]; edge, where the drawing ends. */
Drag.add("parallax", (() => {
  /** Standard deviation of the inverse distance by the two images alone. */
  const sigma = (base, noise, focal) => Math.SQRT2 * noise / (focal * base);
  const angle = (distance, base) => Math.atan2(base, distance);
  /** Nearest and farthest distance within two standard deviations of w; the farthest may be infinite. */
  function interval(w, deviation) {
    const low = w - 2 * deviation;
    return [1 / (w + 2 * deviation), low > 0 ? 1 / low : Infinity];
  }

  const within = (value, low, high) => Math.min(Math.max(value, low), high);
  const endless = { toFixed: () => "\u221e" };

  return {
    formulas: { sigma, angle, interval: (w, deviation) => interval(w, deviation).map((d) => Number.isFinite(d) ? d : null) },
    handles: {
      point: {
        label: "distance of the point",
        along: "x",
        at: ({ distance }) => [distance, 0],
        value: ({ distance }) => distance,
        moved: (state, [x]) => ({ ...state, distance: within(x, 4, state.edge - 1) }),
      },
      camera: {
        label: "base line of the two cameras",
        along: "y",
        at: ({ base }) => [0, base],
        value: ({ base }) => base,
        moved: (state, [, y]) => ({ ...state, base: within(y, 0.1, 1.4) }),
      },
    },
    parts({ distance, base, focal, noise, edge }) {
      const w = 1 / distance, deviation = sigma(base, noise, focal), [near, far] = interval(w, deviation);
      const end = Math.min(far, edge), low = w - 2 * deviation, high = w + 2 * deviation;
      const alpha = angle(distance, base), radius = 0.35 * distance;
      return {
        ray: [[0, 0], [distance, 0]],
        "second ray": [[0, base], [distance, 0]],
        "on the ray": [[near, 0], [end, 0]],
        angle: Array.from({ length: 25 }, (_, i) => {
          const turn = Math.PI - alpha * i / 24;
          return [distance + radius * Math.cos(turn), radius * Math.sin(turn)];
        }),
        "angle words": { at: [distance - radius, -0.25] },
        camera: { at: [0, base] },
        "camera words": { at: [0.6, base + 0.08] },
        point: { at: [distance, 0] },
        near: [[0, high], [near, high], [near, 0]],
        far: far < edge ? [[0, low], [far, low], [far, 0]] : [[0, low], [edge, low], [edge, low]],
        middle: [[0, w], [distance, w], [distance, 0]],
        "in w": [[0, low], [0, high]],
        "in d": [[near, 0], [end, 0]],
      };
    },
    numbers({ distance, base, focal, noise }) {
      const w = 1 / distance, deviation = sigma(base, noise, focal), [near, far] = interval(w, deviation);
      const spread = 2 * deviation, degrees = angle(distance, base) * 180 / Math.PI;
      return { angle: degrees, w, spread, near, far: Number.isFinite(far) ? far : endless };
    },
  };
})());
