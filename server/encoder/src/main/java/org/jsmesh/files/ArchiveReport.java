package org.jsmesh.files;

import com.fasterxml.jackson.annotation.JsonPropertyOrder;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.annotation.JsonSerialize;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.archive.ArchiveOpening;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.archive.ChannelInfo;
import org.jsmesh.archive.FaceChannelInfo;
import org.jsmesh.mesh.Note;

/**
 * What an archive holds, as the JSON that {@code jsm info --json} prints and that a manifest carries. The names of its
 * fields are a promise to other programs: new fields may come, but no field changes its meaning. Of a file that is cut
 * before the end of its header, totals, bounds, bytes, levels, hashes, format and notes are null, and there are the
 * first batches alone.
 *
 * @param faces of the original, likewise {@code vertices} and {@code wedges}
 * @param materials number of materials that faces refer to
 * @param textures number of images in the archive, each counted once
 * @param faceChannels the attributes of faces
 * @param bounds smallest x, y, z, then largest x, y, z, in the coordinates of the original
 * @param origin what the positions count from that a decoder shows: zeros but in double precision
 * @param up the axis that points up: {@code y}, {@code z}, or {@code unknown}
 * @param bytes of the whole file
 * @param meshSha256 identity of the original's mesh
 * @param modelSha256 identity of the original's mesh and images
 * @param archiveSha256 of the file's bytes; null when not all of them are there
 * @param baseFaces faces of the base mesh
 * @param baseBytes bytes up to the end of the base mesh, header and index included
 * @param levels of simplification, coarsest first
 * @param sourceFormat format of the file that the model came from, for instance {@code PLY}; empty without one
 * @param notes what of that file is not in the archive
 * @param batches in file order; the first is header, index and base
 */
