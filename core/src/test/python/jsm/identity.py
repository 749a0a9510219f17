"""meshSha256 of what was decoded."""

import hashlib
import struct

from .lattice import float_bits, float_of
from .surface import OUTSIDE


def shown_positions(decoder):
    """Per vertex the bits of x, y, z as they are shown."""
    opening = decoder.opening
    rows = decoder.positions.bits
    if opening.scale is not None:
        factor = float_of(opening.scale)
        return [[float_bits(float_of(b) * factor) for b in row] for row in rows]
    if opening.offsets is not None:
        offsets = [float_of(b) for b in opening.offsets]
        return [[float_bits(float_of(b) + o) for b, o in zip(row, offsets)] for row in rows]
    return rows


def mesh_sha256(decoder):
    surface = decoder.surface
    positions = shown_positions(decoder)
    digest = hashlib.sha256()

    def put(*numbers):
        digest.update(struct.pack("<%dI" % len(numbers), *(n & 0xFFFFFFFF for n in numbers)))

    faces = [surface.at[3 * f : 3 * f + 3] for f in range(surface.faces())]
    faces = [[surface.vertex_of[v] for v in face] for face in faces if OUTSIDE not in face]
    tuples = [[tuple(positions[v]) for v in face] for face in faces]
    put(len(faces), 0)
    distinct = sorted({t for face in tuples for t in face})
    rank = {t: i for i, t in enumerate(distinct)}
    put(len(distinct))
    for t in distinct:
        put(*t)
    put(0)
    for row in sorted(smallest_rotation([rank[t] for t in face]) + [0xFFFFFFFF] for face in tuples):
        put(*row)
    return digest.hexdigest()


def smallest_rotation(face):
    return min(face[i:] + face[:i] for i in range(3))
