"""What float32 and 8 bits do not hold: wide numbers, and channels of faces."""

import struct

from .entropy import Context, Contexts, IntegerModel
from .forms import FormDecoder, double_bits
from .lattice import float_bits, float_of
from .surface import OUTSIDE
from .texts import TextModel

FLOAT32, UINT8, INT8, INT16, UINT16, INT32, UINT32, FLOAT64 = range(8)
RANGES = {
    UINT8: (0, 255),
    INT8: (-128, 127),
    INT16: (-32768, 32767),
    UINT16: (0, 65535),
    INT32: (-(1 << 31), (1 << 31) - 1),
    UINT32: (0, (1 << 32) - 1),
}


def words(type, x):
    """A number as meshSha256 takes it: one number of 32 bits, or two."""
    if type == FLOAT64:
        bits = double_bits(x)
        return [bits & 0xFFFFFFFF, bits >> 32]
    if type == FLOAT32:
        return [float_bits(x)]
    low, high = RANGES[type]
    return [max(low, min(high, int(x + 0.5 if x >= 0 else x - 0.5))) & 0xFFFFFFFF]


def is_wide(x):
    """Is this no float32 number?"""
    try:
        return struct.unpack("<f", struct.pack("<f", x))[0] != x
    except OverflowError:
        return True


class FaceChannel:
    """rows: per face its words, or its label."""

    def __init__(self, name, components, type):
        self.name = name
        self.components = components
        self.type = type
        self.labels = []
        self.rows = []


class Remainder:
    """positions: per vertex three numbers; channels: by index, per wedge the words of its numbers."""

    def __init__(self, stream, decoder, rest, shown_positions, shown_values):
        opening = decoder.opening
        self.stream = stream
        self.positions = None
        if opening.position_form:
            column = FormDecoder(opening.position_form)
            self.positions = [
                [column.decode(stream, k, float_of(bits)) for k, bits in enumerate(row)] for row in shown_positions
            ]
        self.channels = {}
        for i, values in enumerate(decoder.wedges.channels):
            if values.format.form:
                self.channels[i] = self._channel(values, shown_values[i])
        self.face_channels = []
        for name, components, type in rest.face_channels:
            channel = FaceChannel(name, components, type)
            FaceValues(stream, decoder.surface, channel)
            self.face_channels.append(channel)

    def _channel(self, values, shown):
        column = FormDecoder(values.format.form)
        rows = []
        for wedge, row in enumerate(shown):
            numbers = []
            if not values.absent[wedge]:
                for k, bits in enumerate(row):
                    numbers += words(values.format.type, column.decode(self.stream, k, float_of(bits)))
            rows.append(numbers)
        return rows


class FaceValues:
    """Decodes the values of a channel of faces, face after face."""

    def __init__(self, stream, surface, channel):
        self.stream = stream
        self.channel = channel
        self.numbers = IntegerModel()
        self.same = Contexts()
        self.other = Context()
        self.small = Context()
        self.before = 0
        texts = TextModel()
        for _ in range(self.numbers.unsigned(stream, 0)):
            channel.labels.append(texts.text(stream))
        last = {}
        for f in range(surface.faces()):
            face = surface.at[3 * f : 3 * f + 3]
            if OUTSIDE in face:
                continue
            vertices = [surface.vertex_of[v] for v in face]
            row = self._face([last[v] for v in vertices if v in last])
            channel.rows.append(row)
            for v in vertices:
                last[v] = row

    def _face(self, near):
        if near:
            votes = [near.count(row) for row in near]
            likely = near[votes.index(max(votes))]
            if self.stream.bit(self.same[max(votes)]):
                return likely
            others = [row for row in near if row != likely]
            if others and self.stream.bit(self.other):
                return others[0]
        if self.channel.labels:
            return [self.stream.below(len(self.channel.labels))]
        count = self.channel.components * (2 if self.channel.type == FLOAT64 else 1)
        return [self._word() for _ in range(count)]

    def _word(self):
        type = self.channel.type
        if type in (FLOAT32, FLOAT64):
            return self.stream.raw(32)
        if type in (INT32, UINT32):
            if self.stream.bit(self.small):
                return self.numbers.unsigned(self.stream, 1)
            return self.stream.raw(32)
        low, high = RANGES[type]
        self.before = max(low, min(high, self.before + self.numbers.signed(self.stream, 1)))
        return self.before & 0xFFFFFFFF
