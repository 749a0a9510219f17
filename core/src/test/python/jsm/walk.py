"""The faces of a wedge in their order about its vertex, and the order of wedges in attribute sweeps."""

from .surface import OUTSIDE, after, before


class Walks:
    def __init__(self, surface, wedges):
        self.surface = surface
        self.wedge_of = wedges.wedge_of
        self.count = wedges.count
        self.place = {}  # corner: its slot
        for slots in surface.slots:
            for j, c in enumerate(slots):
                self.place[c] = j
        self.corners = [c for f in range(surface.faces()) if not surface.is_dummy(f) for c in range(3 * f, 3 * f + 3)]
        self.first = {}
        for c in self.corners:
            w = self.wedge_of[c]
            if w not in self.first or self.wedge_of.get(self.swing(c, -1)) != w:
                self.first[w] = c

    def swing(self, corner, steps=1):
        slots = self.surface.slots[self.surface.at[corner]]
        return slots[(self.place[corner] + steps) % len(slots)]

    def walk(self, wedge):
        """The corners of a wedge's faces by swings, and whether they close a ring."""
        first = self.first.get(wedge)
        corners = []
        c = first
        while c is not None:
            corners.append(c)
            c = self.swing(c)
            if c == first:
                return corners, True
            if self.wedge_of.get(c) != wedge:
                return corners, False
        return corners, False

    def behind(self, corner):
        """The corner at the tip of the face behind, and its wedge, if a and b have their wedges there."""
        b = self.swing(before(corner))
        a = after(b)
        there = self.wedge_of.get(a), self.wedge_of.get(b)
        if there != (self.wedge_of[after(corner)], self.wedge_of[before(corner)]):
            return None
        return before(b)

    def order(self, has_normals):
        order = self._flood()
        met = set(order)
        if has_normals:
            early = self._early()
            order = [w for w in order if w in early] + [w for w in order if w not in early]
        return order + [w for w in range(self.count) if w not in met]

    def _flood(self):
        order = []
        met = set()
        queued = set()
        for c in self.corners[::3]:
            if c in queued:
                continue
            queue = [c]
            queued.add(c)
            for face in queue:
                for corner in range(face, face + 3):
                    w = self.wedge_of[corner]
                    if w not in met:
                        met.add(w)
                        order.append(w)
                    reached = self.swing(corner) // 3 * 3
                    if reached not in queued and not self.surface.is_dummy(reached // 3):
                        queued.add(reached)
                        queue.append(reached)
        return order

    def _early(self):
        """The wedges that do not come last."""
        surface = self.surface
        early = set()
        for c in self.corners:
            w = self.wedge_of[c]
            beside = surface.neighbour(c)
            lower = beside != OUTSIDE and surface.valence(surface.at[c]) < surface.valence(beside)
            if self.wedge_of.get(self.swing(c)) != w or not lower:
                early.add(w)
        return early
