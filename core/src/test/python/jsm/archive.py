"""An archive: its parts, each checked by its CRC."""

import hashlib
import zlib

from . import index as kinds
from .entropy import RangeDecoder
from .header import Opening, Rest


class Malformed(Exception):
    pass


class Archive:
    def __init__(self, data):
        self.data = data
        if data[:4] != b"jSM\x02":
            raise Malformed("not an archive of version 2")
        self.features = data[4]
        size, at = varint(data, 5)
        self.payloads = []
        opening, at = self._part(0, at, size + 4)
        self.opening = Opening(RangeDecoder(opening[-size:]), self.features)
        index = self.opening.index
        early = len(index.rows)
        base, at = self._part(at, at, index.base.bytes)
        self.payloads.append(base)
        for row in index.rows:
            payload, at = self._part(at, at, row.bytes)
            self.payloads.append(payload)
        rest, at = self._part(at, at, self.opening.rest_bytes)
        self.rest = Rest(RangeDecoder(rest), self.opening)
        for row in index.rows[early:]:
            payload, at = self._part(at, at, row.bytes)
            self.payloads.append(payload)
        if at != len(data):
            raise Malformed("%d bytes behind the last batch" % (len(data) - at))

        self._check_images()

    def _check_images(self):
        rows = zip(self.opening.index.rows, self.payloads[1:])
        images = b"".join(payload for row, payload in rows if row.kind == kinds.TEXTURE)
        at = 0
        for (paths, size), sha256 in zip(self.opening.images, self.rest.image_sha256):
            if hashlib.sha256(images[at : at + size]).hexdigest() != sha256:
                raise Malformed("the image %s is not the one that the header names" % paths[0])
            at += size
        if at != len(images):
            raise Malformed("%d bytes behind the last image" % (len(images) - at))

    def _part(self, start, at, size):
        """The bytes from start to the CRC that ends a part of that size, and where the next one begins."""
        end = at + size
        part = self.data[start : end - 4]
        if zlib.crc32(part) != int.from_bytes(self.data[end - 4 : end], "little"):
            raise Malformed("wrong CRC of the batch at %d" % at)
        return part, end


def varint(data, at):
    value = shift = 0
    while True:
        byte = data[at]
        at += 1
        value |= (byte & 127) << shift
        shift += 7
        if byte < 128:
            return value, at
