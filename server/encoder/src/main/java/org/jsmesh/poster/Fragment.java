package org.jsmesh.poster;

import org.jsmesh.display.RenderMesh;
import org.jsmesh.display.Slot;
import org.jsmesh.studio.LinearColour;

/** What is seen of a face at a place of the picture. Values are set by face, then by place. Used by one thread. */
final class Fragment {
    /**
     * Cosines between the eye and normals that point away: up to the first they are bent, from the second on turned.
     */
    private static final double BENT = .1;

    private static final double TURNED = .4;

    private final RenderMesh mesh;
    private final Raster raster;
    private final View view;
    private final Shine shine;
    private final float[] placed;
    private final float[] normals;
    private final float[] tangents;
    private final int samplesPerPixel;
    private final Image[] images = new Image[Slot.values().length];
    private final double[] slopes = new double[4];
    private final int[] corners = new int[3];
    private final double[] share = new double[3];
    private final double[] texel = new double[4];
    private final double[] place = new double[3];
    private final double[] raw = new double[3]; // the normal, not turned to the eye
    private int face = -1;
    private Surface surface;
    private boolean isFront;
    private double bend;

    /** Red, green, blue, each 0 to 255, and opacity of what was seen last. */
    final double[] rgb = new double[3];

    double opacity;

    Fragment(RenderMesh mesh, float[] placed, Raster raster, View view, int samplesPerPixel) {
        this.mesh = mesh;
        this.placed = placed;
        this.raster = raster;
        this.view = view;
        this.samplesPerPixel = samplesPerPixel;
        normals = view.turned(mesh.normals(), 3);
        tangents = view.turned(mesh.tangents(), 4);
        shine = new Shine(view);
    }

    /** Goes to a face. */
    void of(int newFace, Surface newSurface) {
        if (face == newFace) return;
        face = newFace;
        surface = newSurface;
        for (int k = 0; k < 3; k++) corners[k] = mesh.indices()[3 * face + k];
        double area = raster.area(face);
        isFront = area > 0;
        for (Slot slot : Slot.values()) {
            Surface.Use use = surface.use(slot);
            if (use != null) images[slot.ordinal()] = use.image().of(pixels(use) / Math.abs(area));
        }
        raster.slopes(face, slopes);
        bend = 0;
        for (int k = 0; k < 3; k++) {
            double one = normals[3 * corners[1] + k] - normals[3 * corners[0] + k];
            double two = normals[3 * corners[2] + k] - normals[3 * corners[0] + k];
            bend = Math.max(bend, Math.abs(one * slopes[0] + two * slopes[1]));
            bend = Math.max(bend, Math.abs(one * slopes[2] + two * slopes[3]));
        }
        bend *= samplesPerPixel;
    }

    /** Twice the area of the face on an image, in pixels of that. */
    private double pixels(Surface.Use use) {
        float[] uv = mesh.textureCoordinates()[use.set()];
        float[] t = use.transform();
        double u1 = uv[2 * corners[1]] - (double) uv[2 * corners[0]];
        double v1 = uv[2 * corners[1] + 1] - (double) uv[2 * corners[0] + 1];
        double u2 = uv[2 * corners[2]] - (double) uv[2 * corners[0]];
        double v2 = uv[2 * corners[2] + 1] - (double) uv[2 * corners[0] + 1];
        double turned = Math.abs((double) t[0] * t[4] - (double) t[1] * t[3]);
        return Math.abs(u1 * v2 - u2 * v1) * turned * use.image().width * use.image().height;
    }

    /** Sets the place by the shares of the corners on the picture. */
    private void at(double a, double b, double c) {
        double wa = a * raster.nearness(corners[0]);
        double wb = b * raster.nearness(corners[1]);
        double wc = c * raster.nearness(corners[2]);
        double sum = wa + wb + wc;
        share[0] = wa / sum;
        share[1] = wb / sum;
        share[2] = wc / sum;
    }

    private double between(float[] values, int stride, int k) {
        return share[0] * values[stride * corners[0] + k]
                + share[1] * values[stride * corners[1] + k]
                + share[2] * values[stride * corners[2] + k];
    }

    private boolean read(Slot slot) {
        Surface.Use use = surface.use(slot);
        if (use == null) return false;
        float[] uv = mesh.textureCoordinates()[use.set()];
        double u = between(uv, 2, 0);
        double v = between(uv, 2, 1);
        float[] t = use.transform();
        Image image = images[slot.ordinal()];
        image.at(t[0] * u + t[1] * v + t[2], t[3] * u + t[4] * v + t[5], use.wrapping(), texel);
        return true;
    }