@JsonPropertyOrder({
    "faces",
    "vertices",
    "wedges",
    "channels",
    "materials",
    "textures",
    "faceChannels",
    "bounds",
    "origin",
    "up",
    "bytes",
    "meshSha256",
    "modelSha256",
    "archiveSha256",
    "baseFaces",
    "baseBytes",
    "levels",
    "sourceFormat",
    "notes",
    "batches"
})
public record ArchiveReport(
        Integer faces,
        Integer vertices,
        Integer wedges,
        List<ChannelRow> channels,
        int materials,
        int textures,
        List<FaceChannelRow> faceChannels,
        List<Number> bounds,
        double[] origin,
        String up,
        Long bytes,
        String meshSha256,
        String modelSha256,
        String archiveSha256,
        int baseFaces,
        long baseBytes,
        List<LevelRow> levels,
        String sourceFormat,
        @JsonSerialize(contentUsing = NoteJson.class) List<Note> notes,
        List<BatchRow> batches) {
    private static final ObjectMapper JSON = new ObjectMapper();

    /**
     * An attribute channel.
     *
     * @param name of the channel
     * @param semantic in lower case, for instance {@code normal}
     * @param components of each value
     * @param type of a component in lower case, for instance {@code float32}
     */
    @JsonPropertyOrder({"name", "semantic", "components", "type"})
    public record ChannelRow(String name, String semantic, int components, String type) {}

    /**
     * An attribute of faces.
     *
     * @param name of the channel
     * @param components of each value
     * @param type of a component in lower case, for instance {@code int32}
     */
    @JsonPropertyOrder({"name", "components", "type"})
    public record FaceChannelRow(String name, int components, String type) {}

    /**
     * A level of simplification.
     *
     * @param threshold the cost up to which it collapses
     * @param faces of the mesh at its end
     * @param errorMean mean distance of that mesh to the original in % of the bounding box's diagonal
     */
    @JsonPropertyOrder({"threshold", "faces", "errorMean"})
    public record LevelRow(double threshold, int faces, double errorMean) {}

    /**
     * A batch and the mesh after it.
     *
     * @param offset of its first byte from the start of the file
     * @param bytes of it, with its checksum
     * @param kind {@code base}, {@code splits} or another of {@link org.jsmesh.archive.BatchKind} in lower case
     * @param patches vertex splits, vertices or wedges that it refines
     * @param faces of the mesh after it
     * @param vertices of the mesh after it
     * @param precisionBits of the coarsest position after it, relative to the longest side of the bounding box; 32 when
     *     all are exact
     * @param errorMean mean distance to the original in % of the bounding box's diagonal
     * @param errorQuantile distance to the original that 99.9% of the surface does not exceed, in the same unit
     * @param errorBound estimate from above of the distance to the original, in the same unit
     * @param level in which it ends: 1 for the coarsest, 0 for the base
     * @param pass in which it ends, counted from the base, which has 0
     */
    @JsonPropertyOrder({
        "offset",
        "bytes",
        "kind",
        "patches",
        "faces",
        "vertices",
        "precisionBits",
        "errorMean",
        "errorQuantile",
        "errorBound",
        "level",
        "pass"
    })
    public record BatchRow(
            long offset,
            int bytes,
            String kind,
            int patches,
            int faces,
            int vertices,
            int precisionBits,
            double errorMean,
            double errorQuantile,
            double errorBound,
            int level,
            int pass) {}

    /**
     * Reports on an archive.
     *
     * @param header which is whole
     * @param archiveSha256 of the file's bytes, or null when not all of them are there
     * @return the report
     */
    public static ArchiveReport of(ArchiveHeader header, String archiveSha256) {
        BatchIndex index = header.batches();
        List<LevelRow> levels = new ArrayList<>();
        for (ArchiveHeader.Level l : header.levels()) levels.add(new LevelRow(l.threshold(), l.faces(), l.errorMean()));
        return new ArchiveReport(
                header.faces(),
                header.vertices(),
                header.wedges(),
                channels(header.channels()),
                header.materials().size(),
                header.images().size(),
                faceChannels(header.faceChannels()),
                ModelBounds.of(header),
                header.origin(),
                header.up().label(),
                index.archiveBytes(),
                header.meshSha256(),
                header.modelSha256(),
                archiveSha256,
                index.faces(0),
                index.end(0),
                levels,
                header.provenance().format(),
                header.provenance().notes(),
                rows(index));
    }

    /**
     * Reports on a file that is cut before the end of its header.
     *
     * @param opening what the first bytes say
     * @return the report; totals, bounds, bytes, levels, hashes, format and notes are null
     */
    public static ArchiveReport of(ArchiveOpening opening) {
        BatchIndex index = opening.batches();
        return new ArchiveReport(
                null,
                null,
                null,
                channels(opening.channels()),
                opening.materials().size(),
                opening.images().size(),
                null,
                null,
                opening.origin(),
                opening.up().label(),
                null,
                null,
                null,
                null,
                index.faces(0),
                index.end(0),
                null,
                null,
                null,
                rows(index));
    }

    private static List<ChannelRow> channels(List<ChannelInfo> channels) {
        return channels.stream()
                .map(c -> new ChannelRow(c.name(), lower(c.semantic()), c.components(), lower(c.type())))
                .toList();
    }

    private static List<FaceChannelRow> faceChannels(List<FaceChannelInfo> channels) {
        return channels.stream()
                .map(c -> new FaceChannelRow(c.name(), c.components(), lower(c.type())))
                .toList();
    }

    private static List<BatchRow> rows(BatchIndex index) {
        List<BatchRow> rows = new ArrayList<>();
        for (int i = 0; i < index.size(); i++) rows.add(row(index, i));
        return rows;
    }

    /** {@return the report as one JSON object on one line} */
    public String toJson() {
        return write(this);
    }

    /**
     * The manifest of a catalogue: the same fields after {@code id}, {@code name}, {@code archiveUrl}, {@code firstUrl}
     * with {@code firstBytes} and, where the archive has a poster, {@code posterUrl}; see {@link ArchiveParts}.
     *
     * @param id of the model in the catalogue
     * @param name of the model for people
     * @param archiveUrl of the archive, may be relative to the manifest's own
     * @param annotationsUrl of what people wrote about the model, likewise; null when there is nothing
     * @return one JSON object on one line
     */
    public String toManifestJson(String id, String name, String archiveUrl, String annotationsUrl) {
        ObjectNode manifest = JSON.createObjectNode();
        manifest.put("id", id).put("name", name).put("archiveUrl", archiveUrl);
        manifest.put("firstUrl", ArchiveParts.url(archiveUrl, ArchiveParts.FIRST))
                .put("firstBytes", ArchiveParts.firstBytes(batches));
        if (ArchiveParts.hasPoster(batches))
            manifest.put("posterUrl", ArchiveParts.url(archiveUrl, ArchiveParts.POSTER));
        if (annotationsUrl != null) manifest.put("annotationsUrl", annotationsUrl);
        manifest.setAll((ObjectNode) JSON.valueToTree(this));
        return write(manifest);
    }

    private static BatchRow row(BatchIndex index, int i) {
        return new BatchRow(
                index.offset(i),
                index.bytes(i),
                lower(index.kind(i)),
                index.patches(i),
                index.faces(i),
                index.vertices(i),
                index.precisionBits(i),
                index.errorMean(i),
                index.errorQuantile(i),
                index.errorBound(i),
                index.level(i),
                index.pass(i));
    }

    private static String lower(Enum<?> value) {
        return value.name().toLowerCase(Locale.ROOT);
    }

    private static String write(Object value) {
        try {
            return JSON.writeValueAsString(value);
        } catch (JsonProcessingException e) {
            throw new IllegalStateException(e);
        }
    }
}
