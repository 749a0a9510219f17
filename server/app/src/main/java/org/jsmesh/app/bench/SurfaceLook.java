package org.jsmesh.app.bench;

import java.util.List;
import java.util.Set;
import org.jsmesh.display.DisplayMaterial;
import org.jsmesh.display.RenderMesh;
import org.jsmesh.encode.measure.SurfaceProbe;
import org.jsmesh.mesh.Mesh;

/** What a mesh looks like at places on its surface, as the viewers draw it: colour and normal. */
final class SurfaceLook {
    /** Of models without any colour. */
    private static final double GREY = .8;

    private final Mesh mesh;
    private final RenderMesh drawn;
    private final int[] firstIndices;
    private final ImageSamples images;
    private final Set<String> shown;

    /**
     * @param creaseCosine cosine of the angle between faces above which an edge is a crease
     * @param shown paths of the images that have arrived
     */
    SurfaceLook(Mesh mesh, double creaseCosine, ImageSamples images, Set<String> shown) {
        this.mesh = mesh;
        this.images = images;
        this.shown = shown;
        drawn = RenderMesh.of(mesh, creaseCosine);
        firstIndices = drawn.firstIndices(mesh);
    }

    /** Writes the unit normal at a place. */
    void normal(SurfaceProbe.Places places, int place, double[] normal) {
        double length = 0;
        for (int axis = 0; axis < 3; axis++) {
            normal[axis] = mean(drawn.normals(), 3, axis, places, place);
            length += normal[axis] * normal[axis];
        }
        for (int axis = 0; axis < 3 && length > 0; axis++) normal[axis] /= Math.sqrt(length);
    }

    /**
     * Writes red, green, blue at a place, 0 to 1: the image or colour of the material, times the colour of the wedges.
     */
    void colour(SurfaceProbe.Places places, int place, double[] rgb) {
        int slot = drawn.slots().slot(mesh.faceMaterials()[places.faces()[place]]);
        ofMaterial(drawn.slots().materials().get(slot), places, place, rgb);
        if (drawn.colours().length == 0) return;
        for (int k = 0; k < 3; k++) {
            double level = 0;
            for (int corner = 0; corner < 3; corner++)
                level +=
                        weight(places, place, corner) * (drawn.colours()[vertex(places, place, corner)] >> 8 * k & 255);
            rgb[k] *= level / 255;
        }
    }

    private void ofMaterial(DisplayMaterial material, SurfaceProbe.Places places, int place, double[] rgb) {
        String image = material.texture();
        boolean imageShown =
                image != null && shown.contains(image) && images.has(image) && drawn.textureCoordinates().length > 0;
        List<Float> colour = material.colour(imageShown);
        if (imageShown) {
            double u = mean(drawn.textureCoordinates(), 2, 0, places, place);
            double v = mean(drawn.textureCoordinates(), 2, 1, places, place);
            images.sample(image, u, v, material.gltf(), rgb);
        }
        for (int k = 0; k < 3; k++) {
            double factor = colour == null ? GREY : colour.get(k);
            rgb[k] = imageShown ? rgb[k] * factor : factor;
        }
    }

    private double mean(float[] values, int components, int component, SurfaceProbe.Places places, int place) {
        double sum = 0;
        for (int corner = 0; corner < 3; corner++)
            sum += weight(places, place, corner) * values[components * vertex(places, place, corner) + component];
        return sum;
    }

    private static double weight(SurfaceProbe.Places places, int place, int corner) {
        return places.weights()[3 * place + corner];
    }

    private int vertex(SurfaceProbe.Places places, int place, int corner) {
        return drawn.indices()[firstIndices[places.faces()[place]] + corner];
    }
}
