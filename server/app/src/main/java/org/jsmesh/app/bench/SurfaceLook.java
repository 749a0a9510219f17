package org.jsmesh.app.bench;

import java.util.List;
import java.util.Set;
import org.jsmesh.display.DisplayMaterial;
import org.jsmesh.display.RenderMesh;
import org.jsmesh.display.Slot;
import org.jsmesh.display.TextureUse;
import org.jsmesh.encode.measure.SurfaceProbe;
import org.jsmesh.mesh.Mesh;

/** What a mesh looks like at places on its surface, as the viewers draw it: colour and normal. */
final class SurfaceLook {
    /** Of models without any colour. */
    private static final double GREY = .8;

    private static final List<Slot> SURFACE =
            List.of(Slot.NORMAL, Slot.BUMP, Slot.OPACITY, Slot.OCCLUSION, Slot.METALLIC, Slot.ROUGHNESS);
    /** How much of white the light changes when a value of these images changes from black to white. */
    private static final double[] WEIGHTS = {.8, .2, .5, .2, .1, .1};

    /** Numbers that {@link #surface} writes. */
    static final int SURFACE_VALUES = 2 * SURFACE.size();

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
        ofMaterial(material(places, place), places, place, rgb);
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
        double[] pixel = new double[4];
        boolean imageShown = sample(material.textures().get(Slot.COLOUR), places, place, pixel);
        List<Float> colour = material.colour(imageShown);
        float[] plain = material.plain();
        for (int k = 0; k < 3; k++) {
            double factor = colour == null ? GREY : material.linear() ? plain[k] : colour.get(k);
            rgb[k] = imageShown ? pixel[k] * factor : factor;
        }
    }

    /** Writes the light that the surface sends out at a place, 0 to 1; none before an image of it has arrived. */
    void emission(SurfaceProbe.Places places, int place, double[] rgb) {
        DisplayMaterial material = material(places, place);
        List<Float> light = material.emission();
        TextureUse use = material.textures().get(Slot.EMISSION);
        double[] pixel = {1, 1, 1, 1};
        boolean isThere = light != null && (use == null || sample(use, places, place, pixel));
        for (int k = 0; k < 3; k++) rgb[k] = isThere ? Math.min(1, light.get(k)) * pixel[k] : 0;
    }

    /**
     * Writes what other images say of the surface at a place: normals, heights, opacity, occlusion, metal, roughness.
     * The numbers are weighted with what they do to the light that the surface throws back.
     */
    void surface(SurfaceProbe.Places places, int place, double[] values) {
        DisplayMaterial material = material(places, place);
        double[] pixel = new double[4];
        for (int i = 0; i < SURFACE.size(); i++) {
            Slot slot = SURFACE.get(i);
            TextureUse use = material.textures().get(slot);
            boolean isShown = sample(use, places, place, pixel);
            boolean isNormal = slot == Slot.NORMAL;
            double x = isShown ? pixel[use.channel() < 0 ? 0 : use.channel()] : isNormal ? .5 : 1;
            values[2 * i] = WEIGHTS[i] * x;
            values[2 * i + 1] = isNormal ? WEIGHTS[i] * (isShown ? pixel[1] : .5) : 0;
        }
    }

    private DisplayMaterial material(SurfaceProbe.Places places, int place) {
        int slot = drawn.slots().slot(mesh.faceMaterials()[places.faces()[place]]);
        return drawn.slots().materials().get(slot);
    }

    /** Reads an image at a place; false when it is not shown. */
    private boolean sample(TextureUse use, SurfaceProbe.Places places, int place, double[] rgba) {
        if (use == null || !shown.contains(use.path()) || !images.has(use.path())) return false;
        float[][] sets = drawn.textureCoordinates();
        if (use.set() >= sets.length || sets[use.set()].length == 0) return false;
        double u = mean(sets[use.set()], 2, 0, places, place);
        double v = mean(sets[use.set()], 2, 1, places, place);
        List<Float> t = use.transform();
        images.sample(use, t.get(0) * u + t.get(1) * v + t.get(2), t.get(3) * u + t.get(4) * v + t.get(5), rgba);
        return true;
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
