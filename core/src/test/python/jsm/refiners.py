"""Attribute sweeps: the exact values of channels."""

from .around import Around
from .identity import shown_position
from .lattice import Column, float_of
from .normals import NormalRefiner
from .spread import Spread
from .twins import ImageMap, SameValues, WedgeImages
from .walk import Walks

NOTHING, RIM, INSIDE, IMAGE = range(4)


class ByteRefiner:
    def __init__(self, values):
        self.values = values
        self.same = SameValues(values)
        self.spread = Spread()

    def begin(self, sweep):
        self.around = sweep.around
        self.same.begin(sweep.images)
        self.errors = {}
        self.usual = [1.0] * self.values.components

    def decode(self, decoder, wedge):
        values = self.values
        if self.same.decode(decoder, wedge):
            return
        shift = values.format.shift
        cells = values.cells[wedge]
        around = self.around.predict(wedge, values)[0] or list(cells)
        before = 0, 0.0
        for k in range(values.components):
            low = cells[k] >> shift << shift
            p = around[k]
            if values.format.follow and k < 3:
                p = p + before[0] - before[1]
            s = self.usual[k] if k else self.around.mean_error(self.errors, wedge, self.usual[0])
            cell = low + self.spread.decode(decoder, k, p - low + 0.5, max(0.25, s), shift)
            cells[k] = values.values[wedge][k] = cell
            before = cell, around[k]
            error = abs(cell - p)
            self.usual[k] += (error - self.usual[k]) / 16
            if k == 0:
                self.errors[wedge] = error


class StagedRefiner:
    def __init__(self, values):
        self.values = values
        self.same = SameValues(values)
        self.spread = Spread()
        self.columns = [Column(values.format.lattice) for _ in range(values.components)]
        self.by_image = self.by_around = 0.0

    def begin(self, sweep):
        self.around = sweep.around
        self.same.begin(sweep.images)
        self.map = None
        if sweep.images and self.values.components == 2:
            self.map = ImageMap(sweep.walks, sweep.images, self.values)
        self.errors = {}
        self.usual = [(1 << self.values.format.shift) / 8.0] * 4

    def decode(self, decoder, wedge):
        values = self.values
        if self.same.decode(decoder, wedge):
            return
        shift = values.format.shift
        around, inside = self.around.predict(wedge, values)
        image = self.map.predict(wedge, self.usual[IMAGE]) if self.map else None
        kind = NOTHING if around is None else INSIDE if inside else RIM
        cells = values.cells[wedge]
        predicted = around or list(cells)
        if image is not None and (around is None or self.by_image <= self.by_around):
            kind = IMAGE
            predicted = image
        s = max(0.25, self.around.mean_error(self.errors, wedge, self.usual[kind]))
        total = 0.0
        for k in range(values.components):
            low = cells[k] >> shift << shift
            cells[k] = low + self.spread.decode(decoder, kind, predicted[k] - low + 0.5, s, shift)
            values.values[wedge][k] = self.columns[k].decode(decoder, cells[k])
            total += abs(cells[k] - predicted[k])
            if k == 0:
                s = max(0.25, (s + total) / 2)
        error = self.errors[wedge] = total / values.components
        self.usual[kind] += (error - self.usual[kind]) / 16
        if image is not None:
            of_image = sum(_bits(c - p) for c, p in zip(cells, image))
            of_around = values.components * shift
            if around is not None:
                of_around = sum(_bits(c - p) for c, p in zip(cells, around))
            self.by_image += (of_image - self.by_image) / 8
            self.by_around += (of_around - self.by_around) / 8


def _bits(x):
    return int(min(abs(x), 1 << 28)).bit_length()


class Attributes:
    """The sweeps over all wedges."""

    def __init__(self, decoder):
        self.decoder = decoder
        self.wedges = decoder.wedges
        self.refiners = {}
        for i, values in enumerate(self.wedges.channels):
            if values.format.normals:
                self.refiners[i] = NormalRefiner(values)
            elif values.format.shift:
                self.refiners[i] = ByteRefiner(values) if values.format.bytes else StagedRefiner(values)
        self.left = []

    def decode(self, stream, count):
        if not self.left:
            self._begin()
        for wedge in self.left[:count]:
            for i in self.active:
                values = self.wedges.channels[i]
                if not values.absent[wedge]:
                    self.refiners[i].decode(stream, wedge)
                values.exact.add(wedge)
        self.left = self.left[count:]
        if not self.left:
            for i in self.active:
                del self.refiners[i]

    def _begin(self):
        positions = self.decoder.positions
        opening = self.decoder.opening
        coarse = positions.shift > 0
        self.active = [i for i in self.refiners if not coarse or self.wedges.channels[i].format.bytes]
        self.walks = Walks(self.decoder.surface, self.wedges)
        rows = positions.bits
        if coarse:
            rows = [[positions.lattice.edge(x) for x in positions.first_cells(v)] for v in range(len(rows))]
        places = [[float_of(b) for b in shown_position(opening, row)] for row in rows]
        vertex_of = self.decoder.surface.vertex_of
        self.place = lambda fan: places[vertex_of[fan]]
        self.around = Around(self.walks, self.place)
        self.images = None
        if positions.mirror:
            self.images = WedgeImages(self.walks, positions.mirror.pairs(0), positions.mirror.axis)
        self.left = self.walks.order(any(c.format.normals for c in self.wedges.channels))
        for i in self.active:
            self.refiners[i].begin(self)
