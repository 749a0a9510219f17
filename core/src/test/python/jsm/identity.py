"""meshSha256 of what was decoded."""

import hashlib
import struct

from .entropy import RangeDecoder
from .lattice import float_bits, float_of
from .remainder import FLOAT32, FLOAT64, Remainder, is_wide, words

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
        self.formats = [channel.format for channel in self.wedges.channels]
        self.order = sorted(range(len(self.formats)), key=lambda i: self.formats[i].semantic)
        surface = self.surface
        self.faces = [f for f in range(surface.faces()) if not surface.is_dummy(f)]
        self.positions = [tuple(shown_position(self.opening, bits)) for bits in decoder.positions.bits]
        self.values = [self._shown(channel) for channel in self.wedges.channels]
        self.face_channels = []
        self.double = False
        if self.opening.features >> 2 & 1:
            self._add_remainder()

    @staticmethod
    def _shown(channel):
        """Per wedge the values that are shown."""
        if not channel.format.turned:
            return channel.values
        return [[row[0], float_bits(1 - float_of(row[1]))] + row[2:] for row in channel.values]

    def _add_remainder(self):
        decoder = self.decoder
        stream = RangeDecoder(decoder.remainder)
        remainder = Remainder(stream, decoder, decoder.rest, self.positions, self.values)
        for i, rows in remainder.channels.items():
            self.values[i] = rows
        self.face_channels = sorted(remainder.face_channels, key=lambda c: utf16(c.name))
        if remainder.positions:
            used = {self.surface.vertex_of[v] for f in self.faces for v in self.surface.at[3 * f : 3 * f + 3]}
            self.double = any(is_wide(x) for v in used for x in remainder.positions[v])
            type = FLOAT64 if self.double else FLOAT32
            self.positions = [tuple(w for x in row for w in words(type, x)) for row in remainder.positions]

    def sha256(self):
        sink = Sink()
        if self.double:
            sink.put(-64)
        sink.put(len(self.faces), len(self.formats))
        for i in self.order:
            sink.put(self.formats[i].semantic, self.formats[i].components, self.formats[i].type)
        ranks = self._put_tuples(sink)
        columns = [self._put_materials(sink)]
        if self.face_channels:
            sink.put(len(self.face_channels))
            columns += [self._put_face_channel(sink, channel) for channel in self.face_channels]
        rows = []
        for i, face in enumerate(ranks):
            row = min(face[j:] + face[:j] for j in range(3))
            for column in columns:
                row = row + column[i]
            rows.append(row)
        for row in sorted(rows):
            sink.put(*row)
        return sink.sha256.hexdigest()

    def _put_tuples(self, sink):
        """Writes the tuples; returns the ranks of each face's corners."""
        tuples = [[self._tuple(3 * f + j) for j in range(3)] for f in self.faces]
        distinct = sorted({t for face in tuples for t in face})
        rank = {t: i for i, t in enumerate(distinct)}
        sink.put(len(distinct))
        for t in distinct:
            sink.put(*t)
        return [[rank[t] for t in face] for face in tuples]

    def _tuple(self, corner):
        row = self.positions[self.surface.vertex_of[self.surface.at[corner]]]
        for i in self.order:
            wedge = self.wedges.wedge_of[corner]
            if self.wedges.channels[i].absent[wedge]:
                width = 2 if self.formats[i].type == FLOAT64 else 1
                row += (0,) * (1 + width * self.formats[i].components)
            else:
                row += (1,) + tuple(self.values[i][wedge])
        return row

    def _put_materials(self, sink):
        """Writes the materials; returns the rank of each face's."""
        texts = self.opening.materials
        of_faces = [self.wedges.material_of.get(f, -1) for f in self.faces]
        rank = self._put_texts(sink, {texts[m] for m in of_faces if m >= 0})
        return [[NONE if m < 0 else rank[texts[m]]] for m in of_faces]

    def _put_face_channel(self, sink, channel):
        """Writes what there is of a channel of faces; returns the numbers of each face."""
        sink.put_text(channel.name)
        sink.put(channel.components, channel.type)
        labels = channel.labels
        rank = self._put_texts(sink, {labels[row[0]] for row in channel.rows} if labels else ())
        return [[rank[labels[row[0]]]] for row in channel.rows] if labels else channel.rows

    @staticmethod
    def _put_texts(sink, texts):
        distinct = sorted(texts, key=utf16)
        sink.put(len(distinct))
        for text in distinct:
            sink.put_text(text)
        return {text: i for i, text in enumerate(distinct)}


def mesh_sha256(decoder):
    return Identity(decoder).sha256()


def model_sha256(archive, mesh):
    """modelSha256 of a mesh and of the archive's images."""
    lines = []
    for (paths, _), sha256 in zip(archive.opening.images, archive.rest.image_sha256):
        for path in paths:
            lines.append((utf16(path), sha256, "image %s %d %s\n" % (sha256, len(path.encode()), path)))
    text = "mesh %s\n" % mesh + "".join(line for _, _, line in sorted(lines))
    return hashlib.sha256(text.encode()).hexdigest()
