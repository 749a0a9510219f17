package org.jsmesh.collapse;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.jsmesh.mesh.CornerTable;
import org.jsmesh.test.RandomMeshes;
import org.junit.jupiter.api.Test;

class FanDistanceTest {
    @Test
    void shouldFindTheDistanceToTheClosestFaceThatIsLeft() {
        CollapseMesh mesh = new CollapseMesh(RandomMeshes.TORUS.mesh(1));
        VertexStar star = new VertexStar(mesh, new UnitScale(mesh));
        FanDistance fan = new FanDistance();
        Random random = new Random(1);
        for (int u = 0; u < mesh.table().vertices(); u++) {
            if (mesh.table().cornerOf(u) < 0 || !star.load(u)) continue;
            star.measure(u);
            int target = random.nextInt(star.size);
            if (star.neighbour[target] == CornerTable.OUTSIDE) continue;
            fan.set(star, target);
            double[] p = {random.nextGaussian() / 10, random.nextGaussian() / 10, random.nextGaussian() / 10};
            double found = Math.sqrt(fan.squared(p[0], p[1], p[2]));
            assertThat(found).isEqualTo(sampled(star, target, p), within(2e-3));
            assertThat(found).isLessThanOrEqualTo(sampled(star, target, p) + 1e-9);
        }
    }

    /** The least distance to many points of the faces. */
    private static double sampled(VertexStar star, int target, double[] p) {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < star.size; i++) {
            int ahead = (i + 1) % star.size;
            if (i == target || ahead == target || star.neighbour[i] < 0 || star.neighbour[ahead] < 0) continue;
            for (int s = 0; s <= 100; s++)
                for (int t = 0; s + t <= 100; t++)
                    least = Math.min(least, distance(star, target, i, ahead, s / 100., t / 100., p));
        }
        return least;
    }

    private static double distance(VertexStar star, int a, int b, int c, double s, double t, double[] p) {
        double sum = 0;
        for (int axis = 0; axis < 3; axis++) {
            double x =
                    star.edge[3 * a + axis] * (1 - s - t) + star.edge[3 * b + axis] * s + star.edge[3 * c + axis] * t;
            sum += (x - p[axis]) * (x - p[axis]);
        }
        return Math.sqrt(sum);
    }
}
