package org.jsmesh.files;

import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.databind.JsonSerializer;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.SerializerProvider;
import com.fasterxml.jackson.databind.module.SimpleModule;
import com.fasterxml.jackson.databind.node.ArrayNode;
import java.io.IOException;
import java.util.List;
import java.util.Locale;
import org.jsmesh.mesh.Note;

/**
 * A note as JSON: {@code kind} in lower case, {@code text}, {@code count}, {@code example}, {@code warning}. The names
 * of its fields are a promise to other programs.
 */
public final class NoteJson extends JsonSerializer<Note> {
    private static final ObjectMapper JSON =
            new ObjectMapper().registerModule(new SimpleModule().addSerializer(Note.class, new NoteJson()));

    NoteJson() {}

    /**
     * Writes notes as an array.
     *
     * @param notes in the order in which they were found
     * @return an object for each
     */
    public static ArrayNode array(List<Note> notes) {
        return JSON.valueToTree(notes);
    }

    @Override
    public void serialize(Note note, JsonGenerator json, SerializerProvider provider) throws IOException {
        json.writeStartObject();
        json.writeStringField("kind", note.kind().name().toLowerCase(Locale.ROOT));
        json.writeStringField("text", note.text());
        json.writeNumberField("count", note.count());
        json.writeStringField("example", note.example());
        json.writeBooleanField("warning", note.warning());
        json.writeEndObject();
    }
}
