package org.jsmesh.files.gltf.write;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import org.jsmesh.archive.Provenance;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.encode.EncodedArchive;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.encode.MeshEncoder;
import org.jsmesh.files.gltf.GltfReader;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.mesh.UpAxis;
import org.jsmesh.mesh.io.ResourceResolver;

/** A written GLB file, to look at its parts without the reader. */
record GlbFile(byte[] bytes, JsonNode json, ByteBuffer binary, List<String> notes, List<String> remarks) {
    static GlbFile of(Mesh mesh) throws IOException {
        return of(mesh, UpAxis.UNKNOWN);
    }

    static GlbFile of(Mesh mesh, UpAxis up) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        List<String> remarks = new ArrayList<>();
        List<String> notes = GltfWriter.write(mesh, up, "x.glb", name -> out, remarks);
        byte[] glb = out.toByteArray();
        ByteBuffer words = ByteBuffer.wrap(glb).order(ByteOrder.LITTLE_ENDIAN);
        int length = words.getInt(12);
        boolean binary = glb.length > 20 + length;
        ByteBuffer rest = binary ? words.slice(28 + length, words.getInt(20 + length)) : ByteBuffer.allocate(0);
        return new GlbFile(
                glb, new ObjectMapper().readTree(glb, 20, length), rest.order(ByteOrder.LITTLE_ENDIAN), notes, remarks);
    }

    /** The mesh that an archive of it gives. */
    static Mesh decoded(Mesh mesh) throws IOException {
        EncodedArchive archive = new MeshEncoder(EncoderSettings.defaults())
                .encode(mesh, Provenance.NONE, List.of(), ProgressListener.NONE);
        ArchiveDecoder decoder = new ArchiveDecoder();
        decoder.feed(archive.bytes(), 0, archive.bytes().length);
        return decoder.mesh();
    }

    Mesh read() throws IOException {
        return GltfReader.read("x.glb", bytes, ResourceResolver.NONE).mesh();
    }

    JsonNode primitive(int number) {
        return json.path("meshes").path(0).path("primitives").path(number);
    }

    JsonNode accessor(JsonNode number) {
        return json.path("accessors").path(number.intValue());
    }

    /** Where the values of an accessor begin. */
    int start(JsonNode accessor) {
        JsonNode view =
                json.path("bufferViews").path(accessor.path("bufferView").intValue());
        return view.path("byteOffset").asInt() + accessor.path("byteOffset").asInt();
    }
}
