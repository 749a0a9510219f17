package org.jsmesh.files.gltf.read;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jsmesh.files.gltf.draco.DracoAttribute;
import org.jsmesh.files.gltf.draco.DracoDecoder;
import org.jsmesh.files.gltf.draco.DracoMesh;
import org.jsmesh.files.gltf.json.JsonTree;
import org.jsmesh.files.gltf.packed.MeshoptDecoder;
import org.jsmesh.files.gltf.packed.PackedException;
import org.jsmesh.mesh.io.ModelFormatException;

/** Unpacks compressed geometry, each part once. What it becomes counts against the limit of the document. */
final class PackedMeshes {
    private static final String DRACO = "KHR_draco_mesh_compression";
    private static final List<String> MESHOPT = List.of("EXT_meshopt_compression", "KHR_meshopt_compression");

    static final Set<String> EXTENSIONS = Set.of(DRACO, MESHOPT.get(0), MESHOPT.get(1));

    private final GltfDocument document;
    private final Map<Integer, ByteBuffer> views = new HashMap<>();
    private final Map<JsonNode, Draco> meshes = new HashMap<>();

    /** @param indices three points for each triangle */
    record Draco(DracoMesh mesh, GltfAccessor indices) {}

    PackedMeshes(GltfDocument document) {
        this.document = document;
    }

    private static String meshoptName(JsonNode view) {
        boolean newer = view.path("extensions").path(MESHOPT.get(1)).isObject();
        return MESHOPT.get(newer ? 1 : 0);
    }

    /** The meshopt extension of a buffer view, or the missing node. */
    static JsonNode meshopt(JsonNode view) {
        return view.path("extensions").path(meshoptName(view));
    }

    /** The Draco extension of a primitive, or the missing node. */
    static JsonNode draco(JsonNode primitive) {
        return primitive.path("extensions").path(DRACO);
    }

    /** The bytes of a buffer view that meshopt packed. */
    ByteBuffer view(int index, JsonNode view, ByteBuffer packed) throws IOException {
        ByteBuffer known = views.get(index);
        if (known == null) {
            JsonNode extension = meshopt(view);
            int count = JsonTree.index(extension.path("count"));
            int stride = JsonTree.index(extension.path("byteStride"));
            String mode = extension.path("mode").asText();
            String filter = extension.path("filter").asText("NONE");
            document.unpack(Math.max(0, (long) count * stride));
            try {
                known = ByteBuffer.wrap(MeshoptDecoder.decode(packed, count, stride, mode, filter));
            } catch (PackedException e) {
                throw damaged("buffer view " + index, meshoptName(view), e);
            }
            views.put(index, known);
        }
        return known.duplicate().order(ByteOrder.LITTLE_ENDIAN);
    }

    /** The mesh that a Draco extension describes. */
    Draco mesh(JsonNode extension) throws IOException {
        JsonNode number = extension.path("bufferView");
        Draco known = meshes.get(number);
        if (known != null) return known;
        ByteBuffer packed = document.view(number);
        int most = document.mostElements();
        DracoMesh mesh;
        try {
            mesh = DracoDecoder.decode(packed, most, most);
        } catch (PackedException e) {
            throw damaged("buffer view " + number.asText(), DRACO, e);
        }
        long size = 8L * mesh.indices().length;
        for (DracoAttribute attribute : mesh.attributes().values()) size += attribute.values().length;
        document.unpack(size);
        ByteBuffer bytes = ByteBuffer.allocate(4 * mesh.indices().length).order(ByteOrder.LITTLE_ENDIAN);
        bytes.asIntBuffer().put(mesh.indices());
        known = new Draco(
                mesh,
                GltfAccessor.of(
                        document, "the compressed indices", 1, ComponentType.UNSIGNED_INT, false, bytes.array()));
        meshes.put(number, known);
        return known;
    }

    private ModelFormatException damaged(String place, String extension, PackedException e) {
        return document.error(
                "the geometry of " + place + " is compressed with " + extension + " and cannot be unpacked: "
                        + e.reason(),
                "Get the file again, or export the model without mesh compression");
    }
}
