package org.jsmesh.codec;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import org.jsmesh.codec.entropy.BinaryCoder;
import org.jsmesh.codec.lod.ChainedIds;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshCorrespondence;
import org.jsmesh.mesh.Sizes;

/**
 * Codes which wedge of the original each corner has. This costs next to nothing for most files, because they number
 * wedges as they come up, or have one for each vertex.
 */
final class CornerOrderCoder {
    private static final int RANKS = 8;
    private final BinaryCoder coder;
    private final Mesh decoded;
    private final Mesh original; // encoder only
    private final int vertices;
    private final boolean plain; // the wedges are the vertices
    private final int[] vertexGroup;
    private final int[] wedgeGroup;
    private final ChainedIds verticesAt;
    private final ChainedIds wedgesAt;
    private final int[] wedgeVertices;
    private final int[] faceWedges;
    private final int[] source; // decoded wedge of each original one, or −1
    private final int[] vertexRank = BinaryCoder.newContexts(RANKS);
    private final int[] wedgeRank = BinaryCoder.newContexts(RANKS);
    private final int[] isNext = BinaryCoder.newContexts(1);
    private int next;

    CornerOrderCoder(
            BinaryCoder coder,
            Mesh decoded,
            Mesh original,
            int[] vertexGroup,
            ChainedIds verticesAt,
            int vertices,
            int wedges) {
        this.coder = coder;
        this.decoded = decoded;
        this.original = original;
        this.vertices = vertices;
        this.vertexGroup = vertexGroup;
        this.verticesAt = verticesAt;
        plain = coder.raw(original != null && isPlain(original) ? 1 : 0, 1) != 0 && vertices == wedges;
        wedgeGroup = MeshCorrespondence.alikeWedges(decoded);
        wedgesAt = new ChainedIds(decoded.wedges(), wedges);
        wedgeVertices = new int[wedges];
        for (int w = 0; plain && w < wedges; w++) wedgeVertices[w] = w;
        faceWedges = new int[3 * decoded.faces()];
        source = new int[wedges];
        Arrays.fill(source, -1);
    }

    private static boolean isPlain(Mesh mesh) {
        if (mesh.wedges() != mesh.vertices()) return false;
        for (int w = 0; w < mesh.wedges(); w++) if (mesh.wedgeVertices()[w] != w) return false;
        return true;
    }

    /** Corner of a decoded face with the smallest original vertex. */
    int smallest(int face) {
        int best = 0;
        int least = Integer.MAX_VALUE;
        for (int j = 0; j < 3; j++) {
            int v = verticesAt.first(vertexGroup[decoded.vertex(face, j)]);
            if (v >= least) continue;
            best = j;
            least = v;
        }
        return best;
    }

    /** Codes the corners of a face of the original. Its corner j is corner (j + rotation) mod 3 of the decoded face. */
    void code(int f, int face, int rotation) throws MalformedStreamException {
        for (int j = 0; j < 3; j++) {
            int wedge = decoded.faceWedges()[3 * face + (j + rotation) % 3];
            int wanted = original == null ? 0 : original.faceWedges()[3 * f + j];
            int coded = plain ? codeVertex(wedge, wanted) : codeWedge(wedge, wanted);
            faceWedges[3 * f + j] = coded;
            if (source[coded] < 0) source[coded] = wedge;
            else if (wedgeGroup[source[coded]] != wedgeGroup[wedge])
                throw new MalformedStreamException(-1, "the order gives wedge " + coded + " two values");
        }
    }

    private int codeVertex(int wedge, int wanted) throws MalformedStreamException {
        int v = verticesAt.first(vertexGroup[decoded.wedgeVertices()[wedge]]);
        if (v < 0) throw new MalformedStreamException(-1, "the order leaves out a vertex");
        for (int rank = 0; verticesAt.next(v) >= 0; v = verticesAt.next(v), rank++) {
            if (coder.bit(vertexRank, Math.min(rank, RANKS - 1), v == wanted ? 1 : 0) != 0) break;
        }
        return v;
    }

    private int codeWedge(int wedge, int wanted) throws MalformedStreamException {
        int rank = 0;
        for (int w = wedgesAt.first(wedgeGroup[wedge]); w >= 0; w = wedgesAt.next(w)) {
            if (coder.bit(wedgeRank, Math.min(rank++, RANKS - 1), w == wanted ? 1 : 0) != 0) return w;
        }
        if (wedgeVertices.length == 0) throw new MalformedStreamException(-1, "the order has no wedges");
        int coded = Math.min(next, wedgeVertices.length - 1);
        if (coder.bit(isNext, 0, wanted == coded ? 1 : 0) == 0) coded = coder.uniform(wanted, wedgeVertices.length);
        if (source[coded] >= 0) throw new MalformedStreamException(-1, "the order names wedge " + coded + " twice");
        next = coded + 1;
        wedgesAt.add(wedgeGroup[wedge], coded);
        wedgeVertices[coded] = codeVertex(wedge, original == null ? 0 : original.wedgeVertices()[wanted]);
        return coded;
    }

    int[] faceWedges() {
        return faceWedges;
    }

    /** Returns the vertices of the wedges, after coding those of wedges that no face uses. */
    int[] wedgeVertices() throws MalformedStreamException {
        for (int w = 0; w < source.length && !plain; w++) {
            if (source[w] >= 0) continue;
            if (vertices == 0) throw new MalformedStreamException(-1, "the order has wedges but no vertices");
            wedgeVertices[w] = coder.uniform(original == null ? 0 : original.wedgeVertices()[w], vertices);
        }
        return wedgeVertices;
    }

    /** Returns the channels, after coding the values of wedges that no face uses. */
    List<Channel> channels() throws MalformedStreamException {
        List<Channel> channels = new ArrayList<>();
        for (int i = 0; i < decoded.channels().size(); i++) {
            Channel from = decoded.channels().get(i);
            channels.add(
                    restore(from, original == null ? null : original.channels().get(i)));
        }
        return channels;
    }

    private Channel restore(Channel from, Channel wanted) throws MalformedStreamException {
        int n = from.words();
        int[] values = new int[Sizes.of(n, source.length, "corners with " + from.name())];
        BitSet absent = new BitSet();
        int bits = from.type() == Channel.Type.UINT8 ? 8 : 32;
        int exponent = from.type() == Channel.Type.FLOAT32 ? 0x7f800000 : 0x7ff00000;
        for (int w = 0; w < source.length; w++) {
            if (source[w] >= 0) {
                System.arraycopy(from.values(), n * source[w], values, n * w, n);
                absent.set(w, from.isAbsent(source[w]));
                continue;
            }
            absent.set(w, coder.raw(wanted != null && wanted.isAbsent(w) ? 1 : 0, 1) != 0);
            for (int k = 0; k < n && !absent.get(w); k++) {
                int value = coder.raw(wanted == null ? 0 : wanted.values()[n * w + k], bits);
                boolean isFloat = from.type().isFloat() && (k + 1) % from.type().words() == 0; // has the exponent
                if (isFloat && (value & exponent) == exponent)
                    throw new MalformedStreamException(-1, "a value of " + from.name() + " is not a finite number");
                values[n * w + k] = value;
            }
        }
        return new Channel(from.semantic(), from.name(), from.components(), from.type(), values, absent);
    }
}
