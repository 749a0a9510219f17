package org.jsmesh.files.gltf.draco;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.offset;

import java.nio.ByteBuffer;
import org.jsmesh.files.gltf.packed.PackedException;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class OctahedronTest {
    /** Of four bits: coordinates go from 0 to 14. */
    @ParameterizedTest
    @CsvSource({
        "7, 0, 0, 7, 7",
        "0, 0, 9, 7, 14",
        "0, -3, 0, 0, 7",
        "2, 4, -1, 11, 6",
        // Where x is negative, two points of the border stand for one vector.
        "-7, 0, 0, 14, 14",
        "-4, -3, 0, 0, 3",
        "-4, 3, 0, 14, 11",
        "-4, 0, 3, 11, 14",
        "-4, 0, -3, 3, 0",
        "-2, -3, -2, 2, 3",
        "-2, 3, 2, 12, 11",
    })
    void shouldGiveEachVectorOnePoint(int x, int y, int z, int s, int t) throws PackedException {
        Octahedron octahedron = new Octahedron(4);
        int[] point = new int[2];
        octahedron.toPoint(new long[] {x, y, z}, false, point);
        assertThat(point).containsExactly(s, t);
        octahedron.toPoint(new long[] {-x, -y, -z}, true, point);
        assertThat(point).containsExactly(s, t);
        ByteBuffer vector = ByteBuffer.allocate(12);
        octahedron.putVector(s, t, vector);
        double length = Math.sqrt(x * x + y * y + z * z);
        assertThat(vector.getFloat(0)).isEqualTo((float) (x / length), offset(1e-6f));
        assertThat(vector.getFloat(4)).isEqualTo((float) (y / length), offset(1e-6f));
        assertThat(vector.getFloat(8)).isEqualTo((float) (z / length), offset(1e-6f));
    }
}
