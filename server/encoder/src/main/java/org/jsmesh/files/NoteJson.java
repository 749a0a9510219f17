package org.jsmesh.files;

import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.databind.JsonSerializer;
import com.fasterxml.jackson.databind.SerializerProvider;
import java.io.IOException;
import java.util.Locale;
import org.jsmesh.mesh.Note;

/** A note as JSON; the kind in lower case. */
final class NoteJson extends JsonSerializer<Note> {
    @Override
    public void serialize(Note note, JsonGenerator json, SerializerProvider provider) throws IOException {
        json.writeStartObject();
        json.writeStringField("kind", note.kind().name().toLowerCase(Locale.ROOT));
        json.writeStringField("text", note.text());
        json.writeNumberField("count", note.count());
        json.writeStringField("example", note.example());
        json.writeEndObject();
    }
}
