package org.jsmesh.files.gltf.packed;

/** Compressed geometry that cannot be decoded. Its message tells what is wrong; the caller knows the place. */
public final class PackedException extends Exception {
    private static final long serialVersionUID = 1;

    /** @param reason what is wrong with the bytes, without a full stop */
    public PackedException(String reason) {
        super(reason);
    }

    /** @return what is wrong with the bytes, without a full stop */
    public String reason() {
        return getMessage();
    }
}
