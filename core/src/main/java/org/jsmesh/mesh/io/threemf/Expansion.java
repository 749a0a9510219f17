package org.jsmesh.mesh.io.threemf;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Texture;
import org.jsmesh.mesh.io.zip.PackedException;

/** Puts the objects where build items and components want them, within {@link ExpansionLimits}. */
final class Expansion {
    /** Coordinates far away for the size of the model need double precision when float32 moves them by more. */
    private static final double MOST_MOVED = 1e-6;

    private final ThreeMfPackage source;
    private final PackageNotes notes;
    private final DoubleRow positions = new DoubleRow();
    private final IntRow corners = new IntRow();
    private final IntRow faceMaterials = new IntRow();
    private final IntRow argb = new IntRow();
    private final IntRow cornerColours = new IntRow();
    private final DoubleRow uv = new DoubleRow();
    private final IntRow cornerUv = new IntRow();
    private final IntRow faceNames = new IntRow();
    private final List<String> names = new ArrayList<>(List.of(""));
    private final Map<String, Integer> nameNumbers = new HashMap<>(Map.of("", 0));
    private final List<Material> materials = new ArrayList<>();
    private final Map<Material, Integer> materialNumbers = new HashMap<>();
    private final List<Texture> textures = new ArrayList<>();
    private final Set<String> textureTried = new HashSet<>();
    /** Where the rows of properties begin in {@link #argb} or {@link #uv}. */
    private final Map<ModelPart.Properties, Integer> firstRows = new IdentityHashMap<>();

    private final Set<ModelPart.Item> built = Collections.newSetFromMap(new IdentityHashMap<>());
    private boolean moved;

    Expansion(ThreeMfPackage source, PackageNotes notes) {
        this.source = source;
        this.notes = notes;
    }

    ThreeMfMesh build(ModelPart root) throws ThreeMfException, PackedException {
        for (ModelPart.Reference item : root.build) instance(root, item, null);
        notes.usedObjects = built.size();
        float[] coordinates = new float[uv.size];
        for (int i = 0; i < coordinates.length; i++) coordinates[i] = (float) uv.values[i];
        return new ThreeMfMesh(
                Arrays.copyOf(positions.values, positions.size),
                notes.isFloat && !(moved && isFar()),
                copy(corners),
                copy(faceMaterials),
                materials,
                textures,
                copy(argb),
                copy(cornerColours),
                coordinates,
                copy(cornerUv),
                copy(faceNames),
                names);
    }

    private static int[] copy(IntRow row) {
        return Arrays.copyOf(row.values, row.size);
    }

    private boolean isFar() {
        double most = 0;
        double extent = 0;
        for (int axis = 0; axis < 3; axis++) {
            double low = Double.POSITIVE_INFINITY;
            double high = Double.NEGATIVE_INFINITY;
            for (int i = axis; i < positions.size; i += 3) {
                low = Math.min(low, positions.values[i]);
                high = Math.max(high, positions.values[i]);
            }
            if (low > high) return false;
            most = Math.max(most, Math.max(Math.abs(low), Math.abs(high)));
            extent = Math.max(extent, high - low);
        }
        return Math.ulp((float) most) > MOST_MOVED * extent;
    }

    private void instance(ModelPart from, ModelPart.Reference reference, double[] outer)
            throws ThreeMfException, PackedException {
        ModelPart part = source.part(from, reference);
        ModelPart.Item item = source.object(part, reference);
        built.add(item);
        double[] transform = Matrix.product(reference.transform(), outer);
        append(part, item, transform);
        for (ModelPart.Reference component : item.components) instance(part, component, transform);
    }

