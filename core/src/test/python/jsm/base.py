"""Components: those of the base, and those that come later."""

from .entropy import Context, Contexts

OPEN, GLUED, BOUNDARY = range(3)


class BaseDecoder:
    """Decodes components; numbers of fans are those of the surface."""

    def __init__(self, surface):
        self.surface = surface
        self.boundary = Context()
        self.new_tip = Context()
        self.closes = Contexts()

    def decode(self, decoder, faces, added):
        """Components of so many faces in all. added(fan, a, b, c) is told of each new fan."""
        return self._run(decoder, added, lambda count: count < faces)

    def decode_one(self, decoder, added):
        return self._run(decoder, added, lambda count: count == 0)

    def _run(self, decoder, added, more):
        self.first = len(self.surface.slots)
        self.added = added
        self.faces = []
        self.ends = []  # per half-edge its two fans
        self.state = []
        self.twins = {}  # open half-edges by their ends
        self.out = {}
        self.into = {}
        gate = 0
        while more(len(self.faces)):
            self._add_face([self._new(), self._new(), self._new()])
            while gate < len(self.state):
                if self.state[gate] == OPEN:
                    self._gate(decoder, gate)
                gate += 1
        self.surface.append(self.faces)
        return len(self.faces)

    def _new(self, *across):
        fan = self.surface.add_fan()
        self.added(fan, *across)
        return fan

    def _gate(self, decoder, gate):
        a, b = self.ends[gate]
        if decoder.bit(self.boundary):
            self.state[gate] = BOUNDARY
            return
        if decoder.bit(self.new_tip):
            tip = self._new(a, b, self.faces[gate // 3][(gate + 2) % 3])
        else:
            tip = self._known(decoder, a, b)
        self._add_face([b, a, tip])

    def _known(self, decoder, a, b):
        h = self.out.get(b)
        left = self.ends[h][1] if h is not None and self.state[h] == OPEN else None
        if left is not None and decoder.bit(self.closes[0]):
            return left
        h = self.into.get(a)
        right = self.ends[h][0] if h is not None and self.state[h] == OPEN else None
        if right is not None and right != left and decoder.bit(self.closes[2 if left is None else 1]):
            return right
        last = len(self.surface.slots) - 1
        return last - decoder.below(last + 1 - self.first)

    def _add_face(self, face):
        first = len(self.state)
        self.faces.append(face)
        self.ends += [(face[0], face[1]), (face[1], face[2]), (face[2], face[0])]
        self.state += [OPEN] * 3
        for h in range(first, first + 3):
            a, b = self.ends[h]
            if (b, a) in self.twins:
                self.state[h] = self.state[self.twins.pop((b, a))] = GLUED
            else:
                self.twins[a, b] = h
                self.out[a] = h
                self.into[b] = h
