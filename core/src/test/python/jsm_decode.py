"""Decodes .jsm archives along docs/format.md and prints meshSha256 of each. Slow, for checks alone.

python3 jsm_decode.py ARCHIVE...
"""

import sys

from jsm.archive import Archive
from jsm.decoder import Decoder
from jsm.identity import mesh_sha256


def main(paths):
    for path in paths:
        with open(path, "rb") as file:
            archive = Archive(file.read())
        print(mesh_sha256(Decoder(archive)), path, flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
