package org.jsmesh.desktop.draw;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.display.CreaseAngle;
import org.jsmesh.display.LiveMesh;
import org.jsmesh.display.LiveStep;
import org.jsmesh.encode.EncodedArchive;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.session.MeshStep;

/** The steps of an archive, one for every few batches, and the whole mesh after each. */
public final class TestSteps {
    public final List<SceneStep> steps = new ArrayList<>();
    public final List<Mesh> meshes = new ArrayList<>();
    public final List<Double> creases = new ArrayList<>();
    public final Framing framing;
    public int taken;
    private final boolean isClosed;

    public TestSteps(EncodedArchive archive, int stride) throws MalformedStreamException {
        this(archive, archive.header(), stride);
    }

    /** @param header what the scenes are told of the archive */
    TestSteps(EncodedArchive archive, ArchiveHeader header, int stride) throws MalformedStreamException {
        BatchIndex index = archive.header().batches();
        isClosed = archive.header().isClosed();
        framing = Framing.of(archive.header().bounds(), archive.header().up());
        LiveScenes scenes = new LiveScenes(header, framing, new TextureImages());
        ArchiveDecoder decoder = new ArchiveDecoder();
        LiveMesh live = null;
        int vertices = 0;
        int faces = 0;
        for (int batch = 0; batch < index.size(); batch++) {
            boolean isLast = batch == index.size() - 1;
            if (batch % stride != 0 && !isLast) continue;
            decoder.feed(archive.bytes(), (int) decoder.received(), (int) (index.end(batch) - decoder.received()));
            if (live == null)
                live = new LiveMesh(decoder.growing(), decoder.opening().materials());
            double crease = CreaseAngle.cosine(
                    decoder.faces(), index.faces(0), archive.header().faces());
            live.update(crease);
            LiveStep step = LiveStep.of(live, vertices, false);
            vertices = step.vertices();
            int[] places = new int[decoder.growing().faceNumbers() - faces];
            int count = 0;
            for (int f = faces; f < faces + places.length; f++) if (live.place(f) >= 0) places[count++] = live.place(f);
            faces += places.length;
            byte[] levels = new byte[count];
            Arrays.fill(levels, (byte) index.level(batch));
            Mesh mesh = decoder.mesh();
            steps.add(scenes.next(
                    new MeshStep(step, Arrays.copyOf(places, count), levels, mesh, isLast, null, () -> taken++)));
            meshes.add(mesh);
            creases.add(crease);
        }
    }

    /** The scene after a step, made as a whole. */
    public Scene whole(int step) {
        return Scene.of(meshes.get(step), creases.get(step), isClosed, framing, new TextureImages());
    }
}
