package org.jsmesh.files.gltf.draco;

import org.jsmesh.files.gltf.packed.PackedBytes;
import org.jsmesh.files.gltf.packed.PackedException;

/**
 * Predicts values of an attribute from those before (Draco specification, "Prediction decoder"). This one predicts the
 * value before.
 */
class Prediction {
    private static final int NONE = -2;
    private static final int PARALLELOGRAM = 1;
    private static final int MULTI_PARALLELOGRAM = 4;
    private static final int TEXTURE_COORDINATES = 5;
    private static final int NORMALS = 6;
    private static final int BY_WRAPPING = 1;
    private static final int ON_OCTAHEDRON = 3;

    final Correction correction;
    final int components;

    Prediction(Correction correction, int components) {
        this.correction = correction;
        this.components = components;
    }

    /** Reads which prediction there is. Null if there is none. */
    static Prediction read(PackedBytes in, boolean normals, int components, ValueOrder order, Positions positions)
            throws PackedException {
        int method = (byte) in.next();
        if (method == NONE) return null;
        int transform = in.next();
        if (transform != (normals ? ON_OCTAHEDRON : BY_WRAPPING)) {
            throw new PackedException("the prediction transform " + transform + " of the Draco mesh is not known");
        }
        if (normals) {
            Octahedron octahedron = new Octahedron();
            boolean geometric = method == NORMALS && order != null;
            return geometric
                    ? new NormalPrediction(octahedron, order, required(positions))
                    : new Prediction(octahedron, components);
        }
        Correction wrapped = new Correction.Wrapped(components);
        if (order == null || method <= 0) return new Prediction(wrapped, components);
        return switch (method) {
            case PARALLELOGRAM -> new ParallelogramPrediction(wrapped, components, order);
            case MULTI_PARALLELOGRAM -> new ParallelogramPrediction.Several(wrapped, components, order);
            case TEXTURE_COORDINATES -> {
                if (components != 2) throw new PackedException("texture coordinates have " + components + " numbers");
                yield new TextureCoordinatePrediction(wrapped, order, required(positions));
            }
            default -> throw new PackedException("the prediction " + method + " of the Draco mesh is not known");
        };
    }

    private static Positions required(Positions positions) throws PackedException {
        if (positions == null) throw new PackedException("attributes are predicted from positions that are not there");
        return positions;
    }

    final boolean hasPositiveCorrections() {
        return correction.isPositive();
    }

    void readData(PackedBytes in) throws PackedException {
        correction.readData(in);
    }

    /** Turns corrections into values, of which there is at least one. */
    void restore(int[] values) throws PackedException {
        correction.correct(new int[components], 0, values, 0);
        for (int at = components; at < values.length; at += components) {
            correction.correct(values, at - components, values, at);
        }
    }
}
