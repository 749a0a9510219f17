"""Bytes of float32 points by pcodec, axis by axis, each with its best delta: columns.py POINTS"""

import sys

try:
    import numpy
    from pcodec import ChunkConfig, DeltaSpec, standalone
except ImportError:
    sys.exit(3)

points = numpy.fromfile(sys.argv[1], dtype=numpy.float32).reshape(-1, 3)
total = 0
for axis in range(3):
    values = numpy.ascontiguousarray(points[:, axis])
    sizes = []
    for delta in ({}, {"delta_spec": DeltaSpec.try_consecutive(1)}, {"delta_spec": DeltaSpec.try_lookback()}):
        packed = standalone.simple_compress(values, ChunkConfig(compression_level=12, **delta))
        if standalone.simple_decompress(packed).tobytes() != values.tobytes():
            sys.exit("pcodec does not give back what it was given")
        sizes.append(len(packed))
    total += min(sizes)
print(total)
