package org.jsmesh.app.paper;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.jsmesh.files.ModelFiles;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.UpAxis;
import org.jsmesh.mesh.io.ModelFormat;

/**
 * A mesh in the place of a model of the paper.
 *
 * @param model of the paper
 * @param source what it is, for the reader
 * @param mesh of about as many faces as the model, or fewer, where the source has no more
 * @param whole what the mesh was made of
 */
record StandIn(PaperModel model, String source, Mesh mesh, Mesh whole) {
    /** A source of at most this share more of faces is taken as it is. */
    private static final double AS_LARGE = 1.02;

    private static final Set<String> STANDS_ON_Z = Set.of("horse", "fandisk");

    /**
     * Finds a mesh for a model: the first file of its names in the folder, or else a torus with bumps.
     *
     * @param folder null for none
     */
    static StandIn of(PaperModel model, Path folder) throws IOException {
        Path file = folder == null ? null : find(model, folder);
        int faces = model.counts.faces();
        if (file == null) {
            Mesh torus = torus(faces);
            return new StandIn(model, "a torus with bumps, made for it", torus, torus);
        }
        String name = String.valueOf(file.getFileName());
        Mesh whole = Reduction.clean(ModelFiles.read(file).mesh());
        String all = name + ", " + Figures.count(whole.faces()) + " faces";
        if (whole.faces() <= AS_LARGE * faces) return new StandIn(model, all + ", as it is", whole, whole);
        return new StandIn(
                model,
                all + ", brought down to the paper's number of faces by the default simplifier, with the normals of the"
                        + " whole surface",
                Reduction.to(whole, faces),
                whole);
    }

    /** The axis that points up, for pictures; no file says it. */
    UpAxis up() {
        return STANDS_ON_Z.stream().anyMatch(name -> source.startsWith(name + ".")) ? UpAxis.Z : UpAxis.UNKNOWN;
    }

    boolean isReduced() {
        return mesh != whole;
    }

    private static Path find(PaperModel model, Path folder) throws IOException {
        List<Path> files;
        try (Stream<Path> all = Files.list(folder)) {
            files = all.filter(StandIn::isModel)
                    .sorted(Comparator.naturalOrder())
                    .toList();
        }
        for (String name : model.files)
            for (Path file : files) if (String.valueOf(file.getFileName()).startsWith(name + ".")) return file;
        return null;
    }

    private static boolean isModel(Path file) {
        String name = String.valueOf(file.getFileName());
        return Files.isRegularFile(file) && ModelFormat.ofName(name) != null;
    }

    /** A torus with bumps of about so many faces. */
    static Mesh torus(int faces) {
        int sides = Math.max(3, (int) Math.round(Math.sqrt(faces / 6.)));
        int rings = Math.max(3, Math.round(faces / (2f * sides)));
        float[] positions = new float[3 * rings * sides];
        List<Integer> corners = new ArrayList<>();
        for (int i = 0; i < rings; i++) {
            for (int j = 0; j < sides; j++) {
                double a = 2 * Math.PI * i / rings;
                double b = 2 * Math.PI * j / sides;
                double r = 1 + .12 * StrictMath.sin(5 * a) * StrictMath.cos(3 * b);
                int at = 3 * (i * sides + j);
                positions[at] = (float) ((3 + r * StrictMath.cos(b)) * StrictMath.cos(a));
                positions[at + 1] = (float) (r * StrictMath.sin(b));
                positions[at + 2] = (float) (-(3 + r * StrictMath.cos(b)) * StrictMath.sin(a));
                int p = i * sides + j;
                int q = (i + 1) % rings * sides + j;
                int s = (i + 1) % rings * sides + (j + 1) % sides;
                int t = i * sides + (j + 1) % sides;
                corners.addAll(List.of(p, q, s, p, s, t));
            }
        }
        return new MeshBuilder()
                .positions(positions)
                .faceWedges(corners.stream().mapToInt(Integer::intValue).toArray())
                .build();
    }
}
