package org.jsmesh.web;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import org.jsmesh.archive.Proof;
import org.jsmesh.archive.Provenance;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.encode.EncodedArchive;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.encode.MeshEncoder;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.mesh.io.ModelFile;
import org.jsmesh.mesh.io.ModelFormat;
import org.jsmesh.mesh.io.ModelReader;
import org.jsmesh.mesh.io.ModelWriter;

/** Files that are given, and what is made of them. Not thread-safe. */
final class Workshop {
    private static final int PORTION = 1 << 16;
    private static final String REMEDY = "Encode it with jsm encode, and drop the .jsm file here.";

    private final GivenFiles given = new GivenFiles();
    private byte[] beginning = new byte[0];
    private int filled;
    private final List<Made> made = new ArrayList<>();

    private record Made(String name, byte[] bytes) {}

    void begin(String path, int bytes) {
        if (bytes < 0) throw new WrongCallException("a file cannot have " + bytes + " bytes");
        beginning = new byte[bytes];
        filled = 0;
        given.put(path, beginning);
    }

    void append(ByteBuffer bytes, int length) {
        if (length < 0 || length > Math.min(bytes.remaining(), beginning.length - filled))
            throw new WrongCallException("cannot append " + length + " bytes");
        bytes.get(beginning, filled, length);
        filled += length;
    }

    /** What was made: its number is its place in the answer. */
    byte[] file(int number) {
        if (number < 0 || number >= made.size()) throw new WrongCallException("there is no file " + number);
        return made.get(number).bytes();
    }

    /** Writes the original of an archive as a model file of the format that the file's name tells. */
    void decode(String archive, String fileName, Json json) throws MalformedStreamException {
        ModelFormat format = ModelFormat.toWrite(fileName);
        if (format == null || format == ModelFormat.GLB)
            throw new WrongCallException("nothing is written under the name " + fileName);
        Mesh mesh = original(given.get(archive));
        made.clear();
        try {
            write(json, ModelWriter.write(mesh, format, fileName, FileInMemory::new));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Takes its place among what was made when it is closed. */
    private final class FileInMemory extends ByteArrayOutputStream {
        private final String name;

        FileInMemory(String name) {
            this.name = name;
        }

        @Override
        public void close() {
            made.add(new Made(name, toByteArray()));
        }
    }

    private static Mesh original(byte[] archive) throws MalformedStreamException {
        ArchiveDecoder decoder = new ArchiveDecoder();
        for (int at = 0; at < archive.length; at += PORTION)
            decoder.feed(archive, at, Math.min(PORTION, archive.length - at));
        if (!decoder.isComplete())
            throw new MalformedStreamException(archive.length, "the file ends before the original is there");
        Mesh mesh = decoder.meshInOrder();
        String difference = Proof.of(decoder.header(), mesh).difference();
        if (!difference.isEmpty()) throw new MalformedStreamException(-1, difference);
        return mesh;
    }

    /** Encodes a model file with its companions. */
    void encode(String model, int mostFaces, ProgressListener progress, Json json) {
        progress.step("reading", 0);
        try {
            byte[] content = given.get(model);
            ModelFormat format = ModelReader.formatOf(model, content);
            if (format == ModelFormat.THREE_MF || format == ModelFormat.GLB)
                throw new Refusal("A browser does not read " + format.title() + ". " + REMEDY);
            ModelFile file = ModelReader.read(model, content, given.around(model));
            int faces = file.mesh().faces();
            if (faces > mostFaces)
                throw new Refusal(
                        model + " has " + faces + " faces, and a browser encodes at most " + mostFaces + ". " + REMEDY);
            Provenance from = new Provenance(format.title(), file.notes());
            MeshEncoder encoder = new MeshEncoder(EncoderSettings.defaults().withUp(format.up()));
            EncodedArchive archive = encoder.encode(file.mesh(), from, List.of(), progress);
            made.clear();
            made.add(new Made(model.replaceFirst("\\.[^./]*$", "") + ".jsm", archive.bytes()));
            write(json, List.of());
        } catch (IOException e) {
            throw new Refusal(e.getMessage());
        }
    }

    /** A model that is not encoded here, and why, in words. */
    private static final class Refusal extends IllegalArgumentException {
        private static final long serialVersionUID = 1L;

        Refusal(String reason) {
            super(reason);
        }
    }

    private void write(Json json, List<String> notes) {
        json.open('{').key("files").open('[');
        for (Made file : made)
            json.open('{')
                    .key("name")
                    .text(file.name())
                    .key("bytes")
                    .number(file.bytes().length)
                    .close('}');
        json.close(']').key("notes").open('[');
        for (String note : notes) json.text(note);
        json.close(']').close('}');
    }
}
