"""What the neighbours of a vertex say of its position."""

from .surface import OUTSIDE

MOST = 66


class Ring:
    """neighbours: fan vertices, some of them OUTSIDE."""

    def __init__(self, neighbours, cells):
        self.fans = [v for v in neighbours if v != OUTSIDE]
        n = len(self.fans)
        self.at = at = [[float(x) for x in cells[v]] for v in self.fans]
        self.gap = OUTSIDE in neighbours
        if self.gap:
            gap = max(i for i, v in enumerate(neighbours) if v == OUTSIDE)
            gap -= neighbours[:gap].count(OUTSIDE)
            behind, ahead = at[gap % n], at[gap - 1]
            self.mean = [(behind[a] + ahead[a]) / 2 for a in range(3)]
        else:
            self.mean = [1 / n * _sum(p[a] for p in at) for a in range(3)]
        away = [[p[a] - self.mean[a] for a in range(3)] for p in at]
        sums = [_sum(abs(d[a]) for d in away) for a in range(3)]
        self.spread = [1 / n * s for s in sums]
        self.width = 1 / n * (sums[0] + sums[1] + sums[2])
        self.normal = [0.0] * 3
        last = away[-1]
        for d in away:
            for a in range(3):
                b, c = (a + 1) % 3, (a + 2) % 3
                self.normal[a] = self.normal[a] + last[b] * d[c] - last[c] * d[b]
            last = d
        sizes = [abs(x) for x in self.normal]
        self.axis = sizes.index(max(sizes))
        self.first = 1 if self.axis == 0 else 0
        self.second = 1 if self.axis == 2 else 2

    def height(self, p, q):
        """The height of the plane, where it is not too far off."""
        middle = self.mean[self.axis]
        n = self.normal
        if n[self.axis] == 0:
            return middle
        tilt = n[self.first] * (p - self.mean[self.first]) + n[self.second] * (q - self.mean[self.second])
        tilt = tilt / n[self.axis]
        return middle - tilt if abs(tilt) <= self.width else middle

    def last(self, axis):
        """From the mean to the last neighbour."""
        return self.at[-1][axis] - self.mean[axis]

    def beside_last(self, axis):
        """From the mean to the middle of the two beside the last one."""
        return (self.at[0][axis] + self.at[max(0, len(self.at) - 2)][axis]) / 2 - self.mean[axis]

    def slant(self):
        """How much farther the second coordinate lies from the mean where the first does by 1."""
        squares = products = 0.0
        for p in self.at:
            first = p[self.first] - self.mean[self.first]
            squares += first * first
            products += first * (p[self.second] - self.mean[self.second])
        return products / squares if squares else 0.0

    def heights(self, normals, p, q):
        """The weighted mean of the neighbours' heights, that of what their planes fall, and how far they are bent."""
        n = self.normal
        tilts = [n[a] / n[self.axis] if n[self.axis] else 0.0 for a in (self.first, self.second)]
        middle = self._tilted(self.mean, tilts)
        weights = heights = falls = bends = 0.0
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
            bends += abs(self._tilted(at, tilts) - middle)
        return heights / weights, falls / weights, 1 / len(self.fans) * bends

    def _tilted(self, at, tilts):
        return at[self.axis] + tilts[0] * at[self.first] + tilts[1] * at[self.second]


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
