import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.encode.measure.DistanceMeter;
import org.jsmesh.files.ModelFiles;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.MeshCleaner;

/**
 * What the scripts beside it need of the library; run as {@code java -cp jsm.jar BareMesh.java ...}:
 *
 * <ul>
 *   <li>{@code strip MODEL OUT.ply}: positions and faces alone, without vertices that no face uses.
 *   <li>{@code distances ORIGINAL.ply SHOWN...}: a line with the faces and the mean and greatest distance in % of the diagonal for each SHOWN: a file, what the first bytes of an
 *       archive show ({@code FILE.jsm@BYTES}), or {@code nothing}, which counts as one point in the middle of the box.
 * </ul>
 */
public final class BareMesh {
    private BareMesh() {}

    public static void main(String[] args) throws IOException {
        if (args[0].equals("strip")) Files.write(Path.of(args[2]), ply(read(args[1])));
        else distances(read(args[1]), java.util.Arrays.copyOfRange(args, 2, args.length));
    }

    private static void distances(Mesh original, String[] shown) throws IOException {
        DistanceMeter meter = new DistanceMeter(original);
        for (String item : shown) {
            Mesh mesh = item.equals("nothing") ? middle(original) : item.contains("@") ? prefix(item) : read(item);
            DistanceMeter.Distance found = meter.measure(mesh.positions(), triangles(mesh), mesh.faces());
            System.out.println(mesh.faces() + " " + found.mean() + " " + found.maximum());
        }
    }

    private static Mesh read(String file) throws IOException {
        Mesh mesh = ModelFiles.read(Path.of(file)).mesh();
        Mesh bare = new MeshBuilder().positions(mesh.positions()).faceWedges(triangles(mesh)).build();
        return MeshCleaner.clean(bare, new ArrayList<>());
    }

    private static Mesh prefix(String item) throws IOException {
        int at = item.lastIndexOf('@');
        ArchiveDecoder decoder = new ArchiveDecoder();
        byte[] bytes = Files.readAllBytes(Path.of(item.substring(0, at)));
        decoder.feed(bytes, 0, (int) Math.min(bytes.length, Long.parseLong(item.substring(at + 1))));
        return decoder.mesh();
    }

    private static Mesh middle(Mesh original) {
        float[] b = original.bounds();
        float[] centre = {(b[0] + b[3]) / 2, (b[1] + b[4]) / 2, (b[2] + b[5]) / 2};
        return new MeshBuilder().positions(centre).faceWedges(new int[3]).build();
    }

    private static int[] triangles(Mesh mesh) {
        int[] corners = mesh.faceWedges().clone();
        for (int i = 0; i < corners.length; i++) corners[i] = mesh.wedgeVertices()[corners[i]];
        return corners;
    }

    /** Binary PLY as {@code model.mjs} reads it. */
    private static byte[] ply(Mesh mesh) {
        String header = "ply\nformat binary_little_endian 1.0\nelement vertex " + mesh.vertices()
                + "\nproperty float x\nproperty float y\nproperty float z\nelement face " + mesh.faces()
                + "\nproperty list uchar int vertex_indices\nend_header\n";
        ByteBuffer body =
                ByteBuffer.allocate(12 * mesh.vertices() + 13 * mesh.faces()).order(ByteOrder.LITTLE_ENDIAN);
        for (float x : mesh.positions()) body.putFloat(x);
        int[] corners = triangles(mesh);
        for (int i = 0; i < corners.length; i++) {
            if (i % 3 == 0) body.put((byte) 3);
            body.putInt(corners[i]);
        }
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        out.writeBytes(header.getBytes(StandardCharsets.US_ASCII));
        out.writeBytes(body.array());
        return out.toByteArray();
    }
}
