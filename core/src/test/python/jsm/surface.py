"""The mesh under decoding: corners in faces, slots about fan vertices, and which vertex a fan is of."""

OUTSIDE = -1


class Surface:
    def __init__(self):
        self.at = []  # fan vertex of each corner 3 · face + 0, 1, 2
        self.slots = []  # per fan vertex its corners, in the order of swings from its first corner
        self.vertex_of = []
        self.fans_of = []  # per vertex its fans: the first one, then the others, last one first

    def faces(self):
        return len(self.at) // 3

    def is_dummy(self, face):
        return OUTSIDE in self.at[3 * face : 3 * face + 3]

    def neighbour(self, corner):
        """The neighbour at the edge before a slot: p of (v, p, q)."""
        return self.at[after(corner)]

    def second(self, corner):
        """q of (v, p, q)."""
        return self.at[before(corner)]

    def ring(self, v):
        return [self.neighbour(c) for c in self.slots[v]]

    def valence(self, v):
        """The faces of a vertex, dummy ones too; 6 for outside."""
        return 6 if v == OUTSIDE else len(self.slots[v])

    def add_fan(self):
        self.slots.append(None)
        return len(self.slots) - 1

    def new_vertex(self, fan):
        self.name(fan, len(self.fans_of))

    def name(self, fan, vertex):
        """Says which vertex a fan is of; the next one there is not yet, or one that gets a further fan."""
        if len(self.vertex_of) != fan:
            raise ValueError("fans get vertices in order")
        self.vertex_of.append(vertex)
        if vertex == len(self.fans_of):
            self.fans_of.append([fan])
        else:
            self.fans_of[vertex].insert(1, fan)

    def append(self, faces):
        """Adds real faces over fans without slots, then the dummy faces behind their open half-edges."""
        first = self.faces()
        for face in faces:
            self.at.extend(face)
        edges = {}
        for f in faces:
            for j in range(3):
                edges[f[j], f[(j + 1) % 3]] = True
        for f in faces:
            for j in range(3):
                a, b = f[j], f[(j + 1) % 3]
                if (b, a) not in edges:
                    self.at.extend((b, a, OUTSIDE))
        leaving = {}
        for c in range(3 * first, len(self.at)):
            if self.at[c] != OUTSIDE:
                leaving[self.at[c], self.neighbour(c)] = c
        for c in range(3 * first, len(self.at)):
            v = self.at[c]
            if v == OUTSIDE or self.slots[v] is not None:
                continue
            walk = [c]
            while True:
                following = leaving[v, self.second(walk[-1])]
                if following == c:
                    break
                walk.append(following)
            self.slots[v] = walk

    def split(self, v, start, length):
        """Gives a run of slots to a new vertex. Returns it, the two new faces and its ring without v."""
        slots = self.slots[v]
        n = len(slots)
        run = [slots[(start + i) % n] for i in range(length)]
        rest = [slots[(start + i) % n] for i in range(length, n)]
        ring = [self.neighbour(c) for c in run] + [self.second(run[-1])]
        u = self.add_fan()
        for c in run:
            self.at[c] = u
        left = self.faces()
        right = left + 1
        self.at.extend((v, ring[0], u, v, u, ring[-1]))
        self.slots[v] = [3 * left, 3 * right] + rest
        self.slots[u] = run + [3 * right + 1, 3 * left + 2]
        if ring[0] != OUTSIDE:
            self._insert(ring[0], after(run[0]), 3 * left + 1)
        if ring[-1] != OUTSIDE:
            self._insert(ring[-1], after(rest[0]), 3 * right + 2)
        return u, left, right, ring

    def _insert(self, x, behind, corner):
        slots = self.slots[x]
        slots.insert(slots.index(behind) + 1, corner)


def after(corner):
    return corner - 2 if corner % 3 == 2 else corner + 1


def before(corner):
    return corner + 2 if corner % 3 == 0 else corner - 1
