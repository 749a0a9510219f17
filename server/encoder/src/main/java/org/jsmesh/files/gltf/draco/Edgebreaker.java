package org.jsmesh.files.gltf.draco;

import static org.jsmesh.files.gltf.draco.CornerTable.NONE;

import java.util.ArrayDeque;
import org.jsmesh.files.gltf.packed.PackedBytes;
import org.jsmesh.files.gltf.packed.PackedException;

/**
 * The connectivity of a mesh in Draco's edgebreaker method (Draco specification, "Edgebreaker decoder"), version 2.2:
 * faces, the seams of attributes, and the points, of which a vertex has one for each combination of attribute values
 * around it.
 */
final class Edgebreaker {
    private static final int STANDARD = 0;
    private static final int BY_VALENCE = 2;

    final CornerTable table;
    /** By the number that an attribute group refers to. */
    final SeamTable[] seams;
    /** The point at each corner. */
    final int[] points;

    final int pointCount;

    Edgebreaker(PackedBytes in, DracoLimits limits) throws PackedException {
        int method = in.next();
        int vertices = in.count();
        int faces = in.count();
        int seamTables = in.next();
        int symbolCount = in.count();
        int splitSymbols = in.count();
        limits.requireFaces(faces);
        limits.takeAttributes(seamTables);
        limits.takeValues(6 * seamTables, faces);
        if (vertices > 3L * faces || symbolCount > faces || splitSymbols > symbolCount) {
            throw new PackedException("the counts of the Draco mesh contradict each other");
        }
        int mostVertices = vertices + splitSymbols;
        table = new CornerTable(faces, mostVertices);
        ArrayDeque<EdgebreakerFaces.Split> splits = splits(in, symbolCount);
        PackedBytes coded = method == STANDARD ? in.takePart(in.count()) : null;
        RansBits startFaces = new RansBits(in);
        RansBits[] seamBits = new RansBits[seamTables];
        for (int i = 0; i < seamTables; i++) seamBits[i] = new RansBits(in);
        EdgebreakerSymbols symbols = switch (method) {
            case STANDARD -> new EdgebreakerSymbols(coded);
            case BY_VALENCE -> new EdgebreakerSymbols.ByValence(in, table, mostVertices);
            default -> throw new PackedException("the edgebreaker method " + method + " is not known");
        };
        EdgebreakerFaces decoder = new EdgebreakerFaces(table, symbols, symbolCount, mostVertices, splits);
        decoder.decode(startFaces);
        points = new int[table.corners()];
        seams = seams(seamBits);
        pointCount = seamTables == 0 ? numberByVertex(decoder) : numberBySeams(decoder.boundary);
        limits.requirePoints(pointCount);
    }

    private static ArrayDeque<EdgebreakerFaces.Split> splits(PackedBytes in, int symbolCount) throws PackedException {
        int count = in.count();
        if (count > symbolCount || 2L * count > in.remaining()) throw new PackedException("there are too many handles");
        int[] sources = new int[count];
        int[] targets = new int[count];
        int source = 0;
        for (int i = 0; i < count; i++) {
            source += in.count();
            int back = in.count();
            if (source < 0 || back > source || source >= symbolCount) {
                throw new PackedException("a handle of the Draco mesh is out of range");
            }
            sources[i] = source;
            targets[i] = source - back;
        }
        ArrayDeque<EdgebreakerFaces.Split> splits = new ArrayDeque<>();
        BitReader bits = new BitReader(in);
        for (int i = 0; i < count; i++) {
            splits.add(new EdgebreakerFaces.Split(sources[i], targets[i], bits.next(1) == 1));
        }
        in.take(bits.bytesRead());
        return splits;
    }

    private SeamTable[] seams(RansBits[] bits) throws PackedException {
        SeamTable[] tables = new SeamTable[bits.length];
        for (int i = 0; i < tables.length; i++) {
            SeamTable cut = new SeamTable(table);
            for (int face = 0; face < table.corners(); face += 3) {
                for (int c = face; c < face + 3; c++) {
                    int across = table.opposite(c);
                    // The bit of an edge stands at the first of its faces.
                    if (across == NONE || across / 3 >= face / 3 && bits[i].next()) cut.cut(c);
                }
            }
            cut.numberVertices();
            tables[i] = cut;
        }
        return tables;
    }

    private int numberByVertex(EdgebreakerFaces decoder) throws PackedException {
        int count = decoder.removeMerged();
        for (int c = 0; c < points.length; c++) points[c] = table.vertex(c);
        return count;
    }

    private int numberBySeams(boolean[] boundary) throws PackedException {
        int count = 0;
        for (int v = 0; v < table.vertexCount(); v++) {
            int leftMost = table.leftMost(v);
            if (leftMost == NONE) continue;
            int first = boundary[v] ? leftMost : afterSeam(leftMost);
            points[first] = count++;
            int last = first;
            for (int c = table.swingRight(first); c != NONE && c != first; c = table.swingRight(c)) {
                points[c] = isSeam(last, c) ? count++ : points[last];
                last = c;
            }
        }
        return count;
    }

    /** The first corner around a vertex, from {@code start}, that is not on the same side of a seam. */
    private int afterSeam(int start) throws PackedException {
        for (SeamTable seam : seams) {
            if (!seam.isOnSeam(start)) continue;
            for (int c = table.swingRight(start); c != start; c = table.swingRight(c)) {
                if (c == NONE) throw new PackedException("a vertex of the Draco mesh has no whole ring of faces");
                if (seam.vertex(c) != seam.vertex(start)) return c;
            }
        }
        return start;
    }

    private boolean isSeam(int last, int corner) {
        for (SeamTable seam : seams) if (seam.vertex(corner) != seam.vertex(last)) return true;
        return false;
    }
}
