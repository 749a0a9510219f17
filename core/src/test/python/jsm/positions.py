"""Positions of new vertices."""

from .entropy import Residuals, round_away
from .lattice import Column
from .mirror import MirrorDecoder
from .predictors import HeightPredictor, TangentPredictor
from .ring import Ring, area_normals

UNIT_CLASS = 4
TANGENTS, NORMAL, FREE, MOVED = (0, 1), 2, 3, 4
NO_SURPRISE = 16
UNTAGGED = (2 * NO_SURPRISE, NO_SURPRISE)


class Positions:
    """cells: per fan its cells; tags: per fan those of tangents, summed, and of the normal; bits: per vertex."""

    def __init__(self, surface, opening, cells):
        self.surface = surface
        self.lattice = opening.lattice
        self.cells = cells
        self.tags = []
        self.bits = []
        self.shift = opening.index.base.shift
        self.columns = [Column(self.lattice) for _ in range(3)]
        self.residuals = Residuals(UNIT_CLASS)
        self.tangents = TangentPredictor(cells, opening.dense)
        self.heights = HeightPredictor()
        self.mirror = None
        if opening.mirror_axis is not None:
            self.mirror = MirrorDecoder(self, opening.mirror_axis, opening.mirror_sum)
        self.normals = []

    def begin_pass(self):
        self.normals = area_normals(self.surface, self.cells)
        if self.mirror:
            self.mirror.begin_pass()

    def first_cells(self, vertex):
        return self.cells[self.surface.fans_of[vertex][0]]

    def middle(self, unit):
        return unit if self.shift == 0 else (unit << self.shift) + (1 << (self.shift - 1))

    def scaled(self, size):
        """The size of which a residual has the class."""
        return size >> self.shift - 2 if self.shift > 2 else size << 2 - self.shift

    def grow(self, fan):
        while len(self.cells) <= fan:
            self.cells.append(None)
            self.tags.append(UNTAGGED)
        while len(self.bits) < len(self.surface.fans_of):
            self.bits.append([None] * 3)

    def copy(self, fan):
        """Gives a further fan of a vertex what its first one has."""
        self.grow(fan)
        first = self.surface.fans_of[self.surface.vertex_of[fan]][0]
        self.cells[fan] = list(self.cells[first])
        self.tags[fan] = self.tags[first]

    def near(self, decoder, fan, expected, size):
        """A position near a point in cells, as of the base."""
        self.grow(fan)
        self.cells[fan] = self.residual(decoder, FREE, expected, size)
        self.tags[fan] = UNTAGGED
        self.exact(decoder, fan, [])

    def residual(self, decoder, role, expected, size):
        cells = []
        for x in expected:
            residual = self.residuals.decode(decoder, role, self.scaled(size), 0, NO_SURPRISE)
            cells.append(self.middle((x >> self.shift) + residual))
        return cells

    def new(self, decoder, split):
        """The position of a split's new vertex."""
        u = split.u
        self.grow(u)
        ring = Ring(split.ring + [split.v], self.cells)
        if self.mirror:
            units = self.mirror.new(decoder, u, ring)
            if units is not None:
                self.cells[u] = [self.middle(x) for x in units]
                self.tags[u] = UNTAGGED
                return
        n = len(ring.fans)
        tangent_surprise = sum(self.tags[v][0] for v in ring.fans) // (2 * n)
        normal_surprise = sum(self.tags[v][1] for v in ring.fans) // n
        self.tangents.begin(split, ring, self.shift)
        cell = [0] * 3
        tag = 0
        for role, axis in zip(TANGENTS, (ring.first, ring.second)):
            cell[axis] = self._cell(decoder, role, self.tangents.axis(role), tangent_surprise)
            self.tangents.learn(cell[axis], role)
            tag += self.residuals.surprise
        expected = self.heights.expected(ring, self.normals, cell[ring.first], cell[ring.second], self.shift)
        cell[ring.axis] = self._cell(decoder, NORMAL, expected, normal_surprise)
        self.heights.learn(cell[ring.axis])
        self.cells[u] = cell
        self.tags[u] = tag, self.residuals.surprise
        self.exact(decoder, u, ring.fans)
        if self.mirror:
            self.mirror.came(self.surface.vertex_of[u])

    def _cell(self, decoder, role, expected, surprise):
        size = self.scaled(expected.size)
        residual = self.residuals.decode(decoder, role, size, expected.lean, surprise)
        return self.middle((round_away(expected.place) >> self.shift) + residual)

    def exact(self, decoder, fan, neighbours):
        """The exact values in the cells of a vertex, once units are cells."""
        if self.shift:
            return
        vertex = self.surface.vertex_of[fan]
        for axis in range(3):
            cell = self.cells[fan][axis]
            known = None
            for v in neighbours:
                if self.cells[v][axis] == cell:
                    known = self.bits[self.surface.vertex_of[v]][axis]
                    break
            self.bits[vertex][axis] = self.columns[axis].decode(decoder, cell, known)
