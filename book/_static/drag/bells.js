/* One number, known from before and measured: two bells and their product, the Kalman update in one dimension.

   State: prior [mean, sigma], seen [measurement, sigma]; least, the smallest sigma. */
Drag.add("bells", (() => {
  const density = (x, mean, sigma) => Math.exp(-(((x - mean) / sigma) ** 2) / 2) / (sigma * Math.sqrt(2 * Math.PI));
  /** The product of two Gaussians, normalized: the gain, and its mean and variance. */
  function product([mean, sigma], [measured, noise]) {
    const gain = sigma ** 2 / (sigma ** 2 + noise ** 2);
    return { gain, mean: mean + gain * (measured - mean), variance: gain * noise ** 2 };
  }

  const peak = ([mean, sigma]) => [mean, density(mean, mean, sigma)];
  const shoulder = ([mean, sigma]) => [mean + sigma, density(mean + sigma, mean, sigma)];
  const posterior = ({ prior, seen }) => {
    const { mean, variance } = product(prior, seen);
    return [mean, Math.sqrt(variance)];
  };
  const bell = ([mean, sigma]) => Array.from({ length: 121 }, (_, i) => {
    const x = mean + sigma * (i - 60) / 12;
    return [x, density(x, mean, sigma)];
  });
  const handles = (name, what) => ({
    [`${name} mean`]: {
      label: `${what}: its middle`,
      along: "x",
      at: (state) => peak(state[name]),
      value: (state) => state[name][0],
      moved: (state, [x]) => ({ ...state, [name]: [x, state[name][1]] }),
    },
    [`${name} sigma`]: {
      label: `${what}: its standard deviation`,
      along: "x",
      at: (state) => shoulder(state[name]),
      value: (state) => state[name][1],
      moved: (state, [x]) => ({ ...state, [name]: [state[name][0], Math.max(x - state[name][0], state.least ?? 0.1)] }),
    },
  });

  return {
    formulas: { density, product },
    handles: { ...handles("prior", "what was known"), ...handles("seen", "the measurement") },
    parts(state) {
      const after = posterior(state);
      return {
        prior: bell(state.prior), seen: bell(state.seen), posterior: bell(after),
        "prior words": { at: peak(state.prior) }, "seen words": { at: peak(state.seen) }, "posterior words": { at: peak(after) },
      };
    },
    numbers(state) {
      const [mean, sigma] = posterior(state), { gain } = product(state.prior, state.seen);
      return { m: state.prior[0], s: state.prior[1], z: state.seen[0], r: state.seen[1], gain, mean, sigma };
    },
  };
})());
