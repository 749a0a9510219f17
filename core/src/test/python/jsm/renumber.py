"""New numbers of vertices and faces, before passes of large meshes."""

from .surface import OUTSIDE

LEAST = 8000
GROWTH = 1.9


class Renumbering:
    def __init__(self, decoder):
        self.decoder = decoder
        self.numbered = 0
        self.begun = False

    def begin_pass(self):
        surface = self.decoder.surface
        fans = len(surface.slots)
        if self.begun and fans >= LEAST and fans > GROWTH * self.numbered and not self.decoder.opening.stitches:
            self._renumber()
            self.numbered = fans
        self.begun = True

    def _renumber(self):
        decoder = self.decoder
        surface = decoder.surface
        old_vertices = decoder.connectivity.take_order()
        vertex = {old: new for new, old in enumerate(old_vertices)}
        vertex[OUTSIDE] = OUTSIDE
        named = [[vertex[v] for v in surface.at[3 * f : 3 * f + 3]] for f in range(surface.faces())]
        old_faces = sorted(range(len(named)), key=lambda f: min(v for v in named[f] if v != OUTSIDE))
        face = {old: new for new, old in enumerate(old_faces)}

        def corner(c):
            return 3 * face[c // 3] + c % 3

        surface.at = [v for f in old_faces for v in named[f]]
        surface.slots = [[corner(c) for c in surface.slots[v]] for v in old_vertices]
        positions = decoder.positions
        for rows in (positions.cells, positions.tags, positions.bits, decoder.connectivity.ages):
            rows[:] = [rows[v] for v in old_vertices]
        wedges = decoder.wedges
        wedges.wedge_of = {corner(c): w for c, w in wedges.wedge_of.items()}
        wedges.material_of = {face[f]: m for f, m in wedges.material_of.items()}
        wedges.by_vertex = {vertex[v]: w for v, w in wedges.by_vertex.items()}
