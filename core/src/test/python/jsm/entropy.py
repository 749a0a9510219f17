"""The entropy coder: range decoder, contexts, integer models, logarithms, residuals' bit lengths."""


class Context:
    __slots__ = ("p", "c")

    def __init__(self, p=1 << 15, c=0):
        self.p = p
        self.c = c

    def learn(self, bit):
        rate = RATES[self.c]
        self.p += ((65487 if bit else 48) - self.p) * rate >> 15
        if self.c < 62:
            self.c += 1


# floor(65536 / (c + 1.6)) >> 1, for c from 0 to 62
RATES = [65536 * 5 // (5 * c + 8) >> 1 for c in range(63)]


class Contexts(dict):
    """Contexts by what they depend on; each begins when it is first asked for."""

    def __missing__(self, key):
        context = self[key] = Context()
        return context


class RangeDecoder:
    def __init__(self, data):
        self.data = data
        self.at = 4
        self.range = (1 << 31) - 1
        self.code = int.from_bytes((bytes(data[:4]) + bytes(4))[:4], "big")

    def _refill(self):
        while self.range < 1 << 23:
            self.range <<= 8
            entering = self.data[self.at] if self.at < len(self.data) else 0
            self.at += 1
            self.code = self.code << 8 | entering

    def _choose(self, p):
        bound = (self.range >> 15) * p
        if self.code < bound:
            self.range = bound
            bit = 1
        else:
            self.range -= bound
            self.code -= bound
            bit = 0
        self._refill()
        return bit

    def bit(self, context):
        bit = self._choose(context.p >> 1)
        context.learn(bit)
        return bit

    def bit2(self, a, b):
        """A bit under two contexts together."""
        bit = self._choose((a.p >> 1) + (b.p >> 1) >> 1)
        a.learn(bit)
        b.learn(bit)
        return bit

    def raw(self, bits):
        if bits == 0:
            return 0
        if bits > 16:
            high = self.raw(bits - 16)
            return high << 16 | self.raw(16)
        self.range >>= bits
        value = min(self.code // self.range, (1 << bits) - 1)
        self.code -= value * self.range
        self._refill()
        return value

    def flag(self):
        return self.raw(1)

    def below(self, n):
        """A number below n."""
        if n > 1 << 16:
            high = self.below(((n - 1) >> 15) + 1)
            return high << 15 | self.raw(15)
        self.range //= n
        value = min(self.code // self.range, n - 1)
        self.code -= value * self.range
        self._refill()
        return value

    def number(self):
        """A float, or another number of 32 raw bits, as its bits."""
        return self.raw(32)


class IntegerModel:
    def __init__(self):
        self.more = Contexts()
        self.first = Contexts()
        self.second = Contexts()
        self.negative = Context()

    def unsigned(self, decoder, statistics=0):
        length = 0
        while length < 31 and decoder.bit(self.more[statistics, length]):
            length += 1
        if length < 2:
            return length
        value = 2 | decoder.bit(self.first[length])
        if length > 2:
            value = value << 1 | decoder.bit(self.second[length, value & 1])
        if length > 3:
            value = value << length - 3 | decoder.raw(length - 3)
        return value

    def signed(self, decoder, statistics=0):
        value = self.unsigned(decoder, statistics)
        return -value if value and decoder.bit(self.negative) else value


def _log_digits(x, count):
    """The first binary digits of log2(x) behind the point, 1 <= x < 2."""
    digits = 0
    for _ in range(count):
        x *= x
        digits <<= 1
        if x >= 2:
            digits |= 1
            x /= 2
    return digits


EIGHTHS = [(_log_digits(1 + (i + 0.5) / 64, 4) + 1) >> 1 for i in range(64)]


def log8(x):
    bits = x.bit_length()
    below = (x << 7 >> bits) & 63
    return 8 * (bits - 1) + EIGHTHS[below]


def log256(x):
    bits = x.bit_length()
    return 256 * (bits - 1) + _log_digits(x / (1 << (bits - 1)), 8)


def to_int(x):
    """A double as an integer: towards zero, the closest 32-bit one."""
    return max(-(1 << 31), min((1 << 31) - 1, int(x)))


def round_away(x):
    """To the nearest integer, halves away from zero."""
    return -to_int(-x + 0.5) if x < 0 else to_int(x + 0.5)


class Residuals:
    """Signed numbers around 0 whose bit length is about that of an expected size."""

    def __init__(self, unit_class):
        self.unit = unit_class
        self.means = {}
        self.longer = Contexts()
        self.longer2 = Contexts()
        self.shorter = Contexts()
        self.shorter2 = Contexts()
        self.negative = Contexts()
        self.first = Contexts()
        self.surprise = 16

    def decode(self, decoder, role, size, lean, surprise):
        """A residual of a size of which the class is taken; self.surprise is the class that it leaves."""
        scale = min(63, log8(max(1, size)) // 4)
        mean = self.means.get((role, scale))
        if mean is None:
            mean = 128 * max(0, scale - self.unit)
        n = start = (mean + 128) >> 8

        def step(one, two):
            lean_to = max(0, min(31, n - start + 16))
            return decoder.bit2(one[role, scale, n], two[role, scale // 8, surprise, lean_to])

        if step(self.longer, self.longer2):
            n += 1
            while n < 31 and step(self.longer, self.longer2):
                n += 1
        else:
            while n > 0 and step(self.shorter, self.shorter2):
                n -= 1
        self.means[role, scale] = mean + ((256 * n - mean) >> 4)
        self.surprise = max(0, min(31, 2 * n - (scale - self.unit) + 16))
        if n == 0:
            return 0
        negative = decoder.bit(self.negative[role, n, lean])
        value = 1
        if n > 1:
            value = 2 | decoder.bit(self.first[role, scale, n])
        if n > 2:
            value = value << n - 2 | decoder.raw(n - 2)
        return -value if negative else value
