"""Normals, as differences from those that the faces give."""

from math import sqrt

from .around import cross, dot, length
from .entropy import Contexts, Residuals, to_int
from .lattice import Column, Steps, float_of
from .surface import after, before

AREA, EVENLY, ANGLE = range(3)
HALF_PI = 1.5707963267948966
IMAGES = 3  # roles of images follow those of others


def arc_tangent(y, x):
    """Of y / x, for y >= 0, up to a right angle."""
    if x <= 0:
        return HALF_PI
    if y > x:
        return HALF_PI - arc_tangent(x, y)
    t = y / x
    for _ in range(2):
        t = t / (sqrt(t * t + 1) + 1)
    s = 0.0
    for n in range(23, 0, -2):
        s = 1.0 / n - s * t * t
    return s * t * 4


def normal_sums(walks, place, weights):
    """Per wedge the weighted sum of its faces' normals, and of the weights."""
    sums = {}
    for c in walks.corners[::3]:
        at = [place(walks.surface.at[c + j]) for j in range(3)]
        n = cross([y - x for x, y in zip(at[0], at[1])], [y - x for x, y in zip(at[0], at[2])])
        size = length(n)
        if size == 0:
            continue
        if weights != AREA:
            n = [x / size for x in n]
        for j in range(3):
            factor, weight = 1, size if weights == AREA else 1
            if weights == ANGLE:
                u = [y - x for x, y in zip(at[j], at[(j + 1) % 3])]
                v = [y - x for x, y in zip(at[j], at[(j + 2) % 3])]
                factor = weight = arc_tangent(size, dot(u, v) + length(u) * length(v)) * 2
            total = sums.setdefault(walks.wedge_of[c + j], [0.0] * 4)
            for k in range(3):
                total[k] += n[k] * factor
            total[3] += weight
    return sums


class NormalRefiner:
    def __init__(self, values):
        self.values = values
        self.lattice = values.format.lattice
        self.residuals = Residuals(4)
        self.columns = [Column(self.lattice) for _ in range(3)]
        self.steps = Steps()
        self.is_image = Contexts()
        self.is_mean = Contexts()
        self.last_image = self.last_mean = 0

    def begin(self, sweep):
        self.walks = sweep.walks
        self.images = sweep.images
        self.sums = normal_sums(sweep.walks, sweep.place, self.values.format.weights)

    def decode(self, decoder, wedge):
        total = self.sums.get(wedge, [0.0] * 4)
        predicted = [0.0 if abs(x) <= total[3] * 1e-13 else x for x in total[:3]]
        if self.values.format.unit:
            size = length(predicted)
            scale = 1 / size if size else 0
            predicted = [scale * x for x in predicted]
        other, role = self._other(decoder, wedge)
        predicted = other or predicted
        sizes = [abs(x) for x in predicted]
        last = sizes.index(max(sizes))
        first, second = [k for k in range(3) if k != last]
        spread = 1.0
        if total[3]:
            spread = max(0, 1 - length(total) / total[3])
        expected = (sizes[0] + sizes[1] + sizes[2]) * 4 * sqrt(spread) / self.lattice.spacing
        size = 1 + to_int(min(1 << 28, expected))
        off = self._component(decoder, wedge, role, first, predicted[first], size)
        off += self._component(decoder, wedge, role + 1, second, predicted[second], min(1 << 28, size + off >> 1))
        if off and self.values.format.unit and other is None:
            x, y = (float_of(self.values.values[wedge][k]) for k in (first, second))
            square = 1 - x * x - y * y
            z = sqrt(square) if square > 0 else 0.0
            predicted[last] = -z if predicted[last] < 0 else z
        self._component(decoder, wedge, role + 2, last, predicted[last], min(1 << 28, 1 + off))

    def _other(self, decoder, wedge):
        """The image's normal or the neighbours' mean, if it is the prediction; the first role."""
        values = self.values
        image = self.images.image.get(wedge) if self.images else None
        if image is not None and values.is_exact(image):
            self.last_image = decoder.bit(self.is_image[self.last_image])
            if self.last_image:
                normal = [float_of(b) for b in values.values[image]]
                normal[self.images.axis] = -normal[self.images.axis]
                return normal, IMAGES
        mean = self._mean(wedge)
        if mean is not None:
            self.last_mean = decoder.bit(self.is_mean[self.last_mean])
            if self.last_mean:
                return mean, 0
        return None, 0

    def _mean(self, wedge):
        """The mean of the neighbours' normals, if each has one wedge there and is exact."""
        corners, closed = self.walks.walk(wedge)
        if not closed:
            return None
        mean = [0.0] * 3
        for c in corners:
            other = self.walks.wedge_of[after(c)]
            if other != self.walks.wedge_of[before(self.walks.swing(c, -1))] or not self.values.is_exact(other):
                return None
            for k in range(3):
                mean[k] += float_of(self.values.values[other][k])
        return [x / len(corners) for x in mean]

    def _component(self, decoder, wedge, role, k, predicted, size):
        """Decodes a component; returns by how much it was off."""
        near = self.lattice.closest(predicted)
        cell = self.lattice.cell(near)
        cells, values = self.values.cells[wedge], self.values.values[wedge]
        reached = self.steps.decode(decoder, role, self.lattice, near)
        if reached is not None:
            cells[k] = cell
            values[k] = reached
            return self.steps.last
        residual = self.residuals.decode(decoder, role, size, 0, 16)
        cells[k] = cell + residual
        values[k] = self.columns[k].decode(decoder, cells[k])
        return 4 * (1 + min(abs(residual), 1 << 26))
