package org.jsmesh.mesh.io.threemf;

import java.util.IdentityHashMap;
import java.util.Map;
import org.jsmesh.mesh.io.zip.PackedException;

/**
 * What build items and components make, counted before anything is made of it: a small file can name an object any
 * number of times. Refuses what is more than allowed, components nested too deep, and those of themselves.
 */
final class ExpansionLimits {
    static final int MOST_TRIANGLES = 20_000_000;
    static final int MOST_INSTANCES = 1_000_000;
    static final int DEEPEST = 32;

    /** Larger numbers are as good as this one, and sums of a few of them fit. */
    private static final long ENDLESS = 1L << 40;

    private record Size(long triangles, long vertices, long instances, int depth) {}

    /** Stands for an object that is being counted. */
    private static final Size OPEN = new Size(0, 0, 0, 0);

    private final ThreeMfPackage source;
    private final Map<ModelPart.Item, Size> sizes = new IdentityHashMap<>();

    private ExpansionLimits(ThreeMfPackage source) {
        this.source = source;
    }

    static void check(ThreeMfPackage source, ModelPart root) throws ThreeMfException, PackedException {
        ExpansionLimits limits = new ExpansionLimits(source);
        Size all = OPEN;
        for (ModelPart.Reference item : root.build) all = sum(all, limits.size(root, item, 1));
        if (all.instances > MOST_INSTANCES)
            throw tooMuch(root, "the components make more than " + MOST_INSTANCES + " instances");
        if (all.triangles > MOST_TRIANGLES || all.vertices > MOST_TRIANGLES)
            throw tooMuch(root, "the build makes more than " + MOST_TRIANGLES + " triangles or vertices");
    }

    private static ThreeMfException tooMuch(ModelPart part, String reason) {
        return new ThreeMfException(part.path, reason, "Give a smaller model");
    }

    private Size size(ModelPart from, ModelPart.Reference reference, int depth)
            throws ThreeMfException, PackedException {
        ModelPart part = source.part(from, reference);
        ModelPart.Item item = source.object(part, reference);
        Size known = sizes.get(item);
        if (known == OPEN)
            throw new ThreeMfException(
                    part.path,
                    "object " + reference.object() + " is a component of itself",
                    "Export the model as 3MF anew");
        if (depth + (known == null ? 0 : known.depth - 1) > DEEPEST)
            throw tooMuch(part, "components are nested more than " + DEEPEST + " deep");
        if (known != null) return known;
        sizes.put(item, OPEN);
        Size size = new Size(item.triangles.size / ModelPart.Item.WIDTH, item.positions.size / 3, 1, 1);
        for (ModelPart.Reference component : item.components) {
            Size inner = size(part, component, depth + 1);
            size = sum(size, new Size(inner.triangles, inner.vertices, inner.instances, inner.depth + 1));
        }
        sizes.put(item, size);
        return size;
    }

    private static Size sum(Size a, Size b) {
        return new Size(
                Math.min(ENDLESS, a.triangles + b.triangles),
                Math.min(ENDLESS, a.vertices + b.vertices),
                Math.min(ENDLESS, a.instances + b.instances),
                Math.max(a.depth, b.depth));
    }
}
