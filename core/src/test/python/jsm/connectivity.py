"""Splits: which vertices split, and with which runs of faces."""

from .cuts import CountedCuts
from .entropy import log8
from .surface import OUTSIDE
from .stitches import Stitches

MOST_VALENCE = 64


class Split:
    """A split: v, u, the ring of u without v; the faces; whether u is a further fan of a vertex."""

    def __init__(self, v, u, left, right, ring, run):
        self.v = v
        self.u = u
        self.left = left
        self.right = right
        self.ring = ring
        self.run = run
        self.stitched = False


class Connectivity:
    """The state of passes. cells: per fan its cells, where they are known."""

    def __init__(self, surface, cells, has_stitches):
        self.surface = surface
        self.cells = cells
        self.ages = []
        self.used = set()
        self.stitches = Stitches(surface) if has_stitches else None
        self.cuts = CountedCuts()
        self.count = self.v = self.flags = self.again = 0
        self.next = {}  # the order that gives new numbers
        self.last = None

    def added(self, fan):
        """A fan of a component."""
        self.ages.append(0)
        self._order_behind(self.last, fan)

    def _order_behind(self, v, fan):
        self.next[fan] = self.next.get(v)
        self.next[v] = fan
        if v == self.last:
            self.last = fan

    def take_order(self):
        """The fans in the order of their new numbers, which hold from now on."""
        order = []
        v = self.next[None]
        while v is not None:
            order.append(v)
            v = self.next[v]
        self.next = {}
        self.last = None
        for fan in range(len(order)):
            self._order_behind(self.last, fan)
        return order

    def begin_pass(self):
        self.used.clear()
        self.ages = [min(7, age + 1) for age in self.ages]
        self.count = len(self.ages)
        self.v = self.flags = self.again = 0

    def next_split(self, decoder):
        """The next split of the pass, made."""
        while True:
            v = self.v
            slots = self.surface.slots[v]
            valence = len(slots)
            unused = [c // 3 not in self.used for c in slots]
            free = min(valence - 1, sum(unused))
            if valence <= MOST_VALENCE and free > 0:
                if self._flag(decoder, v, valence, free):
                    return self._split(decoder, v, unused)
            self.v += 1
            self.again = 0
            if self.v >= self.count:
                raise ValueError("a pass ends early")

    def _flag(self, decoder, v, valence, free):
        bit = self.cuts.splits(decoder, self.again, self.ages[v], valence, free, self.flags)
        self.flags = (self.flags << 1 | bit) & 15
        return bit

    def _split(self, decoder, v, unused):
        self.again = 1
        start, length = self._run(decoder, v, unused)
        slots = self.surface.slots[v]
        run = [slots[(start + i) % len(slots)] for i in range(length)]
        split = Split(v, *self.surface.split(v, start, length), run)
        self.ages.append(0)
        self._order_behind(v, split.u)
        for x in [v] + split.ring:
            if x != OUTSIDE:
                self.ages[x] = 0
        self.used.update(c // 3 for c in run)
        self.used.update((split.left, split.right))
        if self.stitches:
            split.stitched = self.stitches.decode(decoder, split.u)
        else:
            self.surface.new_vertex(split.u)
        return split

    def _run(self, decoder, v, unused):
        """First slot and length of a run."""
        n = len(unused)
        ring = self.surface.ring(v)
        edges = [j for j in range(n) if unused[j - 1] and unused[j]]
        shapes = self._shapes(v, ring, unused, edges)
        edges.sort(key=lambda j: -shapes[j])
        if not edges or self.cuts.single(decoder, n, shapes[edges[0]]):
            return self._single(decoder, ring, unused), 1
        refused = 0
        while refused < len(edges) - 1:
            if self.cuts.seed(decoder, refused, shapes[edges[refused]], n):
                break
            refused += 1
        seed = edges[refused]
        candidates = set(edges[refused:])
        low = (seed - 1) % n
        length = 2
        extra = 4 + (refused > 0)
        while length < n - 1 and low in candidates and self._grows(decoder, 0, ring, low, shapes, length, extra):
            low = (low - 1) % n
            length += 1
            extra = int(refused > 0)
        w = self.surface.valence(ring[low])
        extra = 1 if w <= 5 else 2 if w == 6 else 3
        high = (seed + 1) % n
        while length < n - 1 and high in candidates and self._grows(decoder, 1, ring, high, shapes, length, extra):
            high = (high + 1) % n
            length += 1
        return low, length

    def _grows(self, decoder, side, ring, edge, shapes, length, extra):
        at = shapes[edge], self.surface.valence(ring[edge])
        return self.cuts.grows(decoder, side, at, len(ring), length, extra)

    def _single(self, decoder, ring, unused):
        slots = [j for j in range(len(ring)) if unused[j]]
        for j in slots[:-1]:
            first, second = ring[j], ring[(j + 1) % len(ring)]
            if self.cuts.slot(decoder, self.surface.valence(first), self.surface.valence(second)):
                return j
        return slots[-1]

    def _shapes(self, v, ring, unused, edges):
        """The shape of each edge that is a candidate."""
        n = len(ring)
        origin = self.cells[v]
        away = [None] * n
        size = 0
        for j in range(n):
            if ring[j] != OUTSIDE and (unused[j - 1] or unused[j]):
                away[j] = [x - o for x, o in zip(self.cells[ring[j]], origin)]
                for d in away[j]:
                    size |= abs(d)
        shift = max(0, size.bit_length() - 13)
        shapes = {}
        for j in edges:
            a, b, c = away[j - 1], away[j], away[(j + 1) % n]
            shapes[j] = 24
            if a is not None and b is not None and c is not None:
                length = sum((x >> shift) * (x >> shift) for x in b)
                across = sum(((x >> shift) - (y >> shift)) ** 2 for x, y in zip(a, c))
                shapes[j] = max(0, min(63, log8(length + 1) - log8(across + 1) + 32))
        return shapes
