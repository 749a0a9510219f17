"""Splits: which vertices split, and with which runs of faces."""

from .cuts import Cuts, Edge
from .entropy import log8
from .surface import OUTSIDE, before
from .stitches import Stitches

MOST_VALENCE = 64
FEW = 6  # rings of more vertices do not tell what lies beyond their edges
UNKNOWN_SHAPE = 24


class Split:
    """A split: v, u, the ring of u without v; the faces; whether u is a further fan of a vertex.

    beyond: per edge of the ring of u, from the first to that behind v, the fan beyond it; empty where not known.
    """

    def __init__(self, v, u, left, right, ring, run, beyond):
        self.v = v
        self.u = u
        self.left = left
        self.right = right
        self.ring = ring
        self.run = run
        self.beyond = beyond
        self.stitched = False


class Connectivity:
    """The state of passes. cells: per fan its cells, where they are known."""

    def __init__(self, surface, cells, has_stitches):
        self.surface = surface
        self.cells = cells
        self.ages = []
        self.used = set()
        self.stitches = Stitches(surface) if has_stitches else None
        self.cuts = Cuts()
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
        beside = self.surface.ring(v)
        made = self.surface.split(v, start, length)
        beyond = self._beyond(run, made[-1], (beside[(start + length + 1) % len(beside)], beside[start - 1]))
        split = Split(v, *made, run, beyond)
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

    def _beyond(self, run, ring, beside_v):
        if len(ring) + 1 > FEW or OUTSIDE in ring:
            return []
        beyond = []
        for c in run:
            corner = before(c)
            slots = self.surface.slots[self.surface.at[corner]]
            beyond.append(self.surface.second(slots[(slots.index(corner) + 1) % len(slots)]))
        return beyond + list(beside_v)

    def _run(self, decoder, v, unused):
        """First slot and length of a run."""
        n = len(unused)
        ring = self.surface.ring(v)
        candidates = [j for j in range(n) if unused[j - 1] and unused[j]]
        edges = self._edges(v, ring, unused, candidates)
        candidates.sort(key=lambda j: -edges[j].shape)
        if not candidates or self.cuts.single(decoder, n, edges[candidates[0]].shape):
            return self._single(decoder, ring, unused), 1
        refused = 0
        while refused < len(candidates) - 1 and not self._begins(decoder, edges, candidates, refused):
            refused += 1
        seed = candidates[refused]
        candidates = set(candidates[refused:])

        def grows(side, edge, end):
            if length >= n - 1 or edge not in candidates:
                return 0
            beyond = edges[(edge + (1 if side else -1)) % n]
            return self.cuts.grows(decoder, side, length, extra, (n, edges[edge], beyond, edges[end]))

        low = (seed - 1) % n
        high = (seed + 1) % n
        length = 2
        extra = 4 + (refused > 0)
        while grows(0, low, high):
            low = (low - 1) % n
            length += 1
            extra = int(refused > 0)
        w = edges[low].valence
        extra = 1 if w <= 5 else 2 if w == 6 else 3
        while grows(1, high, low):
            high = (high + 1) % n
            length += 1
        return low, length

    def _begins(self, decoder, edges, candidates, refused):
        """Does the run begin at the next candidate?"""
        j = candidates[refused]
        gap = (edges[j].shape - edges[candidates[refused + 1]].shape) >> 1
        n = len(edges)
        at = n, edges[j], edges[j - 1], edges[(j + 1) % n]
        return self.cuts.seed(decoder, refused, len(candidates) - refused, max(0, min(15, gap)), at)

    def _single(self, decoder, ring, unused):
        slots = [j for j in range(len(ring)) if unused[j]]
        for j in slots[:-1]:
            first, second = ring[j], ring[(j + 1) % len(ring)]
            if self.cuts.slot(decoder, self.surface.valence(first), self.surface.valence(second)):
                return j
        return slots[-1]

    def _edges(self, v, ring, unused, candidates):
        """What is known of each edge."""
        n = len(ring)
        away = self._away(v, ring, unused)
        squares = [sum(x * x for x in d) if d else 0 for d in away]
        known = [q for q in squares if q]
        usual = log8(sum(q >> 6 for q in known) // len(known) + 1) + 48 if known else 0
        shapes = dict.fromkeys(candidates, UNKNOWN_SHAPE)
        for j in candidates:
            a, b, c = away[j - 1], away[j], away[(j + 1) % n]
            if a and b and c:
                across = sum((x - y) ** 2 for x, y in zip(a, c))
                shapes[j] = max(0, min(63, log8(squares[j] + 1) - log8(across + 1) + 32))
        edges = []
        for j, q in enumerate(squares):
            length = max(0, min(7, (3 * (log8(q + 1) - usual) >> 4) + 4)) if q else 3
            edges.append(Edge(shapes.get(j, UNKNOWN_SHAPE), length, self.surface.valence(ring[j])))
        return edges

    def _away(self, v, ring, unused):
        """Per neighbour its coordinates from v, in units in which the largest has 13 bits; None where not known."""
        away = [None] * len(ring)
        size = 0
        for j, neighbour in enumerate(ring):
            if neighbour != OUTSIDE and (unused[j - 1] or unused[j]):
                away[j] = [x - o for x, o in zip(self.cells[neighbour], self.cells[v])]
                for d in away[j]:
                    size |= abs(d)
        shift = max(0, size.bit_length() - 13)
        return [d and [x >> shift for x in d] for d in away]
