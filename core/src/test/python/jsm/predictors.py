"""Which height along a ring's normal is expected. Each predictor has predict and learn."""


class RunningHeights:
    """The plane or the smooth surface: the one that was better for the last vertices."""

    def __init__(self):
        self.errors = [0.0, 0.0]
        self.heights = None

    def predict(self, ring, p, q, normals):
        self.heights = ring.height(p, q), ring.smooth_height(p, q, normals)
        return self.heights[self.errors[1] < self.errors[0]]

    def learn(self, cell, unit):
        for i, height in enumerate(self.heights):
            size = abs(cell - height) / unit
            self.errors[i] += (size / (size + 4) - self.errors[i]) / 64