    private double one(Slot slot) {
        return read(slot) ? surface.use(slot).one(texel) : 1;
    }

    /** Finds colour and opacity without light; returns whether the surface is there. */
    boolean isThere(double a, double b, double c) {
        at(a, b, c);
        for (int k = 0; k < 3; k++) shine.albedo[k] = surface.base[k];
        opacity = surface.base[3];
        if (mesh.colours().length > 0) tint();
        if (read(Slot.COLOUR)) {
            for (int k = 0; k < 3; k++) shine.albedo[k] *= texel[k];
            if (surface.hasImageOpacity) opacity *= texel[3];
        }
        opacity *= one(Slot.OPACITY);
        if (opacity < surface.cutoff) return false;
        if (!surface.isBlended) opacity = 1;
        return true;
    }

    private void tint() {
        for (int k = 0; k < 4; k++) {
            double mean = 0;
            for (int i = 0; i < 3; i++) {
                int value = mesh.colours()[corners[i]] >> 8 * k & 255;
                mean += share[i] * (k < 3 ? LINEAR[value] : value / 255.);
            }
            if (k < 3) shine.albedo[k] *= mean;
            else opacity *= mean;
        }
    }

    private static final float[] LINEAR = new float[256];

    static {
        for (int i = 0; i < LINEAR.length; i++) LINEAR[i] = LinearColour.linear(i / 255f);
    }

    /** Finds the colour in the scene's light, after {@link #isThere} at the same place. */
    void shine() {
        if (surface.isUnlit) {
            System.arraycopy(shine.albedo, 0, rgb, 0, 3);
        } else {
            turnToEye();
            shine.bend = bend;
            shine.metal = surface.metallic * one(Slot.METALLIC);
            shine.rough = surface.roughness * one(Slot.ROUGHNESS);
            shine.open = 1;
            if (surface.use(Slot.OCCLUSION) != null)
                shine.open += surface.use(Slot.OCCLUSION).factor() * (one(Slot.OCCLUSION) - 1);
            java.util.Arrays.fill(rgb, 0);
            shine.light(surface, rgb);
            boolean isImage = read(Slot.EMISSION);
            for (int k = 0; k < 3; k++) rgb[k] += surface.emission[k] * (isImage ? texel[k] : 1);
        }
        Tone.map(rgb);
    }

    private void turnToEye() {
        for (int k = 0; k < 3; k++) place[k] = view.distance * view.back[k] - between(placed, 3, k);
        normalize(place, shine.toEye);
        for (int k = 0; k < 3; k++) raw[k] = between(normals, 3, k);
        double side = isFront ? 1 : -1;
        if (View.dot(raw, raw) > 0) normalize(raw, raw);
        else for (int k = 0; k < 3; k++) raw[k] = side * shine.toEye[k]; // of no direction: it faces the eye
        turn(shine.plain);
        System.arraycopy(shine.plain, 0, shine.normal, 0, 3);
        if (surface.use(Slot.NORMAL) != null) bump(side);
        else if (surface.use(Slot.BUMP) != null) raise();
    }

    /**
     * The normal of the side that is seen. Near a silhouette, where a face may be seen from either side by a rounding
     * error, it is bent towards the eye instead of turned: both sides get the same light there.
     */
    private void turn(double[] normal) {
        System.arraycopy(raw, 0, normal, 0, 3);
        double away = -View.dot(raw, shine.toEye);
        if (isFront || away <= 0) return;
        double part = Math.min(1, away / TURNED);
        double turned = part * part * (3 - 2 * part);
        for (int k = 0; k < 3; k++) place[k] = (1 - 2 * turned) * raw[k] + 2 * (1 - turned) * away * shine.toEye[k];
        normalize(place, normal);
    }

