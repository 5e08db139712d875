"""Wrong solutions of chapter observability."""

import numpy as np

from book.tests.wrong_solutions import wrong


def _rotation(angle):
    return np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])


@wrong("observability.1", "moves the anchor and forgets that the angle turns with the world")
def angle_stays(motion, landmark):
    return np.array([*(motion[:2] + _rotation(motion[2]) @ landmark[:2]), *landmark[2:]])


@wrong("observability.1", "keeps the anchor and finds the new angle and distance: no new landmark is that")
def anchor_stays(motion, landmark):
    point = landmark[:2] + landmark[3] * np.array([np.cos(landmark[2]), np.sin(landmark[2])])
    d = motion[:2] + _rotation(motion[2]) @ point - landmark[:2]
    angle = np.arctan2(d[1], d[0])
    turns = np.round((landmark[2] - angle) / (2 * np.pi)) if not motion.any() else 0
    return np.array([*landmark[:2], angle + 2 * np.pi * turns, np.hypot(*d)])


@wrong("observability.1", "turns to the other side")
def other_side(motion, landmark):
    return np.array([*(motion[:2] + _rotation(-motion[2]) @ landmark[:2]), landmark[2] - motion[2], landmark[3]])


def _matrix(predicted, updated, landmarks, carried):
    m, rows, product = landmarks.shape[1], [], np.eye(3 + 2 * landmarks.shape[1])
    for k, (pose, marks) in enumerate(zip(predicted, landmarks, strict=True)):
        if k:
            x, y = pose[:2] - updated[k - 1][:2]
            F = np.eye(3 + 2 * m)
            F[:2, 2] = -y, x
            product = carried(F, product)
        for i, (x, y) in enumerate(marks - pose[:2]):
            A = np.array([[x, y], [-y, x]]) / np.array([[np.hypot(x, y)], [x * x + y * y]])
            H = np.zeros((2, 3 + 2 * m))
            H[:, :2], H[1, 2], H[:, 3 + 2 * i : 5 + 2 * i] = -A, -1, A
            rows.append(H @ product)
    return np.concatenate(rows)


@wrong("observability.2", "stacks H alone, as if the robot stood still")
def without_motion(predicted, updated, landmarks):
    return _matrix(predicted, updated, landmarks, lambda F, product: product)


@wrong("observability.2", "takes only the last motion instead of the product")
def last_motion(predicted, updated, landmarks):
    return _matrix(predicted, updated, landmarks, lambda F, product: F)


@wrong("observability.2", "takes F between the predicted poses, whatever the filter did")
def always_first_estimates(predicted, updated, landmarks):
    return _matrix(predicted, predicted, landmarks, lambda F, product: F @ product)


@wrong("observability.2", "takes F between the updated poses")
def between_updated(predicted, updated, landmarks):
    departures = updated[:-1] + (predicted - updated)[1:]
    return _matrix(predicted, departures, landmarks, lambda F, product: F @ product)


@wrong("observability.2", "takes H at the updated poses")
def at_updated(predicted, updated, landmarks):
    departures = updated[:-1] + (updated - predicted)[1:]
    return _matrix(updated, departures, landmarks, lambda F, product: F @ product)


@wrong("observability.2", "takes all H at the first estimates of the landmarks, whatever the filter did")
def first_landmarks(predicted, updated, landmarks):
    return _matrix(predicted, updated, 0 * landmarks + landmarks[0], lambda F, product: F @ product)


@wrong("observability.3", "claims that least squares is not biased")
def unbiased(scale, displacements, sigma):
    return scale


@wrong("observability.3", "counts the noise once instead of once for each displacement")
def once(scale, displacements, sigma):
    total = (displacements**2).sum()
    return scale * total / (total + (len(displacements) > 0) * sigma**2 / len(displacements))


@wrong("observability.3", "has the bias with the wrong sign")
def too_large(scale, displacements, sigma):
    total = (displacements**2).sum()
    return scale * (total + len(displacements) * sigma**2) / total


@wrong("observability.3", "squares the mean distance instead of taking the mean square")
def squared_mean_distance(scale, displacements, sigma):
    return scale / (1 + sigma**2 / np.mean(np.abs(displacements)) ** 2)


@wrong("observability.3", "squares the mean displacement")
def squared_mean(scale, displacements, sigma):
    return scale / (1 + sigma**2 / np.mean(displacements) ** 2)
