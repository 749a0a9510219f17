package org.jsmesh.encode;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Executor;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.archive.Provenance;
import org.jsmesh.codec.MeshFormat;
import org.jsmesh.codec.exact.NumberForms;
import org.jsmesh.collapse.CollapseMesh;
import org.jsmesh.collapse.PaperSimplifier;
import org.jsmesh.collapse.QuadricSimplifier;
import org.jsmesh.collapse.SimplificationTarget;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.encode.measure.LevelMeter;
import org.jsmesh.encode.measure.StageProgress;
import org.jsmesh.encode.measure.SurfaceFit;
import org.jsmesh.encode.measure.SurfacePoints;
import org.jsmesh.encode.write.ArchiveWriter;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.MeshCleaner;
import org.jsmesh.mesh.MeshIdentity;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.Picture;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.mesh.VertexMerger;

/**
 * Encodes meshes as archives: simplifies, codes the passes and indexes the batches. Thread-safe; the bytes depend on
 * mesh and settings alone.
 */
public final class MeshEncoder {
    private static final int LEAST_BASE_VERTICES = 16;
    private static final int MOST_BASE_VERTICES = 300;

    /** Bytes of the head, in vertices of a base. */
    private static final int HEAD_VERTICES = 26;

    /** Beyond so many faces, and with one thread, a poster is done before the rest begins, which needs the memory. */
    private static final int MOST_FACES_BESIDE = 500_000;

    private final EncoderSettings settings;
    private final Executor helpers;
    private final PosterPainter painter; // or null

    /**
     * Makes an encoder that works in the calling thread alone.
     *
     * @param settings how to encode; their number of threads does not count
     */
    public MeshEncoder(EncoderSettings settings) {
        this(settings.withThreads(1), Runnable::run);
    }

    /**
     * Makes an encoder that spreads its work over several threads.
     *
     * @param settings how to encode; with one thread the helpers get no work
     * @param helpers run the work of the threads beyond the calling one; the caller never waits for a helper that has
     *     not begun
     */
    public MeshEncoder(EncoderSettings settings, Executor helpers) {
        this(settings, helpers, null);
    }

    private MeshEncoder(EncoderSettings settings, Executor helpers, PosterPainter painter) {
        this.settings = settings;
        this.helpers = helpers;
        this.painter = painter;
    }

    /**
     * Makes archives have a poster, if the settings want one. Without this they have none.
     *
     * @param other draws the poster; null for none. With several threads it works beside the encoder
     * @return an encoder that differs in that alone
     */
    public MeshEncoder withPoster(PosterPainter other) {
        return new MeshEncoder(settings, helpers, other);
    }

    /**
     * Encodes a mesh.
     *
     * @param mesh with at least one face; it stays as it is
     * @param progress hears how far the work is and may stop it; {@link ProgressListener#NONE} for nobody
     * @return the archive, in memory as parts
     * @throws IllegalArgumentException when the mesh has no face, a number that is not finite, or more of something
     *     than an archive holds
     * @throws java.util.concurrent.CancellationException when the listener cancels
     */
    public EncodedArchive encode(Mesh mesh, ProgressListener progress) {
        return encode(mesh, Provenance.NONE, List.of(), progress);
    }

    /**
     * The same for a mesh that came from a file, with previews of textures, and with each texture at the place in the
     * archive where it does most for the picture.
     *
     * @param mesh with at least one face; it stays as it is
     * @param from the file, and what of it was lost on the way to the mesh
     * @param pictures colours of those textures of the mesh that can be read; they may be smaller than the images
     * @param progress hears how far the work is and may stop it; {@link ProgressListener#NONE} for nobody
     * @return the archive, in memory as parts
     * @throws IllegalArgumentException when the mesh has no face, a number that is not finite, or more of something
     *     than an archive holds
     * @throws java.util.concurrent.CancellationException when the listener cancels
     */
    public EncodedArchive encode(Mesh mesh, Provenance from, List<Picture> pictures, ProgressListener progress) {
        if (mesh.faces() == 0) throw new IllegalArgumentException(withoutFaces(mesh.vertices()));
        List<Note> notes = new ArrayList<>(from.notes());
        FiniteValues.check(mesh, settings.keepOrder());
        progress.step("cleaning", 0);
        Mesh cleaned = clean(mesh, notes);
        List<TextureStages.Worth> images = new TextureStages(cleaned, pictures).inOrder();
        Mesh clean = MeshBuilder.from(cleaned)
                .textures(images.stream()
                        .flatMap(worth -> worth.image().textures().stream())
                        .toList())
                .build();
        ArchiveLimits.check(clean);
        ForkedTask<byte[]> poster = ForkedTask.start(
                helpers, settings.threads(), () -> hasPoster() ? painter.paint(clean, settings.up()) : new byte[0]);
        if (settings.threads() == 1 || clean.faces() > MOST_FACES_BESIDE) poster.result();
        ForkedTask<String> identity =
                ForkedTask.start(helpers, settings.threads(), () -> MeshIdentity.sha256(clean, PlatformHash.sha256()));
        NumberForms forms = NumberForms.of(clean);
        Mesh coded = forms.coded(clean);
        CollapseMesh collapsing = new CollapseMesh(coded);
        int previewSide = images.stream()
                .mapToInt(worth -> worth.plan().previewSide())
                .max()
                .orElse(0);
        boolean stitched = collapsing.vertexOf().length > coded.vertices();
        ForkedTask<MeshFormat> format = ForkedTask.start(
                helpers,
                settings.threads(),
                () -> MeshFormat.of(coded, stitched, previewSide).withDense(settings.quality().dense));
        simplify(collapsing, progress);
        StageProgress stages = new StageProgress(progress);
        ArchiveWriter writer = writer(collapsing, format.result(), stages);
        writer.place(images.stream().map(TextureStages.Worth::plan).toList());
        if (settings.threads() > 1) writer.useHelper(new ForkedPairRunner(helpers));
        if (settings.simplifier() == Simplifier.PAPER) writer.keepLevels();
        writer.keepExact(clean, forms);
        if (settings.keepOrder()) writer.keepOrder(mesh);
        writer.show(poster.result());
        writer.tell(new Provenance(from.format(), notes), settings.up());
        List<ByteBuffer> parts = writer.write(identity.result(), (done, of) -> stages.coded((double) done / of));
        return new EncodedArchive(parts, header(parts), notes);
    }

