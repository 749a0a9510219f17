package org.jsmesh.files;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.assertj.core.data.Offset;
import org.jsmesh.display.DisplayMaterial;
import org.jsmesh.display.DisplaySlots;
import org.jsmesh.display.RenderMesh;
import org.jsmesh.display.Slot;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.FaceChannel;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;

/** What is right of models from the field, measured by other means than those of the product. */
final class FieldChecks {
    private static final double CREASE = Math.cos(Math.toRadians(42));

    private FieldChecks() {}

    static Offset<Double> near(double size) {
        return within(Math.abs(size) * 1e-5);
    }

    static double area(Mesh mesh) {
        double area = 0;
        for (int f = 0; f < mesh.faces(); f++) {
            double[] n = normal(mesh, f);
            area += Math.sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) / 2;
        }
        return area;
    }

    /** Perpendicular to a face, twice its area long. */
    private static double[] normal(Mesh mesh, int face) {
        double[] u = edge(mesh, face, 1);
        double[] w = edge(mesh, face, 2);
        return new double[] {u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]};
    }

    private static double[] edge(Mesh mesh, int face, int corner) {
        double[] edge = new double[3];
        for (int k = 0; k < 3; k++)
            edge[k] = mesh.coordinate(mesh.vertex(face, corner), k) - mesh.coordinate(mesh.vertex(face, 0), k);
        return edge;
    }

    static double[] bounds(Mesh mesh) {
        double[] bounds = new double[6];
        Arrays.fill(bounds, 0, 3, Double.POSITIVE_INFINITY);
        Arrays.fill(bounds, 3, 6, Double.NEGATIVE_INFINITY);
        for (int i = 0; i < 3 * mesh.faces(); i++) {
            for (int k = 0; k < 3; k++) {
                double x = mesh.coordinate(mesh.vertex(i / 3, i % 3), k);
                bounds[k] = Math.min(bounds[k], x);
                bounds[3 + k] = Math.max(bounds[3 + k], x);
            }
        }
        return bounds;
    }

    static void oneNormalIsAbsent(Mesh mesh) {
        Channel normals = mesh.channel(Channel.Semantic.NORMAL);
        int absent = 0;
        for (int wedge : mesh.faceWedges()) absent += normals.isAbsent(wedge) ? 1 : 0;
        assertThat(absent).isEqualTo(1);
    }

    static void hasAMaterialPerFaceColour(Mesh mesh) {
        DisplaySlots slots = DisplaySlots.of(mesh.materials(), false);
        int red = 0;
        int blue = 0;
        for (int material : mesh.faceMaterials()) {
            List<Float> colour = slots.materials().get(slots.slot(material)).colour();
            red += isNear(colour, 255, 60, 40) ? 1 : 0;
            blue += isNear(colour, 40, 90, 255) ? 1 : 0;
        }
        assertThat(List.of(red, blue)).containsExactly(264, 264);
    }

    private static boolean isNear(List<Float> colour, int... bytes) {
        for (int i = 0; i < 3; i++) if (Math.abs(colour.get(i) * 255 - bytes[i]) > .01) return false;
        return true;
    }

    static void hasColoursOf16Bits(Mesh mesh) {
        Channel colours = mesh.channel(Channel.Semantic.COLOUR);
        assertThat(colours.type()).isEqualTo(Channel.Type.UINT16);
        assertThat(colours.components()).isEqualTo(3);
        int top = wedgeAt(mesh, 0, 0, 1);
        assertThat(new double[] {colours.exact(top, 0), colours.exact(top, 1), colours.exact(top, 2)})
                .containsExactly(32767, 32767, 65535);
        topIsShownIn(mesh, 127, 127, 255);
    }

    static void hasColoursUpTo255(Mesh mesh) {
        Channel colours = mesh.channel(Channel.Semantic.COLOUR);
        int top = wedgeAt(mesh, 0, 0, 1);
        assertThat(new double[] {colours.exact(top, 0), colours.exact(top, 1), colours.exact(top, 2)})
                .containsExactly(127, 127, 255);
        topIsShownIn(mesh, 127, 127, 255);
    }

    private static void topIsShownIn(Mesh mesh, int red, int green, int blue) {
        RenderMesh drawn = RenderMesh.of(mesh, CREASE);
        int colour = drawn.colours()[renderVertexAt(drawn, 0, 0, 1)];
        assertThat(colour & 0xff).isCloseTo(red, within(1));
        assertThat(colour >> 8 & 0xff).isCloseTo(green, within(1));
        assertThat(colour >> 16 & 0xff).isCloseTo(blue, within(1));
    }

    private static int wedgeAt(Mesh mesh, double x, double y, double z) {
        for (int w = 0; w < mesh.wedges(); w++) {
            int v = mesh.wedgeVertices()[w];
            if (mesh.coordinate(v, 0) == x && mesh.coordinate(v, 1) == y && mesh.coordinate(v, 2) == z) return w;
        }
        throw new AssertionError("no vertex at " + x + " " + y + " " + z);
    }

    private static int renderVertexAt(RenderMesh mesh, float x, float y, float z) {
        float[] p = mesh.positions();
        for (int v = 0; v < mesh.vertices(); v++) {
            if (p[3 * v] == x && p[3 * v + 1] == y && p[3 * v + 2] == z) return v;
        }
        throw new AssertionError("no vertex at " + x + " " + y + " " + z);
    }

    static void hasItsTexture(Mesh mesh) {
        assertThat(mesh.textures()).hasSize(1);
        Material material = mesh.materials().get(mesh.faceMaterials()[0]);
        assertThat(DisplayMaterial.of(material, false).image(Slot.COLOUR))
                .isEqualTo(mesh.textures().get(0).path());
    }

    static void looksAsItsMaterialsSay(Mesh mesh) {
        DisplaySlots slots = DisplaySlots.of(mesh.materials(), false);
        List<String> looks = new ArrayList<>();
        for (int m = 0; m < mesh.materials().size(); m++) {
            DisplayMaterial look = slots.materials().get(slots.slot(m));
            List<Float> c = look.colour();
            looks.add(mesh.materials().get(m).name() + " " + c.get(0) + " " + c.get(1) + " " + c.get(2) + ", opacity "
                    + c.get(3)
                    + ", metal " + look.metallic() + ", rough " + look.roughness() + ", " + look.image(Slot.COLOUR)
                    + ", sends " + look.emission() + ", cut by " + look.image(Slot.OPACITY));
        }
        assertThat(looks)
                .containsExactlyInAnyOrder(
                        "solid_red 0.8 0.05 0.05, opacity 1.0, metal -1.0, rough -1.0, null, sends null, cut by null",
                        "d_half 0.05 0.1 0.8, opacity 0.5, metal -1.0, rough -1.0, null, sends null, cut by null",
                        "Tr_half 0.05 0.6 0.1, opacity 0.5, metal -1.0, rough -1.0, null, sends null, cut by null",
                        "d1_Tr0 0.8 0.6 0.05, opacity 1.0, metal -1.0, rough -1.0, null, sends null, cut by null",
                        "chrome 0.8 0.8 0.8, opacity 1.0, metal 1.0, rough 0.1, null, sends null, cut by null",
                        "glow 0.0 0.0 0.0, opacity 1.0, metal -1.0, rough -1.0, null, sends [0.0, 0.9, 0.9], cut by null",
                        "png 1.0 1.0 1.0, opacity 1.0, metal -1.0, rough -1.0, check.png, sends null, cut by null",
                        "leafAlpha 1.0 1.0 1.0, opacity 1.0, metal -1.0, rough -1.0, leaf.png, sends null, cut by null",
                        "mapd 0.1 0.6 0.1, opacity 1.0, metal -1.0, rough -1.0, null, sends null, cut by mask.png",
                        "tga 1.0 1.0 1.0, opacity 1.0, metal -1.0, rough -1.0, check.tga, sends null, cut by null",
                        "bmp 1.0 1.0 1.0, opacity 1.0, metal -1.0, rough -1.0, check.bmp, sends null, cut by null",
                        "missing 0.1 0.8 0.1, opacity 1.0, metal -1.0, rough -1.0, nowhere.png, sends null, cut by null");
        assertThat(mesh.textures().stream().map(t -> t.path()))
                .containsExactlyInAnyOrder("check.png", "leaf.png", "mask.png", "check.tga", "check.bmp");
    }

    static void isFacettedOnTheLeftAndSmoothOnTheRight(Mesh mesh) {
        RenderMesh drawn = RenderMesh.of(mesh, CREASE);
        int left = 0;
        int right = 0;
        for (int i = 0; i < drawn.indices().length; i++) {
            double cosine = cosineToFace(drawn, i);
            boolean isLeft = drawn.positions()[3 * drawn.indices()[i]] < 1.2;
            if (isLeft) left += cosine > .9999 ? 1 : 0;
            else right += cosine < .999 ? 1 : 0;
        }
        assertThat(left).as("corners with the normal of their face").isEqualTo(3 * 64);
        assertThat(right).as("corners with a normal of their own").isEqualTo(3 * 64);
    }

    /** Of the angle between the normal at a corner and its face. */
    private static double cosineToFace(RenderMesh mesh, int corner) {
        double[][] p = new double[3][3];
        for (int c = 0; c < 3; c++)
            for (int k = 0; k < 3; k++) p[c][k] = mesh.positions()[3 * mesh.indices()[corner / 3 * 3 + c] + k];
        double[] u = {p[1][0] - p[0][0], p[1][1] - p[0][1], p[1][2] - p[0][2]};
        double[] w = {p[2][0] - p[0][0], p[2][1] - p[0][1], p[2][2] - p[0][2]};
        double[] n = {u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]};
        double dot = 0;
        double length = 0;
        for (int k = 0; k < 3; k++) {
            dot += n[k] * mesh.normals()[3 * mesh.indices()[corner] + k];
            length += n[k] * n[k];
        }
        return dot / Math.sqrt(length);
    }

    static void hasScalars(Mesh mesh) {
        Channel confidence = named(mesh, "confidence");
        Channel label = named(mesh, "label");
        assertThat(confidence.semantic()).isEqualTo(Channel.Semantic.CUSTOM);
        assertThat(confidence.type()).isEqualTo(Channel.Type.FLOAT32);
        assertThat(label.type()).isEqualTo(Channel.Type.UINT16);
        int last = wedgeAt(mesh, 0, 1, 1);
        assertThat(confidence.number(last, 0)).isEqualTo(.88f);
        assertThat(label.number(last, 0)).isEqualTo(7);
    }

    private static Channel named(Mesh mesh, String name) {
        return mesh.channels().stream()
                .filter(channel -> channel.name().equals(name))
                .findFirst()
                .orElseThrow(() -> new AssertionError("no channel " + name));
    }

    static void hasGroups(Mesh mesh) {
        FaceChannel groups = mesh.faceChannel(FaceChannel.GROUP);
        FaceChannel objects = mesh.faceChannel(FaceChannel.OBJECT);
        int left = 0;
        int right = 0;
        for (int f = 0; f < mesh.faces(); f++) {
            left += groups.label(f).equals("wheel left") ? 1 : 0;
            right += groups.label(f).equals("wheel right") ? 1 : 0;
            assertThat(objects.label(f)).isEqualTo("Body");
            assertThat(mesh.faceChannel(FaceChannel.SMOOTHING).exact(f, 0)).isEqualTo(1);
        }
        assertThat(List.of(left, right)).containsExactly(6, 6);
    }
}
