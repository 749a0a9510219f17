"""Forms: how numbers of double precision and of wide types become float32."""

from .entropy import IntegerModel


class Form:
    """places is -1 for binary numbers; origins: whole counts, or the 64 bits of binary ones."""

    def __init__(self, places, exceptions, whole, zeros, origins):
        self.places = places
        self.exceptions = exceptions
        self.whole = whole
        self.zeros = zeros
        self.origins = origins

    @staticmethod
    def read(decoder, integers, components):
        places = integers.unsigned(decoder) - 1
        exceptions = decoder.flag()
        whole = decoder.flag()
        zeros = decoder.raw(6) if places < 0 or exceptions else 0
        origins = []
        for _ in range(components):
            origin = 0
            if decoder.flag():
                if places < 0:
                    origin = decoder.raw(32)
                    origin |= decoder.raw(32) << 32
                else:
                    negative = decoder.flag()
                    high = integers.unsigned(decoder)
                    origin = high << 31 | integers.unsigned(decoder)
                    origin = -origin if negative else origin
            origins.append(origin)
        return Form(places, exceptions, whole, zeros, origins)


def read_forms(decoder, opening):
    """Marks what the opening says of numbers beyond float32 and 8 bits."""
    integers = IntegerModel()
    if decoder.flag():
        opening.position_form = Form.read(decoder, integers, 3)
    for channel in opening.channels:
        channel.type = decoder.raw(3)
        if channel.type > 1:
            channel.of_normals = decoder.flag()
            channel.form = Form.read(decoder, integers, channel.components)
            if channel.of_normals and channel.form.whole:
                channel.coded_semantic = 3
