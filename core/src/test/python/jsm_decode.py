"""Decodes .jsm archives along docs/format.md; prints meshSha256 and modelSha256 of each. Slow, for checks alone.

python3 jsm_decode.py ARCHIVE...
"""

import sys

from jsm.archive import Archive
from jsm.decoder import Decoder
from jsm.identity import mesh_sha256, model_sha256


def main(paths):
    for path in paths:
        with open(path, "rb") as file:
            archive = Archive(file.read())
        mesh = mesh_sha256(Decoder(archive))
        print(mesh, model_sha256(archive, mesh), path, flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
