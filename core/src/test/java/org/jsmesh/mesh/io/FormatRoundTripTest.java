package org.jsmesh.mesh.io;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Random;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.MeshComparison;
import org.junit.jupiter.api.Nested;
import org.junit.jupiter.api.Test;

/** What is written in a format reads back the same, as far as the format can hold it. */
class FormatRoundTripTest {
    /** Any bits that are a finite float, among them denormals and −0.0. */
    private static float[] floats(int count, Random random) {
        float[] values = new float[count];
        for (int i = 0; i < count; i++) {
            do {
                values[i] = Float.intBitsToFloat(random.nextInt());
            } while (Float.isNaN(values[i]) || Float.isInfinite(values[i]));
        }
        values[0] = -0f;
        values[1] = Float.MIN_VALUE;
        values[2] = -Float.MAX_VALUE;
        return values;
    }

    private static Channel channel(
            Channel.Semantic semantic,
            String name,
            int components,
            Channel.Type type,
            int wedges,
            boolean gaps,
            Random random) {
        int[] values = MeshAssembler.bits(floats(Math.max(3, components * wedges), random));
        if (type == Channel.Type.UINT8) Arrays.setAll(values, i -> values[i] & 0xFF);
        BitSet absent = new BitSet();
        for (int w = 0; w < wedges && gaps; w++) {
            if (random.nextInt(3) > 0) continue;
            absent.set(w);
            Arrays.fill(values, w * components, (w + 1) * components, 0);
        }
        return new Channel(semantic, name, components, type, values, absent);
    }

    /** Common ground of all formats, and what each adds to it. */
    abstract static class EveryFormat {
        final Random random = new Random(5);
        static final int VERTICES = 30;
        static final int WEDGES = 70;

        abstract ModelFormat format();

        List<Channel> channels() {
            return List.of();
        }

        List<Material> materials() {
            return List.of();
        }

        final Mesh mesh() {
            List<Channel> channels = channels();
            int wedges = channels.isEmpty() ? VERTICES : WEDGES;
            int[] faces = random.ints(3 * 100, 0, wedges).toArray();
            faces[1] = faces[0];
            System.arraycopy(faces, 0, faces, 3, 3);
            int[] wedgeVertices = new int[wedges];
            for (int w = 0; w < wedges; w++) wedgeVertices[w] = w % VERTICES;
            if (!channels.isEmpty()) Arrays.sort(wedgeVertices);
            if (format() == ModelFormat.HOPPE_M) partWedgesOfOneVertex(faces, wedgeVertices);
            List<Material> materials = materials();
            int[] faceMaterials = new int[100];
            for (int f = 0; f < 100; f++) faceMaterials[f] = random.nextInt(materials.size() + 1) - 1;
            return new MeshBuilder()
                    .positions(floats(3 * VERTICES, random))
                    .wedgeVertices(wedgeVertices)
                    .faceWedges(faces)
                    .channels(channels)
                    .materials(materials)
                    .faceMaterials(faceMaterials)
                    .build();
        }

        private static void partWedgesOfOneVertex(int[] faces, int[] wedgeVertices) {
            for (int c = 0; c < faces.length; c++) {
                for (int other = c - c % 3; other < c; other++) {
                    if (wedgeVertices[faces[c]] == wedgeVertices[faces[other]]) faces[c] = faces[other];
                }
            }
        }

        @Test
        void shouldBringBackEveryBit() throws IOException {
            for (int i = 0; i < 10; i++) {
                Mesh mesh = mesh();
                MemoryFiles files = new MemoryFiles();
                String name = "x." + format().extension();
                assertThat(ModelWriter.write(mesh, format(), name, files)).isEmpty();
                ModelFile read = files.read(name);
                assertThat(read.format()).isEqualTo(format());
                assertThat(read.notes()).isEmpty();
                assertThat(MeshComparison.firstDifference(mesh, read.mesh())).isEmpty();
            }
        }

        @Test
        void shouldWriteTheSameBytesTwice() throws IOException {
            Mesh mesh = mesh();
            MemoryFiles one = new MemoryFiles();
            MemoryFiles two = new MemoryFiles();
            ModelWriter.write(mesh, format(), "x", one);
            ModelWriter.write(mesh, format(), "x", two);
            assertThat(one.files().keySet()).isEqualTo(two.files().keySet());
            one.files()
                    .forEach((name, bytes) ->
                            assertThat(bytes).isEqualTo(two.files().get(name)));
        }
    }

