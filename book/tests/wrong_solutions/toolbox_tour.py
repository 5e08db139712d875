"""Wrong solutions of chapter toolbox_tour."""

import numpy as np

from book.tests.wrong_solutions import wrong


@wrong("toolbox_tour.1", "the product in the other order")
def other_order(line, c):
    return np.concatenate([line[:3] + np.cross(line[3:], c), line[3:]])


@wrong("toolbox_tour.1", "adds the shift, as to a point")
def as_a_point(line, c):
    return np.concatenate([line[:3] + c, line[3:]])


@wrong("toolbox_tour.1", "writes into the line")
def in_place(line, c):
    line[:3] += np.cross(c, line[3:])
    return line


def _null(H, least=1e-9):
    _, s, V = np.linalg.svd(H)
    return V[int((s > least * max(s[0], 1e-300)).sum()) :].T


wrong("toolbox_tour.2", "looks at the first look alone")(lambda predictions: _null(predictions[0]))
wrong("toolbox_tour.2", "adds the Jacobians up, so that their rows hide each other")(lambda all_: _null(all_.sum(0)))
wrong("toolbox_tour.2", "a threshold for which a small look is none")(lambda all_: _null(np.vstack(all_), 1e-4))
wrong("toolbox_tour.2", "zero is only what rounding leaves")(lambda all_: _null(np.vstack(all_), 1e-15))
wrong("toolbox_tour.2", "every measurement in a unit of its own")(
    lambda all_: _null(np.vstack([H / max(np.linalg.norm(H), 1e-300) for H in all_]))
)


@wrong("toolbox_tour.2", "a threshold for the square of the singular values")
def squared(predictions):
    H = np.vstack(predictions)
    values, V = np.linalg.eigh(H.T @ H)
    return V[:, values <= 1e-9 * values[-1]]


@wrong("toolbox_tour.2", "returns what is seen")
def row_space(predictions):
    _, s, V = np.linalg.svd(np.vstack(predictions))
    return V[: int((s > 1e-9 * max(s[0], 1e-300)).sum())].T


@wrong("toolbox_tour.2", "a threshold that does not follow the unit")
def absolute(predictions):
    _, s, V = np.linalg.svd(np.vstack(predictions))
    return V[int((s > 1e-9).sum()) :].T


@wrong("toolbox_tour.3", "every run has the experiment's seed")
def one_seed(seed, runs):
    return [np.random.default_rng(seed) for _ in range(runs)]


@wrong("toolbox_tour.3", "neighbouring experiments share all runs but one")
def seed_plus_number(seed, runs):
    return [np.random.default_rng(seed + i) for i in range(runs)]


@wrong("toolbox_tour.3", "one stream for each worker, of which there are four")
def by_worker(seed, runs):
    return [np.random.default_rng([seed, i % 4]) for i in range(runs)]


@wrong("toolbox_tour.3", "fresh entropy, never the same again")
def fresh(seed, runs):
    return [np.random.default_rng() for _ in range(runs)]


@wrong("toolbox_tour.3", "the streams depend on how many there are")
def by_count(seed, runs):
    return [np.random.default_rng([seed, runs, i]) for i in range(runs)]


@wrong("toolbox_tour.3", "one generator, many times")
def one_generator(seed, runs):
    return [np.random.default_rng(seed)] * runs


@wrong("toolbox_tour.3", "a thousand numbers for each experiment, which a long one exceeds")
def thousands(seed, runs):
    return [np.random.default_rng(1000 * seed + i) for i in range(runs)]


@wrong("toolbox_tour.3", "five thousand numbers for each experiment")
def five_thousands(seed, runs):
    return [np.random.default_rng(5000 * seed + i) for i in range(runs)]


@wrong("toolbox_tour.3", "seeds drawn from few numbers, some of them twice")
def drawn(seed, runs):
    return [np.random.default_rng(s) for s in np.random.default_rng(seed).integers(1000, size=runs)]