    /**
     * Bumps of an unparametrized surface (Mikkelsen 2010); heights count per pixel of the picture, as they do on the
     * page.
     */
    private void raise() {
        double[] here = share.clone();
        double height = one(Slot.BUMP);
        double[][] steps = new double[2][3]; // along the surface, to the right and up
        double[] slope = new double[2];
        for (int axis = 0; axis < 2; axis++) {
            double way = axis == 0 ? samplesPerPixel : -samplesPerPixel;
            double b = way * slopes[2 * axis];
            double c = way * slopes[2 * axis + 1];
            move(here, b, c);
            slope[axis] = surface.use(Slot.BUMP).factor() * (one(Slot.BUMP) - height);
            for (int k = 0; k < 3; k++) steps[axis][k] = between(placed, 3, k);
            move(here, 0, 0);
            for (int k = 0; k < 3; k++) steps[axis][k] -= between(placed, 3, k);
        }
        double[] n = shine.plain;
        double[] first = View.cross(View.unit(steps[1]), n);
        double[] second = View.cross(n, View.unit(steps[0]));
        double area = View.dot(View.unit(steps[0]), first) * (isFront ? 1 : -1);
        double sign = Math.signum(area);
        for (int k = 0; k < 3; k++)
            place[k] = Math.abs(area) * n[k] - sign * (slope[0] * first[k] + slope[1] * second[k]);
        if (View.dot(place, place) > 0) normalize(place, shine.normal);
    }

    /** Goes from a place by so much of the second and the third corner on the picture. */
    private void move(double[] from, double b, double c) {
        double[] flat = new double[3];
        double sum = 0;
        for (int k = 0; k < 3; k++) sum += flat[k] = from[k] / raster.nearness(corners[k]);
        at(flat[0] / sum - b - c, flat[1] / sum + b, flat[2] / sum + c);
    }

    /** The normal of the image, in a frame of the vertices' tangents or else of how the place on the image changes. */
    private void bump(double side) {
        Surface.Use use = surface.use(Slot.NORMAL);
        read(Slot.NORMAL);
        double x = (2 * texel[0] - 1) * use.factor();
        double y = (2 * texel[1] - 1) * use.factor();
        double z = 2 * texel[2] - 1;
        double[] tangent = new double[3];
        double[] bitangent;
        double turn = tangents.length == 0 ? 0 : between(tangents, 4, 3);
        if (turn == 0) {
            double[][] frame = frame(use);
            tangent = frame[0];
            bitangent = frame[1];
        } else {
            for (int k = 0; k < 3; k++) tangent[k] = between(tangents, 4, k);
            bitangent = View.unit(View.cross(raw, tangent));
            tangent = View.unit(tangent);
            for (int k = 0; k < 3; k++) bitangent[k] *= Math.signum(turn);
        }
        for (int k = 0; k < 3; k++) place[k] = side * (x * tangent[k] + y * bitangent[k]) + z * shine.plain[k];
        if (View.dot(place, place) > 0) normalize(place, shine.normal);
    }

    private double[][] frame(Surface.Use use) {
        double[] one = new double[3];
        double[] two = new double[3];
        for (int k = 0; k < 3; k++) {
            one[k] = placed[3 * corners[1] + k] - (double) placed[3 * corners[0] + k];
            two[k] = placed[3 * corners[2] + k] - (double) placed[3 * corners[0] + k];
        }
        double[] first = View.cross(two, raw);
        double[] second = View.cross(raw, one);
        double[] tangent = new double[3];
        double[] bitangent = new double[3];
        for (int k = 0; k < 3; k++) {
            tangent[k] = first[k] * step(use, 1, 0) + second[k] * step(use, 2, 0);
            // The image's y points down.
            bitangent[k] = -(first[k] * step(use, 1, 1) + second[k] * step(use, 2, 1));
        }
        double longest = Math.max(View.dot(tangent, tangent), View.dot(bitangent, bitangent));
        double scale = longest == 0 ? 0 : 1 / Math.sqrt(longest);
        for (int k = 0; k < 3; k++) {
            tangent[k] *= scale;
            bitangent[k] *= scale;
        }
        return new double[][] {tangent, bitangent};
    }

    /** How far a corner lies from the first one on the image, across (0) or down (1). */
    private double step(Surface.Use use, int corner, int axis) {
        float[] uv = mesh.textureCoordinates()[use.set()];
        double u = uv[2 * corners[corner]] - (double) uv[2 * corners[0]];
        double v = uv[2 * corners[corner] + 1] - (double) uv[2 * corners[0] + 1];
        return use.transform()[3 * axis] * u + use.transform()[3 * axis + 1] * v;
    }

    private static void normalize(double[] from, double[] to) {
        double length = Math.sqrt(View.dot(from, from));
        for (int k = 0; k < 3; k++) to[k] = from[k] / length;
    }
}
