package org.jsmesh.desktop.draw;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import javax.imageio.ImageIO;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.Texture;
import org.jsmesh.studio.Lighting;

/** Meshes made in code, with every attribute that a viewer draws. */
public final class Shapes {
    private Shapes() {}

    /**
     * A closed wavy torus around the z axis, radii 3 and about 1, off the origin, {@code 2 · around · across} faces,
     * without attributes.
     */
    public static Mesh torus(int around, int across) {
        return torusBuilder(around, across).build();
    }

    /** From −1 to 1, a vertex per corner, without attributes. */
    public static Mesh cube() {
        float[] positions = new float[24];
        for (int i = 0; i < 24; i++) positions[i] = (i / 3 >> i % 3 & 1) == 0 ? -1 : 1;
        return new MeshBuilder()
                .positions(positions)
                .faceWedges(new int[] {
                    0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7,
                    4, 7, 6
                })
                .build();
    }

    private static MeshBuilder torusBuilder(int around, int across) {
        float[] positions = new float[3 * around * across];
        int[] faces = new int[6 * around * across];
        for (int i = 0; i < around; i++) {
            for (int j = 0; j < across; j++) {
                int v = i * across + j;
                double a = 2 * Math.PI * i / around;
                double b = 2 * Math.PI * j / across;
                double r = 1 + .15 * Math.sin(5 * a) * Math.cos(2 * b);
                positions[3 * v] = (float) (10 + (3 + r * Math.cos(b)) * Math.cos(a));
                positions[3 * v + 1] = (float) (-4 + (3 + r * Math.cos(b)) * Math.sin(a));
                positions[3 * v + 2] = (float) (r * Math.sin(b));
                int right = (i + 1) % around * across + j;
                int up = i * across + (j + 1) % across;
                int both = (i + 1) % around * across + (j + 1) % across;
                int[] quad = {v, right, both, v, both, up};
                System.arraycopy(quad, 0, faces, 6 * v, 6);
            }
        }
        return new MeshBuilder().positions(positions).faceWedges(faces);
    }

    /** The torus with colours per vertex. */
    public static Mesh colouredTorus(int around, int across) {
        int[] colours = new int[3 * around * across];
        for (int v = 0; v < around * across; v++) {
            double a = 2 * Math.PI * (v / across) / around;
            colours[3 * v] = (int) Math.round(127 + 127 * Math.sin(a));
            colours[3 * v + 1] = (int) Math.round(127 + 127 * Math.sin(a + 2));
            colours[3 * v + 2] = (int) Math.round(127 + 127 * Math.sin(a + 4));
        }
        return torusBuilder(around, across)
                .channels(List.of(new Channel(Channel.Semantic.COLOUR, "colour", 3, Channel.Type.UINT8, colours, null)))
                .build();
    }

    /** The torus in red, green and blue thirds. */
    public static Mesh paintedTorus(int around, int across) {
        Mesh plain = torus(around, across);
        int[] materials = new int[plain.faces()];
        for (int f = 0; f < materials.length; f++) materials[f] = 2 - (int) (3L * f / materials.length);
        return MeshBuilder.from(plain)
                .faceMaterials(materials)
                .materials(List.of(
                        new Material("blue", List.of(new Material.Parameter("Kd", .2f, .3f, .9f)), List.of()),
                        new Material("green", List.of(new Material.Parameter("rgb", .2f, .7f, .3f)), List.of()),
                        new Material("red", List.of(), List.of(), gltf("\"baseColorFactor\":[0.6,0.1,0.1,1]"))))
                .build();
    }

    /**
     * A square that faces +z, [−1, 1]² at z = 0, with a normal for each wedge and an image of four quarters: red and
     * green above, blue and yellow below.
     *
     * @param key {@code map_Kd} (v grows upwards) or {@code baseColorTexture} (v grows downwards)
     */
    public static Mesh texturedSquare(String key) {
        boolean fromTop = key.equals("baseColorTexture");
        float[] corners = {0, 0, 1, 0, 1, 1, 0, 1};
        int[] uv = new int[8];
        for (int i = 0; i < 8; i++) {
            uv[i] = Float.floatToIntBits(fromTop && i % 2 == 1 ? 1 - corners[i] : corners[i]);
        }
        int[] normals = new int[12];
        for (int w = 0; w < 4; w++) normals[3 * w + 2] = Float.floatToIntBits(1);
        List<Material.TextureReference> image = List.of(new Material.TextureReference(key, "images/tiles.png"));
        String definition = fromTop ? gltf("\"baseColorTexture\":{\"index\":{\"source\":0}}") : "";
        Material material = new Material("tiles", List.of(), image, definition);
        return new MeshBuilder()
                .positions(new float[] {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0})
                .faceWedges(new int[] {0, 1, 2, 0, 2, 3})
                .faceMaterials(new int[2])
                .materials(List.of(material))
                .textures(List.of(new Texture("images/tiles.png", tiles())))
                .channels(List.of(
                        new Channel(Channel.Semantic.NORMAL, "normal", 3, Channel.Type.FLOAT32, normals, null),
                        new Channel(Channel.Semantic.TEXCOORD, "uv", 2, Channel.Type.FLOAT32, uv, null)))
                .build();
    }

    /** As matte as materials that do not say it. */
    private static String gltf(String colour) {
        return "{\"pbrMetallicRoughness\":{" + colour + ",\"metallicFactor\":0,\"roughnessFactor\":"
                + Lighting.PLAIN_ROUGHNESS + "}}";
    }

    private static byte[] tiles() {
        BufferedImage image = new BufferedImage(64, 64, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        Color[] colours = {Color.RED, Color.GREEN, Color.BLUE, Color.YELLOW};
        for (int i = 0; i < 4; i++) {
            g.setColor(colours[i]);
            g.fillRect(i % 2 * 32, i / 2 * 32, 32, 32);
        }
        g.dispose();
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        try {
            ImageIO.write(image, "png", out);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return out.toByteArray();
    }
}
