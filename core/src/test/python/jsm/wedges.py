"""Materials of faces and wedges of corners, by reference to those around."""

from .channels import ChannelValues, NewValues
from .entropy import Contexts, IntegerModel
from .surface import after, before

RECENT = 64


class Wedges:
    """wedge_of: per corner its wedge; material_of: per real face; by_vertex: per vertex its wedges, in order."""

    def __init__(self, surface, opening):
        self.surface = surface
        self.has_materials = opening.has_materials
        self.channels = [ChannelValues(format) for format in opening.channels]
        self.new_values = [NewValues(values) for values in self.channels]
        self.wedge_of = {}
        self.material_of = {}
        self.by_vertex = {}
        self.count = 0
        self.near = Contexts()
        self.further = Contexts()
        self.material = IntegerModel()
        self.is_this = Contexts()
        self.continued = Contexts()
        self.new = Contexts()

    def _real(self, corner):
        return not self.surface.is_dummy(corner // 3)

    def _step(self, corner, steps):
        """The corner so many swings on about its vertex."""
        slots = self.surface.slots[self.surface.at[corner]]
        return slots[(slots.index(corner) + steps) % len(slots)]

    # components

    def component(self, decoder, first_face, faces):
        """Materials and wedges of the faces of the base, or of a component."""
        last = {}
        for face in range(first_face, first_face + faces):
            corners = range(3 * face, 3 * face + 3)
            known = [self._step(c, 1) // 3 for c in corners]
            known = [f for f in known if f < face and not self.surface.is_dummy(f)]
            near = known[0] if known else None
            self._decode_material(decoder, face, near, known[-1] if len(known) > 1 else None)
            if not self.channels:
                continue
            for c in corners:
                fan = self.surface.at[c]
                candidates = [self.wedge_of.get(self._step(c, steps)) for steps in (1, -1)]
                last[fan] = self._by_candidates(decoder, c, candidates + [last.get(fan)], 2)

    # splits

    def split(self, decoder, split):
        left, right = 3 * split.left, 3 * split.right
        faces = [left + 2] + split.run + [right + 1]  # corners of u
        v_wedges = [self.wedge_of.get(c) for c in split.run]  # as they were
        before_left, behind_right = self._step(left, -1), self._step(right, 1)
        if self._real(left):
            self._decode_material(decoder, left // 3, self._face(before_left), self._face(split.run[0]))
        if self._real(right):
            self._decode_material(decoder, right // 3, self._face(behind_right), self._face(split.run[-1]))
        if not self.channels:
            return
        wedge = self.wedge_of.get
        if self._real(left):
            self._by_sides(decoder, left, wedge(before_left), v_wedges[0])
            self._by_sides(decoder, left + 1, wedge(before(before_left)), wedge(after(split.run[0])))
        if self._real(right):
            self._by_sides(decoder, right, wedge(behind_right), v_wedges[-1])
            self._by_sides(decoder, right + 2, wedge(after(behind_right)), wedge(before(split.run[-1])))
        self._run(decoder, split.u, faces, [wedge(left)] + v_wedges + [wedge(right)])

    def _face(self, corner):
        return corner // 3 if self._real(corner) else None

    def _run(self, decoder, u, corners, v_wedges):
        """The wedges of u in these corners, given those of v there."""
        vertex = self.surface.vertex_of[u]
        known = []
        if len(self.surface.fans_of[vertex]) > 1:
            known = self._recall(vertex, [])
        last = None
        for i, c in enumerate(corners):
            if not self._real(c):
                continue
            wedge = None
            if last is not None:
                same_wedge = v_wedges[i] == v_wedges[last]
                same_material = self._material(c) == self._material(corners[last])
                if decoder.bit(self.continued[same_wedge, same_material]):
                    wedge = self.wedge_of[corners[last]]
                elif len(known) > 1:
                    wedge = self._known(decoder, 0, known)
            elif known:
                wedge = self._known(decoder, 1, known)
            if wedge is None:
                around = []
                for j in range(i, len(corners)):
                    if not self._real(corners[j]) or v_wedges[j] != v_wedges[i]:
                        break
                    around += self._others(corners[j])
                wedge = self._new_wedge(decoder, vertex, around)
                if len(known) < RECENT:
                    known.append(wedge)
            self.wedge_of[c] = wedge
            last = i

    def _material(self, corner):
        return self.material_of.get(corner // 3)

    # both

    def _decode_material(self, decoder, face, near, further):
        if not self.has_materials:
            return
        near = [] if near is None else [self.material_of[near]]
        further = [] if further is None else [self.material_of[further]]
        if near and decoder.bit(self.near["alone" if not further else further == near]):
            chosen = near[0]
        elif further and further != near and decoder.bit(self.further[0]):
            chosen = further[0]
        else:
            chosen = self.material.unsigned(decoder) - 1
        self.material_of[face] = chosen

    def _by_sides(self, decoder, corner, near, further):
        self._by_candidates(decoder, corner, [near, further], int(near != further))

    def _by_candidates(self, decoder, corner, wedges, kind):
        candidates = []
        for w in wedges:
            if w is not None and w not in candidates:
                candidates.append(w)
        vertex = self.surface.vertex_of[self.surface.at[corner]]
        wedge = None
        for i, candidate in enumerate(candidates):
            if decoder.bit(self.is_this[kind, len(candidates), i]):
                wedge = candidate
                break
        if wedge is None and len(self.surface.fans_of[vertex]) > 1:
            known = self._recall(vertex, candidates)
            if known:
                wedge = self._known(decoder, 2, known)
        if wedge is None:
            wedge = self._new_wedge(decoder, vertex, self._others(corner))
        self.wedge_of[corner] = wedge
        return wedge

    def _recall(self, vertex, candidates):
        wedges = [w for w in reversed(self.by_vertex.get(vertex, [])) if w not in candidates]
        return wedges[:RECENT]

    def _known(self, decoder, context, known):
        """One of the known wedges, or None for a new one."""
        if decoder.bit(self.new[context]):
            return None
        return known[decoder.below(len(known))]

    def _others(self, corner):
        """The wedges of the other corners of a face, as far as they have any."""
        wedges = [self.wedge_of.get(c) for c in (after(corner), before(corner))]
        return [w for w in wedges if w is not None]

    def _new_wedge(self, decoder, vertex, around):
        for values in self.new_values:
            values.decode(decoder, around)
        self.by_vertex.setdefault(vertex, []).append(self.count)
        self.count += 1
        return self.count - 1
