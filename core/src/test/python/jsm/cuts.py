"""How likely the decisions are that a split is made of. Each decodes one of them, given what is known."""

from .entropy import Contexts


class CountedCuts:
    """All statistics are counted, from one half on."""

    def __init__(self):
        self.splits_a = Contexts()
        self.splits_b = Contexts()
        self.singles = Contexts()
        self.slots = Contexts()
        self.seeds = Contexts()
        self.grow_a = Contexts()
        self.grow_b = Contexts()

    def splits(self, decoder, again, age, valence, free, flags):
        """Does a vertex split (again)? flags: the last four such bits."""
        by = min(12, valence), min(12, free)
        return decoder.bit2(self.splits_a[again, by, flags], self.splits_b[again, age, by])

    def single(self, decoder, valence, shape):
        """Is the run a single face? shape: that of the best edge."""
        return decoder.bit(self.singles[min(12, valence), shape // 2])

    def slot(self, decoder, first, second):
        """Is it this face? first, second: the valences of its neighbours."""
        return decoder.bit(self.slots[min(7, first), min(7, second)])

    def seed(self, decoder, refused, shape, valence):
        return decoder.bit(self.seeds[min(6, refused), shape, min(12, valence)])

    def grows(self, decoder, side, edge, valence, faces, extra):
        """Does the run grow over an edge? edge: the shape, and the valence at the end."""
        shape, end = edge
        end = max(0, min(8, end) - 3)
        faces = min(7, faces)
        a = self.grow_a[side, end, shape // 4, faces, extra]
        b = self.grow_b[side, min(12, valence), faces, end, shape // 8]
        return decoder.bit2(a, b)
