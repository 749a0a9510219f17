"""Forms: how numbers of double precision and of wide types are told by float32 offsets."""

import struct

from .entropy import Context, Contexts, IntegerModel, to_int
from .lattice import LARGEST, float_bits

NORMAL = 0
MOST = struct.unpack("<d", struct.pack("<Q", 0x7FEFFFFFFFFFFFFF))[0]
SIGN = 1 << 63


def double_of(bits):
    return struct.unpack("<d", struct.pack("<Q", bits))[0]


def double_bits(x):
    return struct.unpack("<Q", struct.pack("<d", x))[0]


def finite(x):
    return max(-MOST, min(MOST, x))


def half_step(x):
    """Half the distance between float32 numbers of this size."""
    return 2.0 ** (max(1, float_bits(x) >> 23 & 255) - 150) / 2


class Form:
    """places is -1 for binary numbers. origins: whole counts, or binary numbers."""

    def __init__(self, decoder, integers, components):
        self.places = integers.unsigned(decoder) - 1
        self.exceptions = decoder.flag()
        self.whole = decoder.flag()
        self.zeros = decoder.raw(6) if self.places < 0 or self.exceptions else 0
        self.origins = [self._origin(decoder, integers) for _ in range(components)]
        self.scale = 1.0
        for _ in range(self.places):
            self.scale *= 10

    def _origin(self, decoder, integers):
        if not decoder.flag():
            return 0.0
        if self.places < 0:
            low = decoder.raw(32)
            return double_of(decoder.raw(32) << 32 | low)
        negative = decoder.flag()
        high = integers.unsigned(decoder)
        origin = float(high << 31 | integers.unsigned(decoder))
        return -origin if negative else origin

    def center(self, k, x):
        """The binary number that an offset tells."""
        origin = self.origins[k]
        if self.places >= 0:
            origin = origin / self.scale
        return finite(origin + x) if origin else x

    def nearest(self, x):
        """The units that an offset is closest to."""
        units = to_int(abs(x) * self.scale + 0.5)
        return -units if x < 0 else units

    def decimal(self, k, x, units):
        if units == 0 and self.origins[k] == 0:
            return x if x == 0 else 0.0
        return (self.origins[k] + units) / self.scale

    def told(self, k, x):
        """The number of an offset that tells all."""
        return self.center(k, x) if self.places < 0 else self.decimal(k, x, self.nearest(x))


class FormDecoder:
    """The numbers of a column group in the remainder, given their offsets."""

    def __init__(self, form):
        self.form = form
        self.exception = Context()
        self.same = Contexts()

    def decode(self, decoder, k, x):
        form = self.form
        if form.whole:
            return form.told(k, x)
        if form.places < 0 or form.exceptions and decoder.bit(self.exception):
            return self._binary(decoder, k, x)
        nearest = form.nearest(x)
        units = half_step(x) * form.scale
        if units < 0.25:
            return form.decimal(k, x, nearest)
        spread = int(min(units + 0.75, 1 << 29))
        return form.decimal(k, x, nearest - spread + decoder.below(2 * spread + 1))

    def _binary(self, decoder, k, x):
        form = self.form
        center = form.center(k, x)
        if decoder.bit(self.same[x != 0]):
            return center
        origin = form.origins[k] if form.places < 0 else form.origins[k] / form.scale
        margin = half_step(x) * (1 + 2.0**-20) + (abs(origin) + abs(center)) * 2.0**-51
        low = self._place(-MOST if x == -LARGEST else finite(center - margin))
        high = self._place(MOST if x == LARGEST else finite(center + margin))
        place = low + _up_to(decoder, high - low)
        if place < 0:
            return double_of(SIGN | -1 - place << form.zeros)
        return double_of(place << form.zeros)

    def _place(self, x):
        bits = double_bits(x)
        magnitude = (bits & ~SIGN) >> self.form.zeros
        return -1 - magnitude if bits & SIGN else magnitude


def _up_to(decoder, most):
    """A number from 0 to most."""
    if most < (1 << 31) - 1:
        return decoder.below(most + 1)
    high = decoder.below((most >> 32) + 1)
    return min(most, high << 32 | decoder.raw(32))


def read_forms(decoder, opening):
    """Reads what the opening says of numbers beyond float32 and 8 bits."""
    integers = IntegerModel()
    if decoder.flag():
        opening.position_form = Form(decoder, integers, 3)
    for channel in opening.channels:
        channel.type = decoder.raw(3)
        if channel.type > 1:
            if decoder.flag():
                channel.semantic = NORMAL
            channel.form = Form(decoder, integers, channel.components)
