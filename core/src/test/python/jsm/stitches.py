"""Stitches: splits that make further fans of vertices that are there."""

from .entropy import Contexts
from .surface import OUTSIDE

MOST_FANS = 8
MOST_FACES = 65
MOST_STEPS = 3
MOST_CANDIDATES = 48


class Stitches:
    def __init__(self, surface):
        self.surface = surface
        self.stitched = Contexts()
        self.candidate = Contexts()

    def decode(self, decoder, u):
        """Decodes which vertex u is of, and whether that was there."""
        surface = self.surface
        p, q = self._ahead(u), self._back(u)
        found, both = self._candidates(p, q)
        if p is None:
            context = 0
        elif both:
            context = 4
        else:
            context = 1 + sum(len(surface.fans_of[surface.vertex_of[x]]) > 1 for x in (p, q))
        if not decoder.bit(self.stitched[context]):
            surface.new_vertex(u)
            return False
        refused = 0
        for vertex in both + [x for x in found if x not in both]:
            if decoder.bit(self.candidate[vertex in both, min(7, refused)]):
                break
            refused += 1
        else:
            vertex = decoder.below(len(surface.fans_of))
        surface.name(u, vertex)
        return True

    def _ahead(self, fan, most=None):
        """The fan after this one along its border, or None."""
        for c in self.surface.slots[fan][:most]:
            if self.surface.neighbour(c) == OUTSIDE:
                return self.surface.second(c)
        return None

    def _back(self, fan, most=None):
        for c in self.surface.slots[fan][:most]:
            if self.surface.second(c) == OUTSIDE:
                return self.surface.neighbour(c)
        return None

    def _candidates(self, p, q):
        """Vertices in the order in which they are found, and those of them found from both sides."""
        if p is None:
            return [], []
        surface = self.surface
        ends = {surface.vertex_of[p], surface.vertex_of[q]}
        found = []
        sides = {}
        for side, start in enumerate((p, q)):
            fans = surface.fans_of[surface.vertex_of[start]]
            if len(fans) < 2:
                continue
            for fan in fans[:MOST_FANS]:
                if fan == start or self._ahead(fan, MOST_FACES) is None:
                    continue
                for step in (self._ahead, self._back):
                    self._walk(fan, step, ends, found, sides, side)
        return found, [v for v in found if len(sides[v]) == 2]

    def _walk(self, fan, step, ends, found, sides, side):
        for _ in range(MOST_STEPS):
            fan = step(fan)
            if fan is None or fan == len(self.surface.vertex_of):
                return
            vertex = self.surface.vertex_of[fan]
            if vertex in ends:
                return
            if vertex not in sides:
                if len(found) == MOST_CANDIDATES:
                    return
                found.append(vertex)
            sides.setdefault(vertex, set()).add(side)
