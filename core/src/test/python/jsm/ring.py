"""What the neighbours of a vertex say of its position."""

from .surface import OUTSIDE

MOST = 66


class Ring:
    """neighbours: fan vertices, some of them OUTSIDE."""

    def __init__(self, neighbours, cells):
        self.fans = [v for v in neighbours if v != OUTSIDE]
        n = len(self.fans)
        self.at = at = [[float(x) for x in cells[v]] for v in self.fans]
        if OUTSIDE in neighbours:
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

    def smooth_height(self, p, q, normals):
        weights = heights = 0.0
        for v, at in zip(self.fans, self.at):
            dp, dq = p - at[self.first], q - at[self.second]
            m1, m2, m = normals[v][self.first], normals[v][self.second], normals[v][self.axis]
            least = (abs(m1) + abs(m2)) / 4
            m = max(m, least) if m >= 0 else min(m, -least)
            fall = (m1 * dp + m2 * dq) / m if m else 0.0
            w = 1 / (dp * dp + dq * dq + 1)
            weights += w
            heights += w * (at[self.axis] - fall / 2)
        return heights / weights


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
