"""meshSha256 of what was decoded."""

import hashlib
import struct

from .lattice import float_bits, float_of
from .surface import OUTSIDE

FLOAT64 = 7
NONE = 0xFFFFFFFF


def shown_position(opening, bits):
    """What is shown of a coded position, as bits."""
    if opening.scale is not None:
        factor = float_of(opening.scale)
        return [float_bits(float_of(b) * factor) for b in bits]
    if opening.offsets is not None:
        return [float_bits(float_of(b) + float_of(o)) for b, o in zip(bits, opening.offsets)]
    return bits


def utf16(text):
    """By this texts are sorted."""
    return text.encode("utf-16-be")


class Sink:
    def __init__(self):
        self.sha256 = hashlib.sha256()

    def put(self, *numbers):
        self.sha256.update(struct.pack("<%dI" % len(numbers), *(n & 0xFFFFFFFF for n in numbers)))

    def put_text(self, text):
        data = text.encode()
        self.put(len(data))
        self.sha256.update(data)


class Identity:
    def __init__(self, decoder):
        self.decoder = decoder
        self.opening = decoder.opening
        self.surface = decoder.surface
        self.wedges = decoder.wedges
        self.channels = sorted(self.wedges.channels, key=lambda c: c.format.semantic)
        surface = self.surface
        self.faces = [f for f in range(surface.faces()) if not surface.is_dummy(f)]

    def sha256(self):
        sink = Sink()
        sink.put(len(self.faces), len(self.channels))
        for channel in self.channels:
            sink.put(channel.format.semantic, channel.components, channel.format.type)
        ranks = self._put_tuples(sink)
        materials = self._put_materials(sink)
        rows = []
        for f, face in zip(self.faces, ranks):
            rows.append(min(face[i:] + face[:i] for i in range(3)) + [materials[f]])
        for row in sorted(rows):
            sink.put(*row)
        return sink.sha256.hexdigest()

    def _put_tuples(self, sink):
        """Writes the tuples; returns the ranks of each face's corners."""
        positions = [tuple(shown_position(self.opening, bits)) for bits in self.decoder.positions.bits]
        tuples = [[self._tuple(3 * f + j, positions) for j in range(3)] for f in self.faces]
        distinct = sorted({t for face in tuples for t in face})
        rank = {t: i for i, t in enumerate(distinct)}
        sink.put(len(distinct))
        for t in distinct:
            sink.put(*t)
        return [[rank[t] for t in face] for face in tuples]

    def _tuple(self, corner, positions):
        row = positions[self.surface.vertex_of[self.surface.at[corner]]]
        for channel in self.channels:
            wedge = self.wedges.wedge_of[corner]
            if channel.absent[wedge]:
                row += (0,) * (1 + channel.components)
            else:
                row += (1,) + tuple(self._values(channel, wedge))
        return row

    def _values(self, channel, wedge):
        values = list(channel.values[wedge])
        if channel.format.turned:
            values[1] = float_bits(1 - float_of(values[1]))
        return values

    def _put_materials(self, sink):
        """Writes the materials; returns the rank of each face's."""
        texts = self.opening.materials
        of_face = {f: self.wedges.material_of.get(f, -1) for f in self.faces}
        distinct = sorted({texts[m] for m in of_face.values() if m >= 0}, key=utf16)
        sink.put(len(distinct))
        for text in distinct:
            sink.put_text(text)
        rank = {text: i for i, text in enumerate(distinct)}
        return {f: NONE if m < 0 else rank[texts[m]] for f, m in of_face.items()}


def mesh_sha256(decoder):
    return Identity(decoder).sha256()
