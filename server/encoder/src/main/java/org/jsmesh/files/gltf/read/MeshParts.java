package org.jsmesh.files.gltf.read;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

/**
 * The primitives of a mesh.
 *
 * @param primitives those with triangles
 * @param triangles of all of them, with degenerate ones
 * @param zeros those of them that have no bytes
 * @param faces those that do not merely stitch a strip
 * @param others primitives of points or lines, or without positions
 * @param rests primitives whose number of corners is no multiple of three
 */
record MeshParts(List<GltfPrimitive> primitives, long triangles, long zeros, long faces, int others, int rests) {
    static MeshParts of(GltfDocument document, int mesh) throws IOException {
        List<GltfPrimitive> primitives = new ArrayList<>();
        long triangles = 0;
        long zeros = 0;
        long faces = 0;
        int others = 0;
        int rests = 0;
        for (JsonNode json : document.root().path("meshes").path(mesh).path("primitives")) {
            GltfPrimitive primitive = GltfPrimitive.of(document, json);
            if (primitive == null) {
                others++;
                continue;
            }
            TriangleSource source = primitive.triangles();
            if (source.hasRest()) rests++;
            if (source.count() == 0) continue;
            triangles += source.count();
            if (!primitive.hasBytes()) zeros += source.count();
            faces += source.faces();
            primitives.add(primitive);
        }
        return new MeshParts(primitives, triangles, zeros, faces, others, rests);
    }
}