    private ArchiveWriter writer(CollapseMesh collapsed, MeshFormat format, StageProgress stages) {
        Mesh coded = collapsed.original();
        int[] triangles = triangles(coded);
        SurfacePoints surface = stages.during("measuring", () -> new SurfacePoints(coded.positions(), triangles));
        LevelMeter meter = stages.during("measuring", () -> new LevelMeter(coded, triangles, surface, stages));
        ArchiveWriter writer = new ArchiveWriter(new SimplifiedMesh(collapsed, true), format, meter);
        writer.fitCoarse(new SurfaceFit(coded, surface, stages), settings.quality().fitting);
        return writer;
    }

    /** The vertices of all faces, three each; shared with the mesh where wedges are vertices. */
    private static int[] triangles(Mesh mesh) {
        int[] vertices = mesh.wedgeVertices();
        boolean isShared = true;
        for (int w = 0; w < vertices.length; w++) isShared &= vertices[w] == w;
        if (isShared) return mesh.faceWedges();
        int[] triangles = new int[3 * mesh.faces()];
        for (int i = 0; i < triangles.length; i++) triangles[i] = mesh.vertex(i / 3, i % 3);
        return triangles;
    }

    private boolean hasPoster() {
        return settings.poster() && painter != null;
    }

    private Mesh clean(Mesh mesh, List<Note> notes) {
        if (!settings.keepOrder()) return VertexMerger.merge(MeshCleaner.clean(mesh, notes), notes);
        Mesh clean = VertexMerger.merge(MeshCleaner.clean(mesh, new ArrayList<>()), notes); // nothing is lost
        return MeshBuilder.from(clean)
                .materials(mesh.materials())
                .faceMaterials(mesh.faceMaterials())
                .build();
    }

    private void simplify(CollapseMesh mesh, ProgressListener progress) {
        if (settings.simplifier() == Simplifier.PAPER) {
            List<Double> levels = settings.levels().isEmpty() ? PaperSimplifier.DEFAULT_THRESHOLDS : settings.levels();
            PaperSimplifier.simplify(mesh, levels, SimplificationTarget.ofFaces(settings.baseFaces()), progress);
        } else {
            QuadricSimplifier.simplify(
                    mesh,
                    target(mesh.original()),
                    settings.quality().collapsing,
                    progress,
                    helpers,
                    settings.threads());
        }
    }

    private SimplificationTarget target(Mesh mesh) {
        if (settings.baseFaces() > 0) return SimplificationTarget.ofFaces(settings.baseFaces());
        int vertices = mesh.vertices();
        // head and base then take about 1% of the bytes up to the precision for the display
        int least = Math.max(4, Math.min(LEAST_BASE_VERTICES, vertices / 8));
        return SimplificationTarget.ofVertices(
                Math.max(least, Math.min(MOST_BASE_VERTICES, vertices * 7 / 1000 - HEAD_VERTICES)));
    }

    private static ArchiveHeader header(List<ByteBuffer> parts) {
        try {
            ArchiveDecoder decoder = new ArchiveDecoder();
            for (int i = 0; decoder.header() == null; i++) {
                ByteBuffer part = parts.get(i);
                decoder.feed(part.array(), part.arrayOffset() + part.position(), part.remaining());
            }
            return decoder.header();
        } catch (MalformedStreamException e) {
            throw new IllegalStateException(e);
        }
    }

    private static String withoutFaces(int points) {
        if (points == 0) return "the mesh has no faces, there is nothing to encode. Give a model with faces";
        return "the mesh has no faces: it is a point cloud of " + points + (points == 1 ? " point" : " points")
                + ", and jSM streams triangles. Make a mesh of the points first, for example by Poisson surface"
                + " reconstruction";
    }
}
