package org.jsmesh.encode;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jsmesh.display.DisplayMaterial;
import org.jsmesh.display.RenderMesh;
import org.jsmesh.display.Slot;
import org.jsmesh.display.TextureUse;
import org.jsmesh.encode.write.SharedImage;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Picture;

/**
 * Points spread evenly over the area of a mesh. Finds the place of each point on the images that its material shows.
 */
final class PaintedPoints {
    static final int POINTS = 1 << 17;
    private static final double STEP_1 = 0.7548776662466927; // R2 of Roberts 2018
    private static final double STEP_2 = 0.5698402909980532;
    private final Mesh mesh;
    private final PaintedImage[] images;

    /**
     * @param images of the mesh
     * @param pictures of those images that can be read, under any of their paths
     */
    PaintedPoints(Mesh mesh, List<SharedImage> images, List<Picture> pictures) {
        this.mesh = mesh;
        this.images = new PaintedImage[images.size()];
        if (images.isEmpty() || mesh.channel(Channel.Semantic.TEXCOORD) == null) return;
        Channel[] sets = RenderMesh.textureSets(mesh);
        Map<String, Integer> byPath = new HashMap<>();
        for (int i = 0; i < images.size(); i++) for (String path : images.get(i).paths()) byPath.put(path, i);
        Picture[] read = new Picture[images.size()];
        for (Picture p : pictures) if (byPath.containsKey(p.path())) read[byPath.get(p.path())] = p;
        List<List<ImageUse>> uses = new ArrayList<>();
        for (int m = 0; m < mesh.materials().size(); m++) {
            uses.add(new ArrayList<>());
            DisplayMaterial look = DisplayMaterial.of(mesh.materials().get(m), false);
            for (Map.Entry<Slot, TextureUse> entry : look.textures().entrySet()) {
                Integer image = byPath.get(entry.getValue().path());
                Channel set = sets[entry.getValue().set()];
                if (image == null || set == null) continue;
                if (this.images[image] == null) this.images[image] = new PaintedImage(read[image]);
                ImageUse use = new ImageUse(look, entry.getKey(), entry.getValue(), set, this.images[image]);
                uses.get(m).add(use);
            }
        }
        cover(uses);
        spread(uses);
    }

    /** The points that show an image, or null when none can. */
    PaintedImage of(int image) {
        return images[image];
    }

    private void cover(List<List<ImageUse>> uses) {
        double[] corners = new double[6];
        double[] place = new double[2];
        for (int f = 0; f < mesh.faces(); f++) {
            int material = mesh.faceMaterials()[f];
            if (material < 0) continue;
            for (ImageUse use : uses.get(material)) {
                for (int k = 0; k < 3; k++) {
                    use.place(mesh, f, k == 1 ? 1 : 0, k == 2 ? 1 : 0, place);
                    corners[2 * k] = place[0];
                    corners[2 * k + 1] = place[1];
                }
                use.image().cover(corners, use);
            }
        }
    }

    private void spread(List<List<ImageUse>> uses) {
        double[] upTo = new double[mesh.faces()];
        double area = 0;
        for (int f = 0; f < upTo.length; f++) upTo[f] = area += area(f);
        int face = 0;
        double[] place = new double[2];
        for (int i = 0; i < POINTS; i++) {
            double at = (i + .5) / POINTS * area;
            while (face < upTo.length - 1 && upTo[face] <= at) face++;
            int material = mesh.faceMaterials()[face];
            if (material < 0) continue;
            double u = fraction(i * STEP_1);
            double v = fraction(i * STEP_2);
            if (u + v > 1) {
                u = 1 - u;
                v = 1 - v;
            }
            for (ImageUse use : uses.get(material)) {
                use.place(mesh, face, u, v, place);
                use.image().add(use, use.wrapped(place[0], true), use.wrapped(place[1], false));
            }
        }
    }

    private double area(int face) {
        float[] p = mesh.positions();
        int a = 3 * mesh.vertex(face, 0);
        int b = 3 * mesh.vertex(face, 1);
        int c = 3 * mesh.vertex(face, 2);
        double sum = 0;
        for (int k = 0; k < 3; k++) {
            int l = (k + 1) % 3;
            double n = ((double) p[b + k] - p[a + k]) * ((double) p[c + l] - p[a + l])
                    - ((double) p[b + l] - p[a + l]) * ((double) p[c + k] - p[a + k]);
            sum += n * n;
        }
        return Math.sqrt(sum) / 2;
    }

    private static double fraction(double x) {
        return x - Math.floor(x);
    }
}
