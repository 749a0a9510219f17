"""Sweeps: more bits of the positions of all vertices."""

from .entropy import Context, Contexts, log256, round_away
from .positions import MOVED
from .ring import MOST, Ring

BLOCK = 1024
PATIENCE = 8  # blocks that fail before longer ones
TRIAL = 128
BITS = 29
COST = [2304 - log256(2 * i + 1) for i in range(256)]


class Sweeps:
    def __init__(self, positions):
        self.positions = positions
        self.moves = Context()
        self.keeps = Context()
        self.same = Contexts()
        self.halving = Contexts()
        self.next = self.vertices = 0

    def left(self):
        """Vertices that the sweep under way has not reached."""
        return self.vertices - self.next

    def begin(self, decoder, fall):
        positions = self.positions
        self.old = positions.shift
        positions.shift -= fall
        self.bits = fall
        self.next = self.done = self.failed = 0
        self.vertices = len(positions.bits)
        self.moved = 0
        if decoder.bit(self.moves):
            self.moved = 1 + decoder.below(self.vertices)
        if positions.mirror:
            positions.mirror.begin_sweep(self.old)

    def before_pass(self, decoder, fall):
        """The sweep of all vertices before a pass, if there is one."""
        if not fall and (not self.positions.shift or not decoder.bit(self.keeps)):
            return
        self.begin(decoder, fall)
        self.go_on(decoder, self.left())

    def go_on(self, decoder, count):
        for _ in range(count):
            self._vertex(decoder, self.next)
            self.next += 1

    def _vertex(self, decoder, vertex):
        positions = self.positions
        fans = positions.surface.fans_of[vertex]
        fan = fans[0]
        units = positions.mirror.swept(decoder, vertex) if positions.mirror else None
        if units is not None:
            positions.cells[fan] = [positions.middle(x) for x in units]
        elif vertex < self.moved:
            cells = positions.residual(decoder, MOVED, positions.cells[fan], 1 << self.old)
            positions.cells[fan] = cells
            positions.exact(decoder, fan, [])
        elif self.bits:
            known = self._refine(decoder, vertex, fan)
            positions.exact(decoder, fan, known)
        if positions.mirror:
            positions.mirror.passed(vertex)
        for other in fans[1:]:
            positions.copy(other)

    def _refine(self, decoder, vertex, fan):
        """Sets the cells of a vertex that is not moved; returns the neighbours that may have its values."""
        if self.done == 0:
            self.predicts = True
            self.saved = {}
            self.raw_bits = [0] * 3
            self.saved_by_same = 0
        elif self.done == TRIAL:
            saved = 32 * (self._settle() >> 8)
            bar = 3 * TRIAL * self.bits
            self.predicts = saved > bar
            self.failed = 0 if 4 * saved > bar else self.failed + 1
        self.done = (self.done + 1) % (BLOCK << max(0, min(3, self.failed - PATIENCE)))
        positions = self.positions
        if self.predicts:
            neighbours = positions.surface.ring(fan)
            if len(neighbours) <= MOST:
                return self._predict(decoder, vertex, fan, Ring(neighbours, positions.cells))
        bits = self.bits
        if 3 * bits <= 16:
            number = decoder.raw(3 * bits)
            offsets = [number >> 2 * bits, number >> bits & ((1 << bits) - 1), number & ((1 << bits) - 1)]
        else:
            offsets = [decoder.raw(bits) for _ in range(3)]
        old = positions.cells[fan]
        positions.cells[fan] = [positions.middle((x >> self.old << bits) + o) for x, o in zip(old, offsets)]
        return []

    def _settle(self):
        total = self.saved_by_same
        for role in range(3):
            best = running = 0
            self.raw_bits[role] = BITS
            for k in range(BITS - 1, -1, -1):
                running += self.saved.get((role, k), 0)
                if running > best:
                    best = running
                    self.raw_bits[role] = k
            total += best
        return total

    def _predict(self, decoder, vertex, fan, ring):
        positions = self.positions
        known = [v for v in ring.fans if positions.surface.vertex_of[v] < vertex]
        old = positions.cells[fan]
        cell = [0] * 3
        for role, axis in enumerate((ring.first, ring.second, ring.axis)):
            expected = ring.mean[axis] if role < 2 else ring.height(cell[ring.first], cell[ring.second])
            there = [positions.cells[v][axis] for v in known]
            cell[axis] = positions.middle(self._unit(decoder, role, old[axis] >> self.old, there, expected))
        positions.cells[fan] = cell
        return known

    def _unit(self, decoder, role, unit, there, expected):
        shift = self.positions.shift
        inside = [x >> shift for x in there if x >> self.old == unit]
        if inside:
            context = self.same[min(4, inside.count(inside[0]))]
            before = context.p >> 8
            bit = decoder.bit(context)
            self.saved_by_same -= COST[before if bit else 255 - before]
            if bit:
                self.saved_by_same += 256 * self.bits
                return inside[0]
        low = unit << self.bits
        most = 1 << 1 + min(self.bits, 27)
        e = max(-most, min(most, (round_away(expected) >> shift) - low))
        return low + self._offset(decoder, role, e)

    def _offset(self, decoder, role, e):
        low = 0
        left = min(self.raw_bits[role], self.bits)
        for k in range(self.bits - 1, left - 1, -1):
            d = e - low - (1 << k)
            place = max(-8, (4 * (d + 1) >> k) - 1) if d < 0 else min(7, 4 * d >> k)
            context = self.halving[role, k, place]
            before = context.p >> 8
            bit = decoder.bit(context)
            cost = COST[before if bit else 255 - before]
            self.saved[role, k] = self.saved.get((role, k), 0) + 256 - cost
            low += bit << k
        return low + decoder.raw(left)
