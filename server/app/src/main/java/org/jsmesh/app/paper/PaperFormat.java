package org.jsmesh.app.paper;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jsmesh.collapse.CollapseMesh;
import org.jsmesh.collapse.PaperSimplifier;
import org.jsmesh.collapse.SimplificationTarget;
import org.jsmesh.mesh.CornerTable;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.patch.PatchLog;

/**
 * A streaming mesh of the paper as text (section 5.1): the simplified mesh, and a line per patch. The paper does not
 * show its text; this one has what it names.
 *
 * <p>A mesh is a line with the numbers of vertices, wedges and faces, then a line each: positions {@code x y z}; where
 * there are attributes, wedges with their vertex and attributes; faces with their three wedges, and their material
 * where there are any. Without attributes a wedge is its vertex. A patch is the position and the attributes of the
 * vertex that comes, the index of face f_t, the index of the vertex that is split in f_t, and the number of faces from
 * f_t to f_r. Materials themselves are not in the text.
 */
final class PaperFormat {
    private final CollapseMesh mesh;
    private final PaperText text;
    private final boolean hasMaterials;
    private final ClientMesh client = new ClientMesh();
    private final int[] clientFace; // of each face
    private final int[] clientVertex; // of each fan vertex
    private int vertices;
    private int wedges;

    private PaperFormat(CollapseMesh mesh) {
        this.mesh = mesh;
        text = new PaperText(mesh.original());
        hasMaterials = !mesh.original().materials().isEmpty();
        clientFace = new int[mesh.original().faces()];
        clientVertex = new int[mesh.vertexOf().length];
        Arrays.fill(clientVertex, -1);
    }

    /**
     * A streaming mesh.
     *
     * @param faces of the simplified mesh
     * @param vertices of the simplified mesh
     * @param base the simplified mesh
     * @param patches in the order in which they are sent, each with the end of its line
     */
    record Streaming(int faces, int vertices, String base, List<String> patches) {
        String allPatches() {
            return String.join("", patches);
        }
    }

    /** The mesh, not simplified. */
    static String original(Mesh mesh) {
        return new PaperFormat(new CollapseMesh(mesh)).mesh();
    }

    /** Simplifies a clean mesh by the method of the paper. */
    static Streaming of(Mesh mesh, Levels levels) {
        CollapseMesh collapsing = new CollapseMesh(mesh);
        PatchLog log = PaperSimplifier.simplify(
                collapsing, levels.thresholds(), SimplificationTarget.ofFaces(levels.faces()), ProgressListener.NONE);
        PaperFormat format = new PaperFormat(collapsing);
        String base = format.mesh();
        int faces = format.client.faces();
        int vertices = format.vertices;
        List<String> patches = new ArrayList<>();
        for (int p = log.size() - 1; p >= 0; p--) patches.add(format.patch(log, p));
        return new Streaming(faces, vertices, base, patches);
    }

    /** What is there of the mesh, which the client then knows. */
    private String mesh() {
        CornerTable table = mesh.table();
        StringBuilder positions = new StringBuilder();
        StringBuilder wedgeLines = new StringBuilder();
        StringBuilder faces = new StringBuilder();
        Map<Long, Integer> places = new HashMap<>();
        for (int f = 0; f < mesh.original().faces(); f++) {
            if (!mesh.isLiveFace(f)) continue;
            int[] corners = new int[3];
            int[] ids = new int[3];
            for (int k = 0; k < 3; k++) {
                int corner = CornerTable.STRIDE * f + k;
                int vertex = table.vertex(corner);
                if (clientVertex[vertex] < 0) {
                    clientVertex[vertex] = vertices++;
                    text.position(positions, mesh.vertexOf()[vertex]);
                    positions.append('\n');
                }
                corners[k] = clientVertex[vertex];
                ids[k] = text.hasAttributes() ? wedge(places, wedgeLines, vertex, mesh.wedge(corner)) : corners[k];
                faces.append(k == 0 ? "" : " ").append(ids[k]);
            }
            if (hasMaterials) faces.append(' ').append(mesh.material(f));
            faces.append('\n');
            clientFace[f] = client.faces();
            client.add(corners, ids, mesh.material(f));
        }
        if (!text.hasAttributes()) wedges = vertices;
        return vertices + " " + wedges + " " + client.faces() + "\n" + positions + wedgeLines + faces;
    }

    private int wedge(Map<Long, Integer> places, StringBuilder lines, int vertex, int wedge) {
        long key = (long) vertex << 32 | wedge;
        Integer place = places.get(key);
        if (place != null) return place;
        lines.append(clientVertex[vertex]);
        text.attributes(lines, wedge);
        lines.append('\n');
        places.put(key, wedges);
        return wedges++;
    }

    private String patch(PatchLog log, int p) {
        int face = clientFace[log.runFace(p)];
        int corner = client.cornerOf(face, clientVertex[log.kept(p)]);
        StringBuilder line = new StringBuilder();
        text.position(line, mesh.vertexOf()[log.removed(p)]);
        if (text.hasAttributes()) text.attributes(line, log.runWedge(p, 0));
        line.append(' ').append(face).append(' ').append(corner);
        line.append(' ').append(log.runLength(p)).append('\n');
        clientVertex[log.removed(p)] = vertices;
        clientFace[log.leftFace(p)] = client.faces();
        clientFace[log.rightFace(p)] = client.faces() + 1;
        client.split(face, corner, log.runLength(p), vertices++, wedges++);
        return line.toString();
    }
}
