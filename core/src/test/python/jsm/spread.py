"""Offsets within a unit, by halvings of an interval around a prediction."""

from math import sqrt

from .entropy import Context, log8

TRUST = 6


def _context(odds):
    w = 1.0
    for _ in range(abs(odds)):
        w *= 1.4142135623730951
    x = w / (1 + w)
    return Context(int(65535 * (1 - x if odds < 0 else x)), TRUST)


class Spread:
    def __init__(self):
        self.contexts = {}

    def decode(self, decoder, kind, p, s, bits):
        """An offset of so many bits, expected at p, give or take s."""
        q = s * s * 2

        def share(x):
            return x / sqrt(q + x * x)

        low = 0
        below, above = share(-p), share((1 << bits) - p)
        for k in range(bits - 1, -1, -1):
            if 4 << k <= s:
                return low + decoder.raw(k + 1)
            middle = low + (1 << k)
            at = share(middle - p)
            part = 1 << 13
            if above - below > 0:
                part = max(0, min(1 << 14, int((above - at) / (above - below) * (1 << 14))))
            odds = log8(1 + part) - log8(1 + (1 << 14) - part) + 2 >> 2
            key = kind, max(-24, min(24, odds))
            if key not in self.contexts:
                self.contexts[key] = _context(key[1])
            if decoder.bit(self.contexts[key]):
                low = middle
                below = at
            else:
                above = at
        return low
