"""Vertices that are mirror images of others."""

from math import floor, sqrt

from .entropy import Contexts, IntegerModel, round_away, to_int
from .lattice import FLOAT_SIGN, Steps, float_of

MOST_IN_LIST = 64


class MirrorDecoder:
    def __init__(self, positions, axis, bits):
        self.positions = positions
        self.axis = axis
        self.sum = float_of(bits)
        self.in_sweep = Contexts()
        self.in_pass = Contexts()
        self.off = IntegerModel()
        self.steps = Steps()
        self.last = 0

    def cell(self, cell):
        """The image of a cell along the axis."""
        return to_int(floor(self.sum / self.positions.lattice.spacing - cell - 0.5))

    def value(self, bits):
        """The image of an exact value."""
        if self.sum == 0:
            return bits ^ FLOAT_SIGN
        return self.positions.lattice.closest(self.sum - float_of(bits))

    def _image(self, cells):
        return [self.cell(x) if a == self.axis else x for a, x in enumerate(cells)]

    # vertices by the units of their images

    def _begin_pairs(self, shift):
        self.pair_shift = shift
        self.images = {}

    def _add(self, vertex):
        image = self._image(self.positions.first_cells(vertex))
        self.images[tuple(x >> self.pair_shift for x in image)] = vertex

    def _find(self, vertex):
        units = [x >> self.pair_shift for x in self.positions.first_cells(vertex)]
        for off in (0,) if self.sum == 0 else (0, -1, 1):
            sought = list(units)
            sought[self.axis] += off
            if tuple(sought) in self.images:
                return self.images[tuple(sought)]
        return None

    def pairs(self, shift):
        """The partner of each vertex, or None."""
        self._begin_pairs(shift)
        partner = [None] * len(self.positions.surface.fans_of)
        for v in range(len(partner)):
            twin = self._find(v)
            if twin is not None and partner[twin] is None:
                partner[v] = twin
                partner[twin] = v
            self._add(v)
        return partner

    # sweeps

    def begin_sweep(self, old_shift):
        self._begin_pairs(old_shift)

    def swept(self, decoder, vertex):
        """The units of a vertex that is an image, else None."""
        twin = self._find(vertex)
        if twin is None:
            return None
        self.last = decoder.bit(self.in_sweep[self.last])
        return self._take(decoder, vertex, twin) if self.last else None

    def passed(self, vertex):
        self._add(vertex)

    def _take(self, decoder, vertex, twin):
        positions = self.positions
        shift = positions.shift
        cells = positions.first_cells(twin)
        units = [x >> shift for x in cells]
        if shift:
            units[self.axis] = self.cell(cells[self.axis]) >> shift
            if self.sum != 0:
                units[self.axis] += self.off.signed(decoder)
            return units
        bits = list(positions.bits[twin])
        bits[self.axis] = self.steps.decode(decoder, 0, positions.lattice, self.value(bits[self.axis]))
        positions.bits[vertex] = bits
        units[self.axis] = positions.lattice.cell(bits[self.axis])
        return units

    # passes

    def begin_pass(self):
        partner = self.pairs(self.positions.shift)
        n = len(partner)
        cells = [self.positions.first_cells(v) for v in range(n)]
        longest = max(max(c[a] for c in cells) - min(c[a] for c in cells) for a in range(3))
        self.block = 0
        while self.block < 28 and 1 << self.block < longest * 2 / sqrt(n + 1):
            self.block += 1
        self.mask = (2 << n.bit_length()) - 1
        self.lists = {}
        self.paired = {v for v in range(n) if partner[v] is not None}
        for v in range(n):
            if partner[v] is None:
                self._list(cells[v]).append(v)

    def _list(self, cells):
        return self._list_of([x >> self.block for x in cells])

    def _list_of(self, block):
        c = 0x9E3779B1
        x, y, z = block
        key = (((x * c + y) * c + z) * c & 0xFFFFFFFF) >> 8 & self.mask
        return self.lists.setdefault(key, [])

    def _nearest(self, at, radius):
        """The closest unpaired vertex and its distance, or None."""
        reach = min(radius, 1.5 * (1 << self.block))
        spans = [range(floor(x - reach) >> self.block, (floor(x + reach) >> self.block) + 1) for x in at]
        best = None
        least = reach * reach
        for x in spans[0]:
            for y in spans[1]:
                for z in spans[2]:
                    for v in self._list_of((x, y, z))[-MOST_IN_LIST:]:
                        if v in self.paired:
                            continue
                        d = [c - e for c, e in zip(self.positions.first_cells(v), at)]
                        square = d[0] * d[0] + d[1] * d[1] + d[2] * d[2]
                        if square < least or square <= least and (best is None or v < best):
                            least = square
                            best = v
        return best, sqrt(least)

    def new(self, decoder, u, ring):
        """The units of a new vertex that is an image, else None."""
        at = list(ring.mean)
        at[ring.axis] = ring.height(round_away(at[ring.first]), round_away(at[ring.second]))
        at[self.axis] = float(self.cell(round_away(at[self.axis])))
        twin, distance = self._nearest(at, 0.9 * ring.width)
        if twin is None:
            return None
        vertex_of = self.positions.surface.vertex_of
        paired = sum(vertex_of[v] in self.paired for v in ring.fans)
        tenths = min(8, int(distance / ring.width * 10)) if ring.width > 0 else 0
        if not decoder.bit(self.in_pass[tenths, 2 * paired // len(ring.fans)]):
            return None
        units = self._take(decoder, vertex_of[u], twin)
        self.paired.update((twin, vertex_of[u]))
        return units

    def came(self, vertex):
        """A new vertex that is no image has its position."""
        shift = self.positions.shift
        cells = self.positions.first_cells(vertex)
        cell = cells[self.axis]
        if abs((cell >> shift) - (self.cell(cell) >> shift)) <= 1:
            self.paired.add(vertex)
        else:
            self._list(cells).append(vertex)
