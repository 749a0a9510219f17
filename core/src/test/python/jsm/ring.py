"""What the neighbours of a vertex say of its position."""

import math

from .surface import OUTSIDE

MOST = 66


class Ring:
    """neighbours: fan vertices, some of them OUTSIDE."""

    def __init__(self, neighbours, cells):
        self.fans = [v for v in neighbours if v != OUTSIDE]
        n = len(self.fans)
        self.at = at = [[float(x) for x in cells[v]] for v in self.fans]
        self.gap = OUTSIDE in neighbours
        origin = at[0] if neighbours[-1] == OUTSIDE else at[-1]
        away = [[p[a] - origin[a] for a in range(3)] for p in at]
        self.centre = [1 / n * _sum(d[a] for d in away) for a in range(3)]
        if self.gap:
            gap = max(i for i, v in enumerate(neighbours) if v == OUTSIDE)
            gap -= neighbours[:gap].count(OUTSIDE)
            behind, ahead = at[gap % n], at[gap - 1]
            self.mean = [(behind[a] + ahead[a]) / 2 for a in range(3)]
        else:
            self.mean = [origin[a] + self.centre[a] for a in range(3)]
        self.moments = [[self._moment(away, a, b) for b in range(3)] for a in range(3)]
        self.spread = [_deviation(self.moments[a][a]) for a in range(3)]
        self.width = self.spread[0] + self.spread[1] + self.spread[2]
        normal = [0.0] * 3
        last = [0.0] * 3
        for d in away:
            for a in range(3):
                b, c = (a + 1) % 3, (a + 2) % 3
                normal[a] = normal[a] + last[b] * d[c] - last[c] * d[b]
            last = d
        sizes = [abs(x) for x in normal]
        self.axis = sizes.index(max(sizes))
        self.first = 1 if self.axis == 0 else 0
        self.second = 1 if self.axis == 2 else 2
        self.tilts = [normal[a] / normal[self.axis] if normal[self.axis] else 0.0 for a in (self.first, self.second)]

    def _moment(self, away, a, b):
        return 1 / len(away) * _sum(d[a] * d[b] for d in away) - self.centre[a] * self.centre[b]

    def height(self, p, q):
        """The height of the plane, where it is not too far off."""
        middle = self.mean[self.axis]
        tilt = self.tilts[0] * (p - self.mean[self.first]) + self.tilts[1] * (q - self.mean[self.second])
        return middle - tilt if abs(tilt) <= self.width else middle

    def last(self, axis):
        """From the mean to the last neighbour."""
        return self.at[-1][axis] - self.mean[axis]

    def beside_last(self, axis):
        """From the mean to the middle of the two beside the last one."""
        return (self.at[0][axis] + self.at[max(0, len(self.at) - 2)][axis]) / 2 - self.mean[axis]

    def slant(self):
        """How much farther the second coordinate lies from the mean where the first does by 1."""
        squares = self.moments[self.first][self.first]
        return self.moments[self.first][self.second] / squares if squares > 0 else 0.0

    def bend(self):
        """How far the neighbours are from their plane."""
        first, second, axis = self.first, self.second, self.axis
        m = self.moments
        tilt_p, tilt_q = self.tilts
        p = tilt_p * m[first][first] + 2 * m[first][axis]
        q = tilt_q * m[second][second] + 2 * m[second][axis]
        both = 2 * tilt_p * tilt_q * m[first][second]
        return _deviation(m[axis][axis] + tilt_p * p + tilt_q * q + both)

    def heights(self, normals, p, q):
        """The weighted mean of the neighbours' heights, and that of what their planes fall."""
        weights = heights = falls = 0.0
        for v, at in zip(self.fans, self.at):
            dp, dq = p - at[self.first], q - at[self.second]
            m1, m2, m = normals[v][self.first], normals[v][self.second], normals[v][self.axis]
            least = (abs(m1) + abs(m2)) / 4
            m = (max(m, least) if m >= 0 else min(m, -least)) or 1.0
            h = 1 / ((dp * dp + dq * dq + 1) * m)
            w = h * m
            weights += w
            heights += w * at[self.axis]
            falls += (m1 * dp + m2 * dq) * h
        return heights / weights, falls / weights


def _deviation(square):
    return 0.9 * math.sqrt(max(0.0, square))


def _sum(numbers):
    """From left to right, in doubles."""
    total = 0.0
    for x in numbers:
        total += x
    return total


def area_normals(surface, cells):
    """Per fan vertex the sum of its faces' area normals."""
    normals = [[0.0] * 3 for _ in surface.slots]
    for f in range(surface.faces()):
        face = surface.at[3 * f : 3 * f + 3]
        if OUTSIDE in face:
            continue
        a, b, c = (cells[v] for v in face)
        u = [float(y - x) for x, y in zip(a, b)]
        v = [float(y - x) for x, y in zip(a, c)]
        n = [u[i - 2] * v[i - 1] - u[i - 1] * v[i - 2] for i in range(3)]
        for corner in face:
            for i in range(3):
                normals[corner][i] += n[i]
    return normals
