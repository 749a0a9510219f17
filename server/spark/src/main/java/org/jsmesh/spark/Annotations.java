package org.jsmesh.spark;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.FileSystemException;
import java.util.Optional;
import org.jsmesh.files.AnnotationFile;
import org.jsmesh.objects.ObjectStore;
import org.jsmesh.objects.StoredObject;
import org.jsmesh.store.ids.ModelPath;

/** What people wrote about a model, in a file beside it. */
final class Annotations {
    private static final ObjectMapper JSON = new ObjectMapper();

    private Annotations() {}

    static Optional<StoredObject> find(ObjectStore store, ListedModel file) throws IOException {
        return store.find(file.folder() + ModelPath.stem(file.fileName()) + "." + AnnotationFile.NAME);
    }

    /** {@return the tag of the file; empty when there is none} */
    static String tag(ObjectStore store, ListedModel file) throws IOException {
        return find(store, file).map(StoredObject::tag).orElse("");
    }

    /** As {@link AnnotationFile#read}. */
    static byte[] read(ObjectStore store, StoredObject file) throws IOException {
        if (file.bytes() > AnnotationFile.MOST_BYTES)
            throw wrong(store, file, "is larger than " + AnnotationFile.MOST_BYTES + " bytes. Shorten the annotations");
        byte[] content = new byte[(int) file.bytes()];
        store.read(file, 0, ByteBuffer.wrap(content));
        JsonNode json;
        try {
            json = JSON.readTree(content);
        } catch (JsonProcessingException e) {
            int line = e.getLocation() == null ? 1 : e.getLocation().getLineNr();
            throw wrong(store, file, "is not JSON in line " + line + ". Correct it");
        }
        if (!json.path("annotations").isArray())
            throw wrong(store, file, "has no list \"annotations\". Write {\"annotations\": [...]}");
        return content;
    }

    private static FileSystemException wrong(ObjectStore store, StoredObject file, String reason) {
        return new FileSystemException(store.address() + "/" + file.key(), null, reason);
    }
}
