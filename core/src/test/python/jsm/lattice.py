"""Lattices: cells, the places in them, points by number, steps between them."""

import struct

from .entropy import Context, Contexts, IntegerModel, round_away

LARGEST = struct.unpack("<f", struct.pack("<I", 0x7F7FFFFF))[0]
FLOAT_SIGN = 1 << 31


def float_bits(x):
    """The bits of the float32 number closest to x."""
    try:
        return struct.unpack("<I", struct.pack("<f", x))[0]
    except OverflowError:
        return 0x7F800000 | (FLOAT_SIGN if x < 0 else 0)


def float_of(bits):
    return struct.unpack("<f", struct.pack("<I", bits))[0]


def fl32(x):
    return float_of(float_bits(x))


class Lattice:
    def __init__(self, decimal, rounded, digits, min_exponent, grid_exponent, exceptions):
        self.radix = 10 if decimal else 2
        self.rounded = rounded
        self.digits = digits
        self.min_exponent = min_exponent
        self.grid = grid_exponent
        self.exceptions = exceptions
        self.powers = [1.0]
        for _ in range(149):
            self.powers.append(self.powers[-1] * self.radix)
        self.limit = self.radix**digits - 1

    @staticmethod
    def read(decoder, integers):
        decimal = decoder.flag()
        rounded = decoder.flag() if decimal else 0
        digits = integers.unsigned(decoder)
        min_exponent = integers.signed(decoder)
        grid_exponent = integers.signed(decoder)
        return Lattice(decimal, rounded, digits, min_exponent, grid_exponent, decoder.flag())

    def times(self, m, e):
        """m · r^e by the lattice's powers, a double."""
        if self.rounded:
            while m and m % 10 == 0 and e < 0:
                m //= 10
                e += 1
            if e < 0:
                return m * fl32(1 / self.powers[-e])
        return self.scaled(m, e)

    def scaled(self, m, e):
        """m · r^e by powers that are doubles."""
        return m * self.powers[e] if e >= 0 else m / self.powers[-e]

    @property
    def spacing(self):
        return self.times(1, self.grid)

    def float_bits(self, m, e):
        """The bits of the point m · r^e."""
        return float_bits(self.times(m, e))

    def exponent_in(self, q):
        """The exponent of the points in the cell of magnitude q > 0."""
        digits = 0
        while q:
            q //= self.radix
            digits += 1
        return max(min(self.grid, self.grid + digits - self.digits), self.min_exponent)

    def edge(self, cell):
        """The lower edge of a cell, as bits."""
        bits = min(self.float_bits(abs(cell), self.grid), 0x7F7FFFFF)
        return bits | FLOAT_SIGN if cell < 0 else bits

    def closest(self, x):
        """The bits of the point closest to x."""
        size = abs(x)
        q = size / self.spacing
        if q >= self.limit:
            q = self.limit
            size = min(size, self.times(q, self.grid))
        q = int(q)
        if q > 0:
            e = self.exponent_in(q)
        else:
            e = max(self.min_exponent, self.grid - self.digits)
            least = self.radix ** (self.digits - 1)
            while e > self.min_exponent and self._mantissa(size, e) < least:
                e -= 1
        bits = min(self.float_bits(int(self._mantissa(size, e) + 0.5), e), 0x7F7FFFFF)
        return bits | FLOAT_SIGN if x < 0 else bits

    def _mantissa(self, size, e):
        return size / self.powers[e] if e >= 0 else size * self.powers[-e]

    def point(self, bits):
        """Mantissa and exponent of a float32 number on the lattice, else None."""
        bits &= 0x7FFFFFFF
        if bits == 0:
            return 0, self.min_exponent
        if self.radix == 2:
            e = max(1, bits >> 23) - 150
            m = bits & 0x7FFFFF | (0x800000 if bits >> 23 else 0)
            if e < self.min_exponent:
                lost = self.min_exponent - e
                if m & ((1 << lost) - 1):
                    return None
                return m >> lost, self.min_exponent
            return m, e
        x = float_of(bits)
        top = float(10**self.digits)
        e = self.min_exponent
        while not x < self.scaled(top, e) * (1 - 1e-9):
            e += 1
        m = round_away(self._mantissa(x, e))
        if m == 10**self.digits:
            m //= 10
            e += 1
        return (m, e) if m > 0 and self.float_bits(m, e) == bits else None

    def cell(self, bits):
        """The cell of a float32 number."""
        point = self.point(bits)
        if point is None:
            x = float_of(bits & 0x7FFFFFFF)
            q = min(self.limit, int(x / self.spacing))
        else:
            m, e = point
            if self.grid - e > self.digits:
                q = 0
            elif e >= self.grid:
                q = m * self.radix ** (e - self.grid)
            else:
                q = m // self.radix ** (self.grid - e)
        return -1 - q if bits & FLOAT_SIGN else q

    def number(self, bits):
        """The number of a point, 0 of what is none."""
        point = self.point(bits)
        if point is None:
            return 0
        step = self.radix**self.digits - self.radix ** (self.digits - 1)
        return (point[1] - self.min_exponent) * step + point[0]

    def of_number(self, number):
        """The bits of the point of a number."""
        full = self.radix**self.digits
        step = full - full // self.radix
        up = 0 if number < full else 1 + (number - full) // step
        return self.float_bits(number - up * step, self.min_exponent + up)


class Column:
    """The contexts of the exact values of a column."""

    def __init__(self, lattice):
        self.lattice = lattice
        self.same = Contexts()
        self.off = Context()
        self.within = Context()
        self.zero = Context()
        self.down = IntegerModel()

    def decode(self, decoder, cell, neighbour=None):
        """The exact value in a cell, as bits; neighbour: the bits of one in the same cell."""
        lattice = self.lattice
        q = cell if cell >= 0 else -1 - cell
        sign = FLOAT_SIGN if cell < 0 else 0
        e = lattice.exponent_in(q) if q else 0
        if neighbour is not None and (q == 0 or e < lattice.grid) and decoder.bit(self.same[q == 0]):
            return neighbour
        if lattice.exceptions and decoder.bit(self.off):
            first = lattice.float_bits(q, lattice.grid)
            count = lattice.float_bits(q + 1, lattice.grid) - first
            if count and decoder.bit(self.within):
                return sign | (first + decoder.below(count))
            return decoder.number()
        if q:
            n = lattice.radix ** (lattice.grid - e)
            place = decoder.below(n) if n > 1 else 0
            return sign | lattice.float_bits(q * n + place, e)
        if decoder.bit(self.zero):
            return sign
        least = lattice.grid - lattice.digits
        e = lattice.min_exponent
        if least > e:
            e = max(e, least - self.down.unsigned(decoder))
        m0 = lattice.radix ** (lattice.digits - 1) if e > lattice.min_exponent else 1
        most = lattice.radix ** min(lattice.digits, lattice.grid - lattice.min_exponent)
        return sign | lattice.float_bits(m0 + decoder.below(most - m0), e)


class Steps:
    """Points of the lattice between a prediction and a value."""

    def __init__(self):
        self.beyond = Contexts()
        self.between = IntegerModel()
        self.last = 0

    def decode(self, decoder, role, lattice, prediction):
        """The bits of the value, or None if it is beyond 31 points; prediction: bits."""
        if decoder.bit(self.beyond[role, 2 if self.last > 31 else min(1, self.last)]):
            self.last = 32
            return None
        steps = self.between.signed(decoder, (role, min(3, self.last)))
        self.last = abs(steps)
        number = max(0, lattice.number(prediction) + steps)
        return prediction & FLOAT_SIGN | lattice.of_number(number)

