package org.jsmesh.files;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import org.jsmesh.archive.ArchiveHeader;

/** The bounding boxes of archives in the coordinates of their originals. */
public final class ModelBounds {
    private ModelBounds() {}

    /**
     * Adds the origin to the bounds of an archive.
     *
     * @param header of the archive
     * @return smallest x, y, z, then largest: float32 numbers as they are; in double precision sums of decimals, which
     *     have no more digits than their parts
     */
    public static List<Number> of(ArchiveHeader header) {
        float[] offsets = header.bounds();
        double[] origin = header.origin();
        List<Number> bounds = new ArrayList<>();
        for (int i = 0; i < offsets.length; i++) {
            double from = origin[i % 3];
            if (from == 0) bounds.add(offsets[i]);
            else
                bounds.add(new BigDecimal(Double.toString(from))
                        .add(new BigDecimal(Float.toString(offsets[i])))
                        .doubleValue());
        }
        return bounds;
    }
}
