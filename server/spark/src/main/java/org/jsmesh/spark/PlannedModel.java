package org.jsmesh.spark;

import java.io.DataInput;
import java.io.DataOutput;
import java.io.IOException;
import java.io.Serializable;

/**
 * A model that is to be encoded.
 *
 * @param id in the catalogue
 * @param file as it was listed
 * @param faces as its header tells, or a guess by its length
 * @param heapBytes that encoding takes
 */
record PlannedModel(String id, ListedModel file, long faces, long heapBytes) implements Serializable {
    private static final long serialVersionUID = 1;

    /** Measured on one core; the fit of the base, the errors of coarse levels and the poster take what is added. */
    private static final double FACES_PER_SECOND = 150_000;

    private static final double SECONDS_A_MODEL = .35;

    /** {@return about how long one core works on it} */
    double seconds() {
        return SECONDS_A_MODEL + faces / FACES_PER_SECOND;
    }

    void write(DataOutput out) throws IOException {
        out.writeUTF(id);
        file.write(out);
        out.writeLong(faces);
        out.writeLong(heapBytes);
    }

    static PlannedModel read(DataInput in) throws IOException {
        return new PlannedModel(in.readUTF(), ListedModel.read(in), in.readLong(), in.readLong());
    }
}
