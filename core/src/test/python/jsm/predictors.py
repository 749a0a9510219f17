"""Where a new vertex is expected.

A predictor has begin(split, ring), then tangent(axis) for the first and the second axis, height(p, q) at the cells
known by then, each of which gives an Expected, and learn(cell) for the height that was coded.
"""

from collections import namedtuple

from .entropy import round_away

# place: a coordinate, a double; size: how far off the cell may be; lean: to which side, -3 to 3
Expected = namedtuple("Expected", "place size lean")


class RingPredictor:
    """The mean of the ring; the plane or the smooth surface, the one that was better for the last vertices."""

    def __init__(self, positions):
        self.positions = positions
        self.errors = [0.0, 0.0]

    def begin(self, split, ring):
        self.v = split.v
        self.ring = ring

    def _size(self, axis):
        return int(min(1 << 28, (7 * self.ring.spread[axis] + self.ring.width) / 2))

    def tangent(self, axis):
        place = self.ring.mean[axis]
        size = self._size(axis)
        return Expected(place, size, _lean(self.positions.cells[self.v][axis] - round_away(place), size))

    def height(self, p, q):
        ring = self.ring
        self.heights = ring.height(p, q), ring.smooth_height(p, q, self.positions.normals)
        return Expected(self.heights[self.errors[1] < self.errors[0]], self._size(ring.axis), 0)

    def learn(self, cell):
        for i, height in enumerate(self.heights):
            size = abs(cell - height) / (1 << self.positions.shift)
            self.errors[i] += (size / (size + 4) - self.errors[i]) / 64


def _lean(d, size):
    lean = 0 if d == 0 else 1 if abs(d) <= size // 2 else 2 if abs(d) <= size else 3
    return -lean if d < 0 else lean
