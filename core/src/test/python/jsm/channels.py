"""The values of a channel, and how they come with a new wedge."""

from .entropy import Contexts, Residuals, round_away
from .lattice import Column

NO_SURPRISE = 16


class ChannelValues:
    """Per wedge: cells, values (bits, or bytes), whether absent; exact: those that an attribute sweep has made so."""

    def __init__(self, format):
        self.format = format
        self.components = format.components
        self.absent = []
        self.cells = []
        self.values = []
        self.exact = set()

    def is_exact(self, wedge):
        return wedge in self.exact and not self.absent[wedge]

    def unit(self, wedge, k):
        return self.cells[wedge][k] >> self.format.shift

    def units(self, wedge):
        return [self.unit(wedge, k) for k in range(self.components)]

    def take(self, wedge, other):
        self.cells[wedge] = list(self.cells[other])
        self.values[wedge] = list(self.values[other])


class NewValues:
    """Codes the values that a new wedge brings."""

    def __init__(self, values):
        self.of = values
        self.residuals = Residuals(0)
        self.absence = Contexts()
        self.last_absent = 0
        lattice = values.format.lattice
        self.columns = [lattice and Column(lattice) for _ in range(values.components)]

    def decode(self, decoder, around):
        """around: wedges that the values are predicted from, as often as they count."""
        of = self.of
        form = of.format
        of.cells.append([0] * of.components)
        of.values.append([0] * of.components)
        absent = 0
        if form.may_be_absent:
            absent = self.last_absent = decoder.bit(self.absence[self.last_absent])
        of.absent.append(absent)
        if absent or form.normals:
            return
        known = [of.cells[w] for w in around if not of.absent[w]]
        before = 0
        for k in range(of.components):
            mean = 0
            size = 1 << 20
            if known:
                column = [cells[k] for cells in known]
                mean = round_away(sum(column) / len(column)) >> form.shift
                size = min(1 << 28, 4 * (max(column) - min(column)) + 4)
            expected = mean
            if form.follow and k < 3:
                expected = max(0, min(255 >> form.shift, mean + before))
            role = k if known else k + of.components
            unit = expected + self.residuals.decode(decoder, role, size >> form.shift, 0, NO_SURPRISE)
            before = unit - mean
            self._set(decoder, k, unit)

    def _set(self, decoder, k, unit):
        cells, values = self.of.cells[-1], self.of.values[-1]
        shift = self.of.format.shift
        if shift:
            cells[k] = (unit << shift) + (1 << (shift - 1))
            return
        cells[k] = unit
        values[k] = self.columns[k].decode(decoder, unit) if self.columns[k] else unit
