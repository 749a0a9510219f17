package org.jsmesh.mesh;

/** The identity of a mesh: SHA-256 over its distinct corner tuples, materials and faces, in an order that depends on neither ids nor file order. */
public final class MeshIdentity {
    private MeshIdentity() {}

    /** Lower-case hexadecimal, 64 digits. */
    public static String sha256(Mesh mesh) {
        throw new UnsupportedOperationException("not yet");
    }
}
