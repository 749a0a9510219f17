"""What the wedges around a wedge, on the exact mesh, say of its values."""

from math import sqrt

from .surface import after, before


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    """The vector product."""
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def length(a):
    return sqrt(dot(a, a))


class Around:
    """place(fan): coordinates that are shown, as doubles."""

    def __init__(self, walks, place):
        self.walks = walks
        self.place = place
        self.surface = walks.surface

    def mean_error(self, errors, wedge, usual):
        total, n = usual, 1
        for c in self.walks.walk(wedge)[0]:
            for other in (after(c), before(c)):
                error = errors.get(self.walks.wedge_of[other])
                if error is not None:
                    total += error
                    n += 1
        return total / n

    def predict(self, wedge, values):
        """The prediction of a channel's cells, or None, and whether the wedge lies inside."""
        corners, inside = self.walks.walk(wedge)
        sums = _Sums(values.components)
        for c in corners:
            self._add_face(c, values, sums)
        return sums.prediction(inside), inside

    def _at(self, corner):
        return self.place(self.surface.at[corner])

    def _add_face(self, c, values, sums):
        to_a, to_b = after(c), before(c)
        a, b = self.walks.wedge_of[to_a], self.walks.wedge_of[to_b]
        if values.absent[a] or values.absent[b]:
            return
        cells_a, cells_b = values.cells[a], values.cells[b]
        for k in range(values.components):
            sums.plain[k] = sums.plain[k] + cells_a[k] + cells_b[k]
        sums.count += 2
        at = self._at(c)
        u = [x - y for x, y in zip(self._at(to_a), at)]
        v = [x - y for x, y in zip(self._at(to_b), at)]
        size_u, size_v = length(u), length(v)
        if size_u == 0 or size_v == 0:
            return
        area = length(cross(u, v))
        below = dot(u, v) + size_u * size_v
        if below <= 0:
            return
        t = area / below
        weight_a, weight_b = t / size_u, t / size_v
        for k in range(values.components):
            sums.inner[k] = sums.inner[k] + weight_a * cells_a[k] + weight_b * cells_b[k]
        sums.inner_weight = sums.inner_weight + weight_a + weight_b
        tip = self.walks.behind(c)
        if tip is not None and not values.absent[self.walks.wedge_of[tip]]:
            self._add_beyond(a, b, tip, (at, u, v, area), values, sums)

    def _add_beyond(self, a, b, tip, face, values, sums):
        at, u, v, area = face
        third = self.walks.wedge_of[tip]
        e = [y - x for x, y in zip(u, v)]
        square = dot(e, e)
        if square == 0:
            return
        w = [x - y - z for x, y, z in zip(self._at(tip), at, u)]
        depth = length(cross(e, w))
        if depth == 0:
            return
        along = -dot(u, e) / square
        along_tip = dot(w, e) / square
        weight = 64 if all(x in values.exact for x in (a, b, third)) else 1
        stretch = min(4, area / depth)
        for k in range(values.components):
            start = values.cells[a][k]
            step = values.cells[b][k] - start
            aside = values.cells[third][k] - start - along_tip * step
            sums.beyond[k] += (start + along * step - stretch * aside) * weight
        sums.beyond_weight += weight


class _Sums:
    def __init__(self, components):
        self.plain = [0.0] * components
        self.inner = [0.0] * components
        self.beyond = [0.0] * components
        self.count = 0
        self.inner_weight = self.beyond_weight = 0.0

    def prediction(self, inside):
        if self.count == 0:
            return None
        plain = [x / self.count for x in self.plain]
        near = [x / self.inner_weight for x in self.inner] if self.inner_weight else plain
        if not self.beyond_weight:
            return near if inside else plain
        far = [x / self.beyond_weight for x in self.beyond]
        return [x * (1 - 0.4) + y * 0.4 for x, y in zip(near, far)] if inside else far
