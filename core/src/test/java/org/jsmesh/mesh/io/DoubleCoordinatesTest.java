package org.jsmesh.mesh.io;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.MeshComparison;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Coordinates that float32 does not hold, in every format. */
class DoubleCoordinatesTest {
    private static final String TRIANGLE =
            "450000.123 5411000.456 312.789\n450000.124 5411000.456 312.789\n" + "450000.123 5411000.457 -0.0\n";

    private static Mesh read(String name, String text) throws IOException {
        return ModelReader.read(name, text.getBytes(StandardCharsets.UTF_8), new MemoryFiles())
                .mesh();
    }

    private static void check(Mesh mesh) {
        assertThat(mesh.isDouble()).isTrue();
        assertThat(mesh.vertices()).isEqualTo(3);
        assertThat(mesh.coordinate(mesh.vertex(0, 1), 0)).isEqualTo(450000.124);
        assertThat(mesh.coordinate(mesh.vertex(0, 2), 1)).isEqualTo(5411000.457);
        assertThat(1 / mesh.coordinate(mesh.vertex(0, 2), 2)).isNegative();
        double width = (double) mesh.positions()[3] - mesh.positions()[0];
        assertThat(Math.abs(width)).isBetween(.0009, .0011);
    }

    @Test
    void shouldBeReadFromText() throws IOException {
        String[] lines = TRIANGLE.split("\n");
        check(read("a.obj", "v " + String.join("\nv ", lines) + "\nf 1 2 3\n"));
        check(read("a.off", "OFF\n3 1 0\n" + TRIANGLE + "3 0 1 2\n"));
        check(read(
                "a.m",
                "Vertex 1 " + lines[0] + "\nVertex 2 " + lines[1] + "\nVertex 3 " + lines[2] + "\nFace 1 1 2 3\n"));
        check(read(
                "a.stl",
                "solid a\nfacet normal 0 0 1\nouter loop\nvertex " + String.join("\nvertex ", lines)
                        + "\nendloop\nendfacet\nendsolid a\n"));
        for (String type : List.of("double", "float"))
            check(read(
                    "a.ply",
                    "ply\nformat ascii 1.0\nelement vertex 3\nproperty " + type + " x\nproperty " + type
                            + " y\nproperty " + type
                            + " z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
                            + TRIANGLE + "3 0 1 2\n"));
    }

    @Test
    void shouldBeReadFromBinaryPlyInAnyOrderOfTheAxes() throws IOException {
        String header = "ply\nformat binary_big_endian 1.0\nelement vertex 3\nproperty double z\nproperty double x\n"
                + "property double y\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
        ByteBuffer data = ByteBuffer.allocate(header.length() + 72 + 13).order(ByteOrder.BIG_ENDIAN);
        data.put(header.getBytes(StandardCharsets.US_ASCII));
        for (double x : new double[] {
            312.789, 450000.123, 5411000.456, 312.789, 450000.124, 5411000.456, -0.0, 450000.123, 5411000.457
        }) data.putDouble(x);
        data.put((byte) 3).putInt(0).putInt(1).putInt(2);
        check(ModelReader.read("a.ply", data.array(), new MemoryFiles()).mesh());
    }

    @Test
    void shouldStayFloat32WhereThatHoldsTheText() throws IOException {
        Mesh mesh = read("a.obj", "v 0.1 0.25 1e-7\nv 123.4567 0 0\nv 0 1 1.1754944E-38\nf 1 2 3\n");
        assertThat(mesh.isDouble()).isFalse();
        assertThat(mesh.positions()[0]).isEqualTo(.1f);
    }

    @ParameterizedTest
    @EnumSource(names = {"PLY", "OBJ", "OFF", "HOPPE_M"})
    void shouldComeBackFromEveryFormatThatHoldsThem(ModelFormat format) throws IOException {
        double[] positions = {450000.123, 5411000.456, Math.PI, 1e-300, -0.0, Math.E, 450001, 5411000.5, -1e9 / 7};
        Mesh mesh = new MeshBuilder()
                .positions(positions)
                .faceWedges(new int[] {0, 1, 2})
                .build();
        MemoryFiles files = new MemoryFiles();
        ModelWriter.write(mesh, format, "m." + format.extension(), files);
        Mesh back = ModelReader.read("m." + format.extension(), files.files().get("m." + format.extension()), files)
                .mesh();
        assertThat(MeshComparison.firstDifference(mesh, back)).isEmpty();
    }

    @Test
    void shouldBeWrittenToStlAsOffsets() throws IOException {
        Mesh mesh = read("a.off", "OFF\n3 1 0\n" + TRIANGLE + "3 0 1 2\n");
        MemoryFiles files = new MemoryFiles();
        List<String> notes = ModelWriter.write(mesh, ModelFormat.STL, "m.stl", files);
        assertThat(notes)
                .anyMatch(n -> n.startsWith("STL holds float32 alone: positions are written as offsets from 450000"));
        Mesh back = ModelReader.read("m.stl", files.files().get("m.stl"), files).mesh();
        assertThat(back.vertices()).isEqualTo(3);
    }
}
