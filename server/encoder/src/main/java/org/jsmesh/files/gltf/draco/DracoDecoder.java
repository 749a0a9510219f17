package org.jsmesh.files.gltf.draco;

import java.nio.ByteBuffer;
import java.util.HashMap;
import java.util.Map;
import org.jsmesh.files.gltf.packed.PackedBytes;
import org.jsmesh.files.gltf.packed.PackedException;

/**
 * Decodes a mesh of KHR_draco_mesh_compression, which is Draco's bitstream of version 2.2, as Draco's specification
 * describes it. Memory and time are bounded by the limits of the caller and by a multiple of the packed bytes.
 * Thread-safe.
 */
public final class DracoDecoder {
    private static final byte[] MAGIC = {'D', 'R', 'A', 'C', 'O'};
    private static final int TRIANGLES = 1;
    private static final int SEQUENTIAL = 0;
    private static final int EDGEBREAKER = 1;
    private static final int HAS_METADATA = 0x8000;
    private static final int SMALL_POINT_COUNT = 1 << 21;

    private final PackedBytes in;
    private final DracoLimits limits;

    private DracoDecoder(PackedBytes in, DracoLimits limits) {
        this.in = in;
        this.limits = limits;
    }

    /**
     * Decodes a mesh.
     *
     * @param packed the compressed bytes, from position to limit; neither is changed
     * @param mostVertices of how many points the mesh may have
     * @param mostFaces of how many triangles the mesh may have
     * @return the mesh
     * @throws PackedException when the bytes are not such a mesh, or a larger one
     */
    public static DracoMesh decode(ByteBuffer packed, int mostVertices, int mostFaces) throws PackedException {
        DracoLimits limits = new DracoLimits(packed.remaining(), mostVertices, mostFaces);
        return new DracoDecoder(new PackedBytes(packed), limits).decode();
    }

    private DracoMesh decode() throws PackedException {
        for (byte letter : MAGIC) if (in.next() != letter) throw new PackedException("this is no Draco data");
        int major = in.next();
        int minor = in.next();
        if (major != 2 || minor != 2) {
            throw new PackedException("the Draco data has version " + major + "." + minor + " and not 2.2");
        }
        if (in.next() != TRIANGLES) throw new PackedException("the Draco data is not a mesh of triangles");
        int method = in.next();
        if ((in.nextShort() & HAS_METADATA) != 0) skipMetadata();
        return switch (method) {
            case SEQUENTIAL -> sequential();
            case EDGEBREAKER -> edgebreaker();
            default -> throw new PackedException("the Draco method " + method + " is not known");
        };
    }

    private DracoMesh edgebreaker() throws PackedException {
        Edgebreaker connectivity = new Edgebreaker(in, limits);
        int[] points = connectivity.points;
        return mesh(points, connectivity.pointCount, connectivity);
    }

    private DracoMesh sequential() throws PackedException {
        int faces = in.count();
        int points = in.count();
        limits.requireFaces(faces);
        limits.requirePoints(points);
        // At least a bit for each index in either way.
        if (faces > 8L * in.remaining()) throw new PackedException("the Draco data is too short for its faces");
        boolean compressed = in.next() == 0;
        int[] indices = compressed ? RansSymbols.decode(in, 3 * faces, 1) : new int[3 * faces];
        int last = 0;
        for (int i = 0; i < indices.length; i++) {
            if (compressed) last += (indices[i] & 1) != 0 ? -(indices[i] >>> 1) : indices[i] >>> 1;
            indices[i] = compressed ? last : index(points);
        }
        return mesh(indices, points, null);
    }

    private int index(int points) throws PackedException {
        if (points < 1 << 8) return in.next();
        if (points < 1 << 16) return in.nextShort();
        return points < SMALL_POINT_COUNT ? in.varint() : in.nextInt();
    }

    private DracoMesh mesh(int[] indices, int points, Edgebreaker connectivity) throws PackedException {
        for (int index : indices) {
            if (index < 0 || index >= points) {
                throw new PackedException("a triangle has the point " + index + " of " + points);
            }
        }
        AttributeGroup[] groups = new AttributeGroup[in.next()];
        for (int i = 0; i < groups.length; i++) {
            groups[i] = new AttributeGroup(in, limits, connectivity, indices, points);
        }
        for (AttributeGroup group : groups) group.readKinds();
        Positions positions = null;
        Map<Integer, DracoAttribute> attributes = new HashMap<>();
        for (AttributeGroup group : groups) positions = group.readValues(positions, attributes);
        return new DracoMesh(indices, points, attributes);
    }

    /** Names and texts of the mesh and its attributes, which glTF has its own place for. */
    private void skipMetadata() throws PackedException {
        int attributes = in.count();
        for (int i = 0; i < attributes; i++) {
            in.varint();
            skipEntries();
        }
        skipEntries();
    }

    private void skipEntries() throws PackedException {
        for (long nodes = skipNode(); nodes > 0; nodes--) {
            in.take(in.next());
            nodes += skipNode();
        }
    }

    /** Returns how many nodes are below. */
    private int skipNode() throws PackedException {
        int entries = in.count();
        for (int i = 0; i < entries; i++) {
            in.take(in.next());
            in.take(in.count());
        }
        return in.count();
    }
}
