package org.jsmesh.app.bench;

import java.util.Set;
import org.jsmesh.display.CornerNormals;
import org.jsmesh.encode.measure.SurfaceProbe;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;

/** What a mesh looks like at places on its surface, as the page draws it: colour and normal. */
final class SurfaceLook {
    private static final double PLAIN = .8;

    private final Mesh mesh;
    private final CornerNormals normals;
    private final ImageSamples images;
    private final Set<String> shown;
    private final Channel colours;
    private final Channel coordinates;

    /**
     * @param creaseCosine cosine of the angle between faces from which on an edge is a crease
     * @param shown paths of the images that have arrived
     */
    SurfaceLook(Mesh mesh, double creaseCosine, ImageSamples images, Set<String> shown) {
        this.mesh = mesh;
        this.images = images;
        this.shown = shown;
        normals = new CornerNormals(mesh, creaseCosine);
        colours = withComponents(Channel.Semantic.COLOUR, 3);
        coordinates = withComponents(Channel.Semantic.TEXCOORD, 2);
    }

    private Channel withComponents(Channel.Semantic semantic, int least) {
        Channel channel = mesh.channel(semantic);
        return channel == null || channel.components() < least ? null : channel;
    }

    /** Writes the unit normal at a place. */
    void normal(SurfaceProbe.Places places, int place, double[] normal) {
        float[] corners = new float[9];
        double length = 0;
        for (int k = 0; k < 3; k++) normals.copy(3 * places.faces()[place] + k, corners, k);
        for (int axis = 0; axis < 3; axis++) {
            normal[axis] = 0;
            for (int k = 0; k < 3; k++) normal[axis] += places.weights()[3 * place + k] * corners[3 * k + axis];
            length += normal[axis] * normal[axis];
        }
        for (int axis = 0; axis < 3 && length > 0; axis++) normal[axis] /= Math.sqrt(length);
    }

    /** Writes red, green, blue at a place, 0 to 1: image or colour of the material, times that of the wedges. */
    void colour(SurfaceProbe.Places places, int place, double[] rgb) {
        int id = mesh.faceMaterials()[places.faces()[place]];
        Material material = id < 0 ? null : mesh.materials().get(id);
        ofMaterial(material, places, place, rgb);
        if (colours == null) return;
        for (int k = 0; k < 3; k++) rgb[k] *= mean(colours, k, places, place);
    }

    private void ofMaterial(Material material, SurfaceProbe.Places places, int place, double[] rgb) {
        float[] own = material == null ? null : material.displayColour();
        String image = material == null ? null : material.displayTexture();
        boolean fromTop = material != null && material.parameter("baseColorFactor") != null;
        if (image != null && shown.contains(image) && images.has(image) && coordinates != null) {
            double u = mean(coordinates, 0, places, place);
            images.sample(image, u, mean(coordinates, 1, places, place), fromTop, rgb);
            if (fromTop) for (int k = 0; k < 3; k++) rgb[k] *= own[k];
            return;
        }
        // Many models give what has an image a black that nobody is to see.
        boolean isPlain = own == null ? colours == null : image != null && own[0] + own[1] + own[2] == 0;
        for (int k = 0; k < 3; k++) rgb[k] = isPlain ? PLAIN : own == null ? 1 : own[k];
    }

    private double mean(Channel channel, int component, SurfaceProbe.Places places, int place) {
        double sum = 0;
        for (int k = 0; k < 3; k++) {
            int wedge = mesh.faceWedges()[3 * places.faces()[place] + k];
            double value = channel.isAbsent(wedge) ? 1 : channel.number(wedge, component);
            sum += places.weights()[3 * place + k] * value;
        }
        return sum;
    }
}
