package org.jsmesh.encode.measure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class PointEquationsTest {
    private static final double[] CORNERS = {0, 0, 0, 4, 0, 0, 0, 4, 0};
    private static final double[][] SHARES = {
        {0.6, 0.2, 0.2}, {0.2, 0.6, 0.2}, {0.2, 0.2, 0.6}, {0.4, 0.4, 0.2}, {0.2, 0.4, 0.4}
    };
    private static final double[] UP = {0, 0, 1};

    /** The points lie beside those that should come to them, as when the closest point slides along the surface. */
    @Test
    void shouldFollowDistancesAlongTheirDirectionsMoreThanAcross() {
        PointEquations equations = new PointEquations(CORNERS, SHARES.length);
        for (double[] s : SHARES)
            equations.add(new int[] {0, 1, 2}, 0, s, new double[] {4 * s[1] + 1, 4 * s[2], 2}, UP, 1);
        double[] x = CORNERS.clone();
        equations.solve(x, 0.3, 20);
        for (int v = 0; v < 9; v += 3) {
            assertThat(x[v] - CORNERS[v]).isBetween(0.01, 0.5);
            assertThat(x[v + 1] - CORNERS[v + 1]).isCloseTo(0, within(1e-9));
            assertThat(x[v + 2]).isBetween(1.3, 2.0);
        }
    }

    @Test
    void shouldReachThePointsWhereNothingStays() {
        PointEquations equations = new PointEquations(CORNERS, SHARES.length);
        for (double[] s : SHARES)
            equations.add(new int[] {0, 1, 2}, 0, s, new double[] {4 * s[1] + 1, 4 * s[2], 2}, UP, 1);
        double[] x = CORNERS.clone();
        equations.solve(x, 0, 20);
        for (int v = 0; v < 9; v += 3) {
            assertThat(x[v] - CORNERS[v]).isCloseTo(1, within(1e-6));
            assertThat(x[v + 2]).isCloseTo(2, within(1e-6));
        }
    }
}