    @Nested
    class Ply extends EveryFormat {
        @Override
        ModelFormat format() {
            return ModelFormat.PLY;
        }
    }

    @Nested
    class PlyWithAttributes extends Ply {
        @Override
        List<Channel> channels() {
            return List.of(
                    channel(Channel.Semantic.NORMAL, "normal", 3, Channel.Type.FLOAT32, WEDGES, false, random),
                    channel(Channel.Semantic.TEXCOORD, "uv", 2, Channel.Type.FLOAT32, WEDGES, false, random),
                    channel(Channel.Semantic.COLOUR, "colour", 4, Channel.Type.UINT8, WEDGES, false, random));
        }
    }

    @Nested
    class PlyWithFloatColours extends Ply {
        @Override
        List<Channel> channels() {
            return List.of(channel(Channel.Semantic.COLOUR, "colour", 3, Channel.Type.FLOAT32, WEDGES, false, random));
        }
    }

    @Nested
    class Obj extends EveryFormat {
        @Override
        ModelFormat format() {
            return ModelFormat.OBJ;
        }
    }

    @Nested
    class ObjWithEverything extends Obj {
        @Override
        List<Channel> channels() {
            return List.of(
                    channel(Channel.Semantic.NORMAL, "normal", 3, Channel.Type.FLOAT32, WEDGES, true, random),
                    channel(Channel.Semantic.TEXCOORD, "uv", 2, Channel.Type.FLOAT32, WEDGES, true, random),
                    channel(Channel.Semantic.COLOUR, "colour", 4, Channel.Type.FLOAT32, WEDGES, true, random));
        }

        @Override
        List<Material> materials() {
            return List.of(
                    Material.named("a b"),
                    new Material(
                            "c",
                            List.of(new Material.Parameter("Kd", .1f, .2f, -0f), new Material.Parameter("illum", 2)),
                            List.of()));
        }
    }

    @Nested
    class Stl extends EveryFormat {
        @Override
        ModelFormat format() {
            return ModelFormat.STL;
        }
    }

    @Nested
    class Off extends EveryFormat {
        @Override
        ModelFormat format() {
            return ModelFormat.OFF;
        }
    }

    @Nested
    class OffWithEverything extends Off {
        @Override
        List<Channel> channels() {
            return List.of(
                    channel(Channel.Semantic.NORMAL, "normal", 3, Channel.Type.FLOAT32, WEDGES, false, random),
                    channel(Channel.Semantic.TEXCOORD, "uv", 2, Channel.Type.FLOAT32, WEDGES, false, random),
                    channel(Channel.Semantic.COLOUR, "colour", 3, Channel.Type.UINT8, WEDGES, false, random));
        }

        @Override
        List<Material> materials() {
            List<Material> list = new ArrayList<>();
            for (float red : new float[] {0, 1, .1f}) {
                float[] rgb = {red, 0, 1e-20f};
                list.add(new Material(FaceColour.name(rgb), List.of(new Material.Parameter("rgb", rgb)), List.of()));
            }
            return list;
        }
    }

    @Nested
    class Hoppe extends EveryFormat {
        @Override
        ModelFormat format() {
            return ModelFormat.HOPPE_M;
        }
    }

    @Nested
    class HoppeWithEverything extends Hoppe {
        @Override
        List<Channel> channels() {
            return List.of(
                    channel(Channel.Semantic.NORMAL, "normal", 3, Channel.Type.FLOAT32, WEDGES, true, random),
                    channel(Channel.Semantic.TEXCOORD, "uv", 2, Channel.Type.FLOAT32, WEDGES, true, random),
                    channel(Channel.Semantic.COLOUR, "colour", 3, Channel.Type.FLOAT32, WEDGES, true, random));
        }

        @Override
        List<Material> materials() {
            float[] rgb = {.1f, 0, -0f};
            return List.of(
                    new Material(FaceColour.name(rgb), List.of(new Material.Parameter("rgb", rgb)), List.of()),
                    new Material("a } b", List.of(new Material.Parameter("rgb", rgb)), List.of()),
                    Material.named("matid=3"));
        }
    }
}
