"""Decodes all batches of an archive."""

from . import index
from .archive import varint
from .components import Components
from .connectivity import Connectivity
from .entropy import RangeDecoder
from .positions import Positions
from .refiners import Attributes
from .renumber import Renumbering
from .surface import Surface
from .sweeps import Sweeps
from .wedges import Wedges


class Streams:
    """The three streams of a payload of the base or of splits, and the passes that begin in it."""

    def __init__(self, payload, has_attributes, passes, fall):
        at = 0
        self.starts = []
        falls = fall > 0 and passes > 1
        for i in range(passes):
            splits, at = varint(payload, at)
            here = fall
            if falls and i < passes - 1:
                here, at = varint(payload, at)
            fall -= here
            self.starts.append((splits, here))
        c, at = varint(payload, at)
        g = len(payload)
        if has_attributes:
            g, at = varint(payload, at)
        self.connectivity = RangeDecoder(payload[at : at + c])
        self.geometry = RangeDecoder(payload[at + c : at + c + g])
        self.attributes = RangeDecoder(payload[at + c + g :])


class Decoder:
    def __init__(self, archive):
        self.opening = opening = archive.opening
        self.rest = archive.rest
        self.remainder = b""
        self.has_attributes = bool(opening.channels) or opening.has_materials
        self.surface = Surface()
        cells = []
        self.connectivity = Connectivity(self.surface, cells, opening.stitches)
        self.positions = Positions(self.surface, opening, cells)
        self.sweeps = Sweeps(self.positions)
        self.components = Components(self.surface, self.positions, self.connectivity, opening)
        self.wedges = Wedges(self.surface, opening)
        self.renumbering = Renumbering(self)
        attributes = Attributes(self)
        streams = Streams(archive.payloads[0], self.has_attributes, 0, 0)
        faces = opening.index.base.faces
        self.components.base(streams, faces)
        self._component(streams, 0, faces)
        for row, payload in zip(opening.index.rows, archive.payloads[1:]):
            if row.kind == index.SPLITS:
                self._splits(Streams(payload, self.has_attributes, row.passes, row.fall), row.patches)
            elif row.kind == index.PRECISION:
                self._sweep(RangeDecoder(payload), row)
            elif row.kind == index.ATTRIBUTES:
                attributes.decode(RangeDecoder(payload), row.patches)
            elif row.kind == index.REMAINDER:
                self.remainder += payload

    def _sweep(self, stream, row):
        if not self.sweeps.left():
            self.sweeps.begin(stream, row.fall)
        self.sweeps.go_on(stream, row.patches)

    def _splits(self, streams, count):
        for before, fall in streams.starts:
            self._split(streams, before)
            count -= before
            self.sweeps.before_pass(streams.geometry, fall)
            self.renumbering.begin_pass()
            self.connectivity.begin_pass()
            self.components.begin_pass()
            self.positions.begin_pass()
        self._split(streams, count)

    def _split(self, streams, count):
        while count > 0:
            first = self.surface.faces()
            faces = self.components.decode_another(streams)
            if not faces:
                break
            self._component(streams, first, faces)
            count -= 1
        splits = []
        for _ in range(count):
            split = self.connectivity.next_split(streams.connectivity)
            splits.append(split)
            if self.has_attributes:
                self.wedges.split(streams.attributes, split)
        for split in splits:
            if split.stitched:
                self.positions.copy(split.u)
            else:
                self.positions.new(streams.geometry, split)

    def _component(self, streams, first, faces):
        if self.has_attributes:
            self.wedges.component(streams.attributes, first, faces)
