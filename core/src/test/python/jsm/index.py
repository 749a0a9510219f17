"""The index: a row for each batch."""

from math import sqrt

from .entropy import IntegerModel, to_int

SPLITS, TEXTURE, PRECISION, ATTRIBUTES, ORDER, PREVIEW, REMAINDER, POSTER = range(8)
# statistics of bytes, by kind
BYTES = {SPLITS: 1, PREVIEW: 2, PRECISION: 4, ATTRIBUTES: 5, TEXTURE: 3, ORDER: 3, REMAINDER: 3, POSTER: 3}
PATCHES = {SPLITS: 0, PRECISION: 1, ATTRIBUTES: 2}
MOST = (1 << 28) - 1
ZERO = 1023


def _scale():
    root = sqrt(sqrt(sqrt(sqrt(2.0))))
    values = []
    for step in range(ZERO):
        if step == 0:
            values.append(128.0)
        elif step % 16 == 0:
            values.append(values[step - 16] / 2)
        else:
            values.append(values[-1] / root)
    return values + [0.0]


ERRORS = _scale()


class Row:
    """kind, bytes, passes, fall, patches, vertices and faces after it; places in the file follow."""

    def __init__(self, kind):
        self.kind = kind
        self.passes = self.levels = self.fall = self.patches = 0
        self.bytes = self.vertices = self.faces = self.error = 0


class Index:
    def __init__(self, opening):
        self.signed_faces = opening.late_components
        self.counts_vertices = opening.stitches or opening.late_components
        self.flags = IntegerModel()
        self.bytes = IntegerModel()
        self.patches = IntegerModel()
        self.faces = IntegerModel()
        self.errors = IntegerModel()
        self.rows = []
        self.sent = 0
        self.per_patch = {SPLITS: 4.0, PRECISION: 1.0, ATTRIBUTES: 8.0}
        self.left = 0

    def read_base(self, decoder):
        row = Row(None)
        row.bytes = self.bytes.unsigned(decoder, 0)
        row.vertices = self.faces.unsigned(decoder, 0)
        row.faces = 2 * row.vertices - self.faces.signed(decoder, 0)
        row.error = self.errors.unsigned(decoder, 0)
        row.bound = row.error // 2
        if row.error != ZERO:
            row.bound -= self.errors.unsigned(decoder, 2)
        row.shift = decoder.raw(5)
        self.base = self.last = row
        self.sent = row.bytes

    def read_rows(self, decoder):
        for _ in range(self.flags.unsigned(decoder, 0)):
            self._read_row(decoder)

    def read_quantiles(self, decoder):
        model = IntegerModel()
        last = now = 0
        for i, row in enumerate([self.base] + self.rows):
            mean = row.error // 2
            if row.error != ZERO:
                most = max(now, mean)
                least = max(now, min(most, row.bound))
                guess = now
                if i == 0:
                    guess = mean - 16
                elif row.kind == SPLITS:
                    guess = now + mean - last
                expected = max(least, min(most, guess))
                now = expected + model.signed(decoder, 0 if i == 0 else 1 if row.kind == SPLITS else 2)
                if not least <= now <= most:
                    raise ValueError(f"row {i}: a quantile out of range")
            last = mean

    def _read_row(self, decoder):
        last = self.last
        row = Row(self.flags.unsigned(decoder, 1))
        row.vertices = last.vertices
        row.faces = last.faces
        if row.kind == SPLITS:
            row.passes = self.flags.unsigned(decoder, 2)
            if row.passes:
                row.levels = self.flags.unsigned(decoder, 4)
        cap = min(65536, max(min(1024, max(100, self.sent // 3)), self.sent // 20))
        row.bytes = cap - self.bytes.signed(decoder, BYTES[row.kind])
        if row.kind == PRECISION or row.passes:
            row.fall = self.flags.unsigned(decoder, 3)
        if row.kind in PATCHES:
            self._read_patches(decoder, row)
        self._read_error(decoder, row)
        self.sent += row.bytes
        self.rows.append(row)
        self.last = row

    def _read_patches(self, decoder, row):
        most = MOST
        if row.kind == PRECISION:
            if not self.left:
                self.left = row.vertices
            most = self.left
        expected = min(most, to_int(row.bytes / self.per_patch[row.kind]))
        row.patches = expected + self.patches.signed(decoder, PATCHES[row.kind])
        if row.patches:
            self.per_patch[row.kind] = row.bytes / row.patches
        if row.kind == PRECISION:
            self.left -= row.patches
        if row.kind == SPLITS:
            read = self.faces.signed if self.signed_faces else self.faces.unsigned
            row.faces += 2 * row.patches - read(decoder, 1)
            row.vertices += row.patches
            if self.counts_vertices:
                row.vertices -= read(decoder, 2)

    def _read_error(self, decoder, row):
        last = self.last
        expected = last.error
        if row.vertices != last.vertices:
            value = ERRORS[last.error] * last.vertices / row.vertices
            expected = ZERO
            if value > 0:
                expected = max((s for s in range(ZERO) if ERRORS[s] >= value), default=0)
        row.error = expected + self.errors.signed(decoder, 1)
        row.bound = last.bound
        if row.error != ZERO:
            row.bound += self.errors.unsigned(decoder, 3)
