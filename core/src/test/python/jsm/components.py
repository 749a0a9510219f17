"""The positions of components' vertices, and whether another component comes."""

from .base import BaseDecoder
from .entropy import Context, Contexts, IntegerModel


class Components:
    def __init__(self, surface, positions, connectivity, opening):
        self.surface = surface
        self.positions = positions
        self.connectivity = connectivity
        self.stitches = opening.stitches
        self.may_come_later = opening.late_components
        self.faces = BaseDecoder(surface)
        self.stitched = Context()
        self.another = Contexts()
        unit = 1 << max(0, opening.box_bits - 5)
        lows, sizes = opening.box_low, opening.box_size
        self.middle = [int((2 * lows[a] + sizes[a]) * unit / 2) for a in range(3)]
        self.half = max(sizes) * unit // 2
        self.apart = self.half >> 1
        self.wide = self.half >> 3
        self.last_first = None
        self.later = False

    def base(self, streams, faces):
        if self.stitches:
            IntegerModel().unsigned(streams.connectivity)
        self.geometry = streams.geometry
        self.faces.decode(streams.connectivity, faces, self._added)
        self.later = True

    def begin_pass(self):
        self.may_come = self.may_come_later
        self.come = 0

    def decode_another(self, streams):
        """Decodes whether another component comes, and if so, the component. Returns its faces."""
        if not self.may_come:
            return 0
        self.may_come = streams.connectivity.bit(self.another[min(1, self.come)])
        self.come += 1
        if not self.may_come:
            return 0
        self.geometry = streams.geometry
        return self.faces.decode_one(streams.connectivity, self._added)

    def _added(self, fan, *across):
        self.connectivity.added(fan)
        known = len(self.surface.fans_of)
        number = fan - self.faces.first
        if self.stitches and known and self.geometry.bit(self.stitched):
            self.surface.name(fan, self.geometry.below(known))
            self.positions.copy(fan)
        else:
            self.surface.new_vertex(fan)
            self.positions.near(self.geometry, fan, *self._expected(fan, number, across))
        if self.later and number == 0:
            if self.last_first is not None:
                self.apart += (self._distance(self.last_first, fan) >> 2) - (self.apart >> 2)
            self.last_first = fan
        elif self.later and number == 1:
            self.wide += (self._distance(self.faces.first, fan) >> 2) - (self.wide >> 2)

    def _expected(self, fan, number, across):
        cells = self.positions.cells
        if across:
            a, b, c = across
            place = [x + y - z for x, y, z in zip(cells[a], cells[b], cells[c])]
            return place, self._distance(a, b) >> 1
        if self.later and number > 0:
            return cells[self.faces.first], self.wide
        if self.later and self.last_first is not None:
            return cells[self.last_first], self.apart
        return self.middle, self.half >> 1

    def _distance(self, a, b):
        cells = self.positions.cells
        return max(abs(x - y) for x, y in zip(cells[a], cells[b]))
