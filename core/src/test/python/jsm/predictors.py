"""Where a new vertex is expected: across the normal of its ring, and along it."""

from collections import namedtuple

from .connectivity import FEW
from .entropy import round_away
from .fits import Averages, Fit, off_by

# place: a coordinate, a double; size: how far off the cell may be; lean: to which side, -3 to 3
Expected = namedtuple("Expected", "place size lean")
MEAN, FITTED, MEDIAN = range(3)
CLOSE = 1.03
SLANT = 0.85


class TangentPredictor:
    """For each vertex begin(), then axis(0), learn(), axis(1), learn()."""

    def __init__(self, cells, dense):
        self.cells = cells
        self.dense = dense
        self.fit = Fit(0, 0)
        self.of_all = Averages(3)
        self.of_valence = [Averages(3) for _ in range(5)]
        self.tried = 0

    def begin(self, split, ring, shift):
        self.v = split.v
        self.beyond = split.beyond
        self.ring = ring
        self.part = 1 / (1 << shift)
        self.here = self.of_valence[max(0, min(4, len(ring.fans) - 4))]
        self.predictions = 2
        if self.dense:
            counts = self._counts()
            takes_part = counts[MEDIAN] < CLOSE * min(counts[MEAN], counts[FITTED])
            if not takes_part:
                self.tried += 1
                takes_part = self.tried % 8 == 0
            self.predictions += takes_part
        self.errors = [0.0] * self.predictions
        self.slanted = 0.0

    def _counts(self):
        return [a + b for a, b in zip(self.here.errors, self.of_all.errors)]

    def axis(self, number):
        """What is expected on the first axis (0) or on the second (1)."""
        ring = self.ring
        axis = self.at = (ring.first, ring.second)[number]
        mean = ring.mean[axis]
        self.features = ring.last(axis), ring.beside_last(axis)
        fitted = _clip(ring.width, self.fit.predict(*self.features)) + _clip(ring.width, self.slanted)
        self.offsets = [0.0, fitted]
        size = 7 * ring.spread[axis] + ring.width
        if self.predictions > MEDIAN:
            median, between = self._median(axis)
            median = median - mean
            self.offsets.append(median)
            size = size / 40 + (abs(median - fitted) + 2 * between)
        else:
            size = size / 2
        counts = self._sums([error / 2 for error in self.errors])
        place = mean + self.offsets[counts.index(min(counts))]
        size = int(min(1 << 28, size))
        return Expected(place, size, _lean(self.cells[self.v][axis] - round_away(place), size))

    def _sums(self, errors):
        return [e + a + b for e, a, b in zip(errors, self.here.errors, self.of_all.errors)]

    def learn(self, cell, number):
        """Learns the cell on the axis that was expected last."""
        ring = self.ring
        part = self.part
        off = cell - ring.mean[self.at]
        x, y = self.features
        self.fit.learn(part * x, part * y, part * off, 0.05 * ring.width * part + 0.3)
        self.errors = [error + off_by(off - o, part) for error, o in zip(self.errors, self.offsets)]
        if number == 0:
            self.slanted = ring.slant() * SLANT * (off - self.offsets[FITTED])
        else:
            self.here.learn(self.errors)
            self.of_all.learn(self.errors)

    def _median(self, axis):
        """Of the completions: their median, and what lies between their quartiles."""
        at = [self.cells[v][axis] for v in self.ring.fans]
        n = len(at)
        twice = [2 * (at[i - 1] + at[(i + 1) % n] - at[i]) for i in range(n)]
        twice += [at[i] + at[(i + n // 2) % n] for i in range(n if n % 2 else n // 2)]
        if n <= FEW and not self.ring.gap:
            for i, fan in enumerate(self.beyond):
                if fan >= 0:
                    twice.append(2 * (at[i] + at[(i + 1) % n] - self.cells[fan][axis]))
        twice.sort()
        k = len(twice)
        return 0.25 * (twice[k // 2] + twice[(k - 1) // 2]), 0.5 * (twice[3 * k // 4] - twice[k // 4])


class HeightPredictor:
    """The plane of the ring, or a smooth surface: the one that was better for the last vertices."""

    def __init__(self):
        self.fit = Fit(1, -0.5)
        self.averages = Averages(2)

    def expected(self, ring, normals, p, q, shift):
        self.ring = ring
        self.part = 1 / (1 << shift)
        flat = ring.height(p, q)
        height, fall = ring.heights(normals, p, q)
        most = 2 * ring.width
        self.features = _clip(most, height - flat), _clip(most, fall)
        self.heights = flat, flat + _clip(most, self.fit.predict(*self.features))
        errors = self.averages.errors
        place = self.heights[errors[1] < errors[0]]
        size = int(min(1 << 28, 4 * (ring.bend() + 0.05 * ring.width)))
        units = place * self.part
        return Expected(place, size, int(7 * min(0.999, units - units // 1)) - 3)

    def learn(self, cell):
        part = self.part
        x, y = self.features
        scale = 0.03 * self.ring.width * part + 0.3
        self.fit.learn(part * x, part * y, part * (cell - self.heights[0]), scale)
        self.averages.learn([off_by(cell - height, part) for height in self.heights])


def _clip(most, x):
    return max(-most, min(most, x))


def _lean(d, size):
    lean = 0 if d == 0 else 1 if abs(d) <= size // 2 else 2 if abs(d) <= size else 3
    return -lean if d < 0 else lean
