"""What predictors learn from the vertices so far: weights of features, and which of them was best."""

KEEP = 1 - 1 / 1000
PART = 1 / 64
MOST_ERROR = 12  # units


class Fit:
    """Two weights of a linear prediction, by running least squares."""

    def __init__(self, a, b):
        self.a, self.b = float(a), float(b)
        self.xx = self.yy = 20.0
        self.xy = 0.0
        self.xt, self.yt = 20.0 * a, 20.0 * b
        self.count = self.given = 0

    def predict(self, x, y):
        return self.a * x + self.b * y

    def learn(self, x, y, value, scale):
        """Takes one of three values."""
        self.given += 1
        if self.given % 3 != 1:
            return
        error = value - self.predict(x, y)
        w = 1 / (error * error + scale * scale)
        wx, wy = w * x, w * y
        self.xx = KEEP * self.xx + wx * x
        self.xy = KEEP * self.xy + wx * y
        self.yy = KEEP * self.yy + wy * y
        self.xt = KEEP * self.xt + wx * value
        self.yt = KEEP * self.yt + wy * value
        self.count += 1
        if self.count % 16 == 0:
            self._solve()

    def _solve(self):
        g = 0.0001 * (self.xx + self.yy)
        xx, yy, xy = self.xx + g, self.yy + g, self.xy
        d = xx * yy - xy * xy
        if d > 0:
            s, t = self.xt + g * self.a, self.yt + g * self.b
            self.a, self.b = (s * yy - t * xy) / d, (t * xx - s * xy) / d


class Averages:
    """Running errors of several predictions."""

    def __init__(self, count):
        self.errors = [0.0] * count

    def learn(self, errors):
        """Learns the errors of the first ones."""
        for i, error in enumerate(errors):
            self.errors[i] += (error - self.errors[i]) * PART


def off_by(cells, unit_part):
    """An error in units."""
    return min(MOST_ERROR, unit_part * abs(cells))
