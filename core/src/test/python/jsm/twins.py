"""Wedges that are mirror images, and what these say of values."""

from .entropy import Contexts
from .surface import after, before


class WedgeImages:
    """image[wedge], where it has one. partner: per vertex its mirror image, or None."""

    def __init__(self, walks, partner, axis):
        self.axis = axis
        self.walks = walks
        self.surface = walks.surface
        self.partner = partner
        self.image = {}
        sure = set()
        for c in walks.corners:
            w = walks.wedge_of[c]
            if w not in sure and self._find(w, c):
                sure.add(w)

    def _vertex(self, corner):
        return self.surface.vertex_of[self.surface.at[corner]]

    def _find(self, wedge, c):
        there = self.partner[self._vertex(c)]
        if there is None:
            return False
        ahead = self.partner[self._vertex(before(c))]
        back = self.partner[self._vertex(after(c))]
        for fan in self.surface.fans_of[there]:
            for k in self.surface.slots[fan]:
                if k not in self.walks.wedge_of:
                    continue
                same_ahead = ahead is not None and self._vertex(after(k)) == ahead
                same_back = back is not None and self._vertex(before(k)) == back
                if same_ahead and same_back:
                    self.image[wedge] = self.walks.wedge_of[k]
                    return True
                if same_ahead or same_back:
                    self.image.setdefault(wedge, self.walks.wedge_of[k])
        return False


class SameValues:
    """Whether a wedge has the values of its image, or of the last wedge in the same units."""

    def __init__(self, values):
        self.values = values
        self.same = Contexts()
        self.last = 0

    def begin(self, images):
        self.images = images
        self.by_units = {}

    def decode(self, decoder, wedge):
        values = self.values
        units = tuple(values.units(wedge))
        twin = self.by_units.get(units)
        self.by_units[units] = wedge
        image = self.images.image.get(wedge) if self.images else None
        if image is not None and values.is_exact(image) and tuple(values.units(image)) == units:
            twin = image
        if twin is None:
            return False
        self.last = decoder.bit(self.same[self.last])
        if self.last:
            values.take(wedge, twin)
        return self.last


class ImageMap:
    """An affine map from the values of images to those of wedges, fitted as the sweep goes."""

    def __init__(self, walks, images, values):
        self.walks = walks
        self.images = images
        self.values = values
        self.map = [1.0, 0.0, 0.0, 1.0]

    def predict(self, wedge, error):
        """The cells of a wedge by its image, or None. error: the usual one of such predictions."""
        values = self.values
        image = self.images.image.get(wedge)
        if image is None or not values.is_exact(image):
            return None
        met = self._met(wedge)
        if not met:
            return None
        unit = float(1 << values.format.shift)
        exact = max(1, unit * unit / (error * error + 1))
        rows = []
        for w in met:
            weight = exact if w in values.exact else 1
            rows.append((weight, values.cells[self.images.image[w]], values.cells[w]))
        total = 0.0
        means = [0.0] * 4  # of the images, of the values
        for weight, of_image, of_wedge in rows:
            total += weight
            for k in range(2):
                means[k] += weight * of_image[k]
                means[2 + k] += weight * of_wedge[k]
        means = [x / total for x in means]
        self._fit(rows, means)
        x = values.cells[image][0] - means[0]
        y = values.cells[image][1] - means[1]
        m = self.map
        return [means[2 + k] + m[2 * k] * x + m[2 * k + 1] * y for k in range(2)]

    def _met(self, wedge):
        """The wedges around that have an exact image."""
        walks = self.walks
        met = []
        for c in walks.walk(wedge)[0]:
            tip = walks.behind(c)
            for corner in (after(c), before(c), tip):
                if corner is None:
                    continue
                w = walks.wedge_of[corner]
                image = self.images.image.get(w)
                if image is None or not self.values.is_exact(image) or self.values.absent[w] or w in met:
                    continue
                met.append(w)
        return met

    def _fit(self, rows, means):
        m = self.map
        xx = xy = yy = 0.0
        off = [0.0] * 4
        for weight, of_image, of_wedge in rows:
            x, y = of_image[0] - means[0], of_image[1] - means[1]
            xx += weight * x * x
            xy += weight * x * y
            yy += weight * y * y
            for k in range(2):
                r = of_wedge[k] - means[2 + k] - m[2 * k] * x - m[2 * k + 1] * y
                off[2 * k] += weight * r * x
                off[2 * k + 1] += weight * r * y
        inertia = 0.02 * (xx + yy) + 1
        xx += inertia
        yy += inertia
        determinant = xx * yy - xy * xy
        if determinant <= 0:
            return
        for k in range(2):
            rx, ry = off[2 * k], off[2 * k + 1]
            m[2 * k] += (rx * yy - ry * xy) / determinant
            m[2 * k + 1] += (ry * xx - rx * xy) / determinant
