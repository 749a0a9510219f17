package org.jsmesh.web;

import java.util.BitSet;
import java.util.List;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.FaceChannel;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;

/** Bumpy tori of some 5,000 faces, with what a model may carry. */
enum TestShapes {
    /** Positions alone. */
    ROUND {
        @Override
        Mesh mesh() {
            return torus().build();
        }
    },
    /** Vertex colours, and two materials. */
    COLOURED {
        @Override
        Mesh mesh() {
            int[] values = new int[3 * AROUND * ALONG];
            for (int i = 0; i < values.length; i++) values[i] = i * 7 % 256;
            int[] materials = new int[2 * AROUND * ALONG];
            for (int f = 0; f < materials.length; f++) materials[f] = f < materials.length / 3 ? 0 : 1;
            return torus().channels(List.of(
                            new Channel(Channel.Semantic.COLOUR, "colour", 3, Channel.Type.UINT8, values, null)))
                    .materials(List.of(Material.named("first"), Material.named("second")))
                    .faceMaterials(materials)
                    .build();
        }
    },
    /**
     * Decimals in micrometres at map coordinates, of which offsets in float32 do not tell all, and some that are none.
     */
    SURVEYED {
        @Override
        Mesh mesh() {
            float[] near = torus().build().positions();
            double[] far = new double[near.length];
            for (int i = 0; i < far.length; i++)
                far[i] = i % 97 == 5
                        ? near[i] * Math.PI + 5_411_000
                        : Math.rint((near[i] * 100 + 5_411_000) * 1e6) / 1e6;
            return torus().positions(far).build();
        }
    },
    /** Doubles, scalars of several types by vertex, groups and scalars by face. */
    MEASURED {
        @Override
        Mesh mesh() {
            int n = AROUND * ALONG;
            double[] positions = new double[3 * n];
            float[] near = torus().build().positions();
            for (int i = 0; i < positions.length; i++) positions[i] = i % 50 == 0 ? 0 : near[i] / 7.0;
            int[] times = new int[2 * n];
            int[] ids = new int[n];
            int[] colours = new int[3 * n];
            for (int v = 0; v < n; v++) {
                long bits = Double.doubleToRawLongBits(3e8 + v * Math.E);
                times[2 * v] = (int) bits;
                times[2 * v + 1] = (int) (bits >>> 32);
                ids[v] = v * 0x9E3779B1;
                for (int c = 0; c < 3; c++) colours[3 * v + c] = v * (40 + c) % 65536;
            }
            int[] groups = new int[2 * n];
            int[] quality = new int[2 * n];
            for (int f = 0; f < 2 * n; f++) {
                groups[f] = f / 500 % 3;
                quality[f] = Float.floatToRawIntBits(f / 3f);
            }
            return torus().positions(positions)
                    .channels(List.of(
                            new Channel(Channel.Semantic.COLOUR, "colour", 3, Channel.Type.UINT16, colours, null),
                            new Channel(Channel.Semantic.CUSTOM, "time", 1, Channel.Type.FLOAT64, times, null),
                            new Channel(Channel.Semantic.CUSTOM, "id", 1, Channel.Type.UINT32, ids, null)))
                    .faceChannels(List.of(
                            new FaceChannel(
                                    FaceChannel.GROUP,
                                    1,
                                    Channel.Type.INT32,
                                    groups,
                                    List.of("hull", "deck", "Mast ⛵")),
                            new FaceChannel("quality", 1, Channel.Type.FLOAT32, quality, List.of())))
                    .build();
        }
    },
    /** Normals, of which some are absent, and texture coordinates with a seam. */
    SEAMED {
        @Override
        Mesh mesh() {
            int wedges = (AROUND + 1) * ALONG;
            int[] wedgeVertices = new int[wedges];
            int[] uv = new int[2 * wedges];
            int[] normals = new int[3 * wedges];
            BitSet absent = new BitSet();
            for (int j = 0; j < ALONG; j++) {
                for (int i = 0; i <= AROUND; i++) {
                    int w = j * (AROUND + 1) + i;
                    wedgeVertices[w] = j * AROUND + i % AROUND;
                    uv[2 * w] = Float.floatToRawIntBits((float) i / AROUND);
                    uv[2 * w + 1] = Float.floatToRawIntBits((float) j / ALONG);
                    if (i % 7 == 3) {
                        absent.set(w);
                        continue;
                    }
                    double angle = 2 * Math.PI * i / AROUND;
                    normals[3 * w] = Float.floatToRawIntBits((float) Math.cos(angle));
                    normals[3 * w + 2] = Float.floatToRawIntBits((float) Math.sin(angle));
                }
            }
            int[] faces = new int[6 * AROUND * ALONG];
            int at = 0;
            for (int j = 0; j < ALONG; j++) {
                for (int i = 0; i < AROUND; i++) {
                    int a = j * (AROUND + 1) + i;
                    int b = (j + 1) % ALONG * (AROUND + 1) + i;
                    for (int w : new int[] {a, b, a + 1, a + 1, b, b + 1}) faces[at++] = w;
                }
            }
            return torus().wedgeVertices(wedgeVertices)
                    .faceWedges(faces)
                    .channels(List.of(
                            new Channel(Channel.Semantic.NORMAL, "normal", 3, Channel.Type.FLOAT32, normals, absent),
                            new Channel(Channel.Semantic.TEXCOORD, "uv", 2, Channel.Type.FLOAT32, uv, null)))
                    .build();
        }
    },
    /**
     * A torus and its mirror image in decimals read with float32 arithmetic, with normals that mirror each other and
     * texture coordinates in charts alike.
     */
    MIRRORED {
        @Override
        Mesh mesh() {
            Mesh half = torus().build();
            int n = half.vertices();
            float[] positions = new float[6 * n];
            int[] normals = new int[6 * n];
            int[] uv = new int[4 * n];
            for (int v = 0; v < 2 * n; v++) {
                double side = v < n ? 1 : -1;
                for (int a = 0; a < 3; a++) {
                    double x = half.positions()[3 * (v % n) + a];
                    positions[3 * v + a] = decimal(a == 0 ? side * (x - 2.5) : x);
                    double normal = Math.sin(v % n * (a + 2)) * (a == 0 ? side : 1);
                    normals[3 * v + a] = Float.floatToRawIntBits(decimal(normal));
                }
                double u = v % n % AROUND / (2.0 * AROUND) + .003 * Math.sin(v % n);
                uv[2 * v] = Float.floatToRawIntBits(decimal(.5 + side * u));
                uv[2 * v + 1] = Float.floatToRawIntBits(decimal((double) (v % n / AROUND) / ALONG));
            }
            int[] faces = new int[6 * half.faces()];
            for (int c = 0; c < faces.length; c++) {
                int mirrored = c / 3 - half.faces();
                faces[c] = mirrored < 0 ? half.faceWedges()[c] : n + half.vertex(mirrored, 2 - c % 3);
            }
            return new MeshBuilder()
                    .positions(positions)
                    .faceWedges(faces)
                    .channels(List.of(
                            new Channel(Channel.Semantic.NORMAL, "normal", 3, Channel.Type.FLOAT32, normals, null),
                            new Channel(Channel.Semantic.TEXCOORD, "uv", 2, Channel.Type.FLOAT32, uv, null)))
                    .build();
        }

        private float decimal(double x) {
            return Math.round(x * 1e5) * 1e-5f;
        }
    };

    private static final int AROUND = 60;
    private static final int ALONG = 40;

    abstract Mesh mesh();

    private static MeshBuilder torus() {
        float[] positions = new float[3 * AROUND * ALONG];
        int[] faces = new int[6 * AROUND * ALONG];
        int at = 0;
        for (int j = 0; j < ALONG; j++) {
            for (int i = 0; i < AROUND; i++) {
                double u = 2 * Math.PI * i / AROUND;
                double v = 2 * Math.PI * j / ALONG;
                double r = .4 + .03 * Math.sin(5 * u) * Math.cos(3 * v);
                int a = j * AROUND + i;
                positions[3 * a] = (float) ((1 + r * Math.cos(v)) * Math.cos(u));
                positions[3 * a + 1] = (float) (r * Math.sin(v));
                positions[3 * a + 2] = (float) ((1 + r * Math.cos(v)) * Math.sin(u));
                int b = (j + 1) % ALONG * AROUND + i;
                int right = j * AROUND + (i + 1) % AROUND;
                int across = (j + 1) % ALONG * AROUND + (i + 1) % AROUND;
                for (int w : new int[] {a, b, right, right, b, across}) faces[at++] = w;
            }
        }
        return new MeshBuilder().positions(positions).faceWedges(faces);
    }
}
