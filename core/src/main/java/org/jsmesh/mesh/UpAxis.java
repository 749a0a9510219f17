package org.jsmesh.mesh;

/**
 * Which axis of a model points up when the model stands. Clients turn the picture by it; coordinates stay as they are.
 */
public enum UpAxis {
    /** The model's file does not say. Clients show it as with {@link #Y}. */
    UNKNOWN("unknown"),
    /** +y, as in glTF. */
    Y("y"),
    /** +z, as in 3MF, in CAD and in surveying. */
    Z("z");

    private final String label;

    UpAxis(String label) {
        this.label = label;
    }

    /** {@return {@code unknown}, {@code y} or {@code z}, as reports and manifests have it} */
    public String label() {
        return label;
    }
}