    private void append(ModelPart part, ModelPart.Item item, double[] transform)
            throws ThreeMfException, PackedException {
        int width = ModelPart.Item.WIDTH;
        int triangles = item.triangles.size / width;
        int first = positions.size / 3;
        appendPositions(part, item.positions, transform);
        boolean mirror = transform != null && Matrix.isMirror(transform);
        int name = nameNumbers.computeIfAbsent(item.name, n -> {
            names.add(n);
            return names.size() - 1;
        });
        int[] order = mirror ? new int[] {0, 2, 1} : new int[] {0, 1, 2};
        for (int t = 0; t < triangles; t++) {
            int at = t * width;
            int[] row = item.triangles.values;
            for (int corner : order) corners.add(first + row[at + corner]);
            faceNames.add(name);
            property(part, row, at, order);
        }
    }

    private void appendPositions(ModelPart part, DoubleRow given, double[] transform) throws ThreeMfException {
        moved |= transform != null;
        for (int i = 0; i < given.size; i += 3) {
            double[] p = given.values;
            for (int axis = 0; axis < 3; axis++) {
                double value =
                        transform == null ? p[i + axis] : Matrix.apply(transform, axis, p[i], p[i + 1], p[i + 2]);
                if (!Float.isFinite((float) value))
                    throw new ThreeMfException(
                            part.path,
                            "a transform moves a vertex beyond the range of float32",
                            "Scale the model down");
                positions.add(value);
            }
        }
    }

    private void property(ModelPart part, int[] row, int at, int[] order) throws PackedException {
        int id = row[at + 3];
        ModelPart.Properties properties = id < 0 ? null : part.properties.get(id);
        boolean valid = properties != null;
        for (int i = 0; i < 3 && valid; i++) valid = row[at + 4 + i] >= 0 && row[at + 4 + i] < properties.size();
        if (id >= 0 && !valid) PackageNotes.keep(notes.properties, "pid " + id);
        int material = -1;
        int colours = -1;
        int coordinates = -1;
        if (valid && properties instanceof ModelPart.BaseMaterials base) {
            material = number(base(base, row[at + 4]));
        } else if (valid && properties instanceof ModelPart.Colours group) {
            colours = firstRows.computeIfAbsent(group, g -> appendColours(group.argb()));
        } else if (valid && properties instanceof ModelPart.TextureCoordinates group) {
            coordinates = firstRows.computeIfAbsent(group, g -> appendUv(group.uv()));
            material = number(texture(part.textures.get(group.texture())));
        }
        faceMaterials.add(material);
        for (int corner : order) {
            cornerColours.add(colours < 0 ? -1 : colours + row[at + 4 + corner]);
            cornerUv.add(coordinates < 0 ? -1 : coordinates + row[at + 4 + corner]);
        }
    }

    private int appendColours(IntRow added) {
        int first = argb.size;
        for (int i = 0; i < added.size; i++) argb.add(added.values[i]);
        return first;
    }

    private int appendUv(DoubleRow added) {
        int first = uv.size / 2;
        for (int i = 0; i < added.size; i++) uv.add(added.values[i]);
        return first;
    }

    private int number(Material material) {
        if (material == null) return -1;
        return materialNumbers.computeIfAbsent(material, m -> {
            materials.add(m);
            return materials.size() - 1;
        });
    }

    private static Material base(ModelPart.BaseMaterials group, int index) {
        int colour = group.argb().values[index];
        List<Material.Parameter> parameters = new ArrayList<>();
        parameters.add(new Material.Parameter("rgb", part(colour, 16), part(colour, 8), part(colour, 0)));
        if (colour >>> 24 != 0xFF) parameters.add(new Material.Parameter("d", part(colour, 24)));
        return new Material(group.names().get(index), parameters, List.of());
    }

    private static float part(int colour, int shift) {
        return (colour >> shift & 0xFF) / 255f;
    }

    /** Null when the file names no texture. */
    private Material texture(String path) throws PackedException {
        if (path == null) return null;
        if (textureTried.add(path)) {
            byte[] image = source.find(path);
            if (image == null) PackageNotes.keep(notes.textures, path);
            else textures.add(new Texture(path, image));
        }
        return new Material(path, List.of(), List.of(new Material.TextureReference("map_Kd", path)));
    }
}
