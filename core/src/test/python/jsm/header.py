"""The header: opening and rest."""

from . import forms
from .entropy import IntegerModel
from .index import Index
from .lattice import Lattice
from .texts import TextModel

FLOAT32, UINT8 = 0, 1
NORMAL = 0


def identity(decoder):
    """A SHA-256 in hexadecimal."""
    return "".join("%x" % decoder.raw(4) for _ in range(64))


class ChannelFormat:
    """What the opening says of a channel."""

    def __init__(self, decoder, integers, texts):
        self.semantic = decoder.raw(2)
        self.name = texts.text(decoder)
        self.components = decoder.raw(2) + 1
        self.bytes = decoder.flag()
        self.type = UINT8 if self.bytes else FLOAT32
        self.may_be_absent = decoder.flag()
        self.lattice = None if self.bytes else Lattice.read(decoder, integers)
        self.follow = self.shift = self.weights = self.unit = self.turned = 0
        self.normals = False
        self.form = None
        if self.bytes:
            self.follow = decoder.flag()
            self.shift = decoder.raw(3)
        elif self.semantic == NORMAL and self.components == 3:
            self.normals = True
            self.weights = decoder.raw(2)
            self.unit = decoder.flag()
        else:
            self.shift = integers.unsigned(decoder)
            if self.components > 1:
                self.turned = decoder.flag()


class Opening:
    def __init__(self, decoder, features):
        self.features = features
        self.late_components = features >> 1 & 1
        self.further = IntegerModel().unsigned(decoder) if features >> 5 & 1 else 0
        if self.further & ~1:
            raise ValueError("a feature that is not known: %#x" % self.further)
        integers = IntegerModel()
        self.texts = TextModel()
        self.lattice = Lattice.read(decoder, integers)
        self.scale = self.offsets = self.mirror_axis = None
        self.mirror_sum = 0
        if decoder.flag():
            if decoder.flag():
                self.scale = decoder.number()
            else:
                self.offsets = [decoder.number() for _ in range(3)]
        if decoder.flag():
            self.mirror_axis = decoder.raw(2)
            if decoder.flag():
                self.mirror_sum = decoder.number()
        count = integers.unsigned(decoder)
        self.channels = [ChannelFormat(decoder, integers, self.texts) for _ in range(count)]
        self.has_materials = integers.unsigned(decoder) > 0
        self.stitches = decoder.flag()
        self.dense = decoder.flag()
        self.box_bits = decoder.raw(5)
        box = IntegerModel()
        self.box_low = [0] * 3
        self.box_size = [0] * 3
        for axis in range(3):
            self.box_low[axis] = box.signed(decoder)
            self.box_size[axis] = decoder.raw(6)
        self.position_form = None
        if features >> 2 & 1:
            forms.read_forms(decoder, self)
        self.counts = IntegerModel()
        self.materials = [self._material(decoder) for _ in range(self.counts.unsigned(decoder))]
        self.images = [self._image(decoder) for _ in range(self.counts.unsigned(decoder))]
        self.index = Index(self)
        self.index.read_base(decoder)
        self.index.read_rows(decoder)
        self.rest_bytes = IntegerModel().unsigned(decoder)

    def _text(self, decoder):
        return self.texts.text(decoder)

    def _material(self, decoder):
        """The text of a material, as meshSha256 takes it."""
        text = self._text(decoder) + "\n"
        for _ in range(self.counts.unsigned(decoder)):
            text += self._text(decoder)
            for _ in range(self.counts.unsigned(decoder)):
                text += " %x" % decoder.number()
            text += "\n"
        text += "\n"
        for _ in range(self.counts.unsigned(decoder)):
            text += self._text(decoder)
            text += " " + self._text(decoder) + "\n"
        if decoder.flag():
            text += self._text(decoder) + "\n"
        return text

    def _image(self, decoder):
        paths = [self._text(decoder) for _ in range(self.counts.unsigned(decoder) + 1)]
        return paths, self.counts.unsigned(decoder)


class Rest:
    def __init__(self, decoder, opening):
        counts = opening.counts
        self.vertices = counts.unsigned(decoder)
        self.faces = 2 * self.vertices - counts.signed(decoder)
        self.wedges = self.vertices + counts.unsigned(decoder)
        self.mesh_sha256 = identity(decoder)
        self.bounds = [decoder.number() for _ in range(6)]
        self.levels = self._levels(decoder, counts)
        self.face_channels = []
        if opening.features >> 2 & 1:
            for _ in range(counts.unsigned(decoder)):
                name = opening.texts.text(decoder)
                components = decoder.raw(2) + 1
                self.face_channels.append((name, components, decoder.raw(3)))
        self.image_sha256 = [identity(decoder) for _ in opening.images]
        self.source = opening.texts.text(decoder)
        note_counts = IntegerModel()
        texts = TextModel()
        self.notes = []
        for _ in range(note_counts.unsigned(decoder)):
            kind = decoder.raw(2)
            warning = decoder.flag()
            count = note_counts.unsigned(decoder)
            sentence = texts.text(decoder)
            self.notes.append((kind, warning, count, sentence, texts.text(decoder)))
        opening.index.read_rows(decoder)
        if opening.further & 1:
            opening.index.read_quantiles(decoder)

    @staticmethod
    def _levels(decoder, counts):
        bits = 0x3F800000
        levels = []
        for _ in range(counts.unsigned(decoder)):
            if decoder.flag():
                bits += counts.signed(decoder) << 23
            else:
                bits = decoder.number()
            levels.append(bits)
        return levels
