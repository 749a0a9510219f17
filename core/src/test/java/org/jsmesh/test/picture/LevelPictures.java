package org.jsmesh.test.picture;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.TreeSet;
import javax.imageio.ImageIO;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.encode.EncodedArchive;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.encode.MeshEncoder;
import org.jsmesh.encode.Simplifier;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.mesh.io.ModelReader;
import org.jsmesh.test.SampleModels;

/**
 * Draws the pictures of {@code docs/results}: models by level of detail, as in figures 9 and 10 of Chen and Nishita
 * 2002, every face in one shade. One row by the paper's simplifier, one by the default. Arguments: the folder to write
 * to.
 */
public final class LevelPictures {
    private static final int COLUMNS = 4;
    private static final int WIDTH = 250;
    private static final int HEIGHT = 210;
    private static final Light LIGHT = new Light(
            new double[] {.35, .37, .4},
            new double[] {.15, .15, .15},
            new double[] {.6, .6, .58},
            new double[] {.4, .6, .7},
            new double[] {.12, .12, .14},
            new double[] {-.7, .1, .3},
            0,
            1);

    private LevelPictures() {}

    public static void main(String[] arguments) throws IOException, MalformedStreamException {
        for (String model : List.of("planetary-gear.obj", "amphora.obj", "octopus.ply")) {
            BufferedImage picture = new BufferedImage(COLUMNS * WIDTH, 2 * HEIGHT, BufferedImage.TYPE_INT_RGB);
            Graphics2D graphics = picture.createGraphics();
            graphics.setColor(Color.WHITE);
            graphics.fillRect(0, 0, picture.getWidth(), picture.getHeight());
            graphics.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, 12));
            Mesh mesh = read(SampleModels.project().resolve("models").resolve(model));
            int row = 0;
            for (Simplifier simplifier : List.of(Simplifier.PAPER, Simplifier.QUADRIC))
                drawRow(graphics, HEIGHT * row++, mesh, simplifier);
            graphics.dispose();
            String name = model.substring(0, model.indexOf('.')) + "-levels.png";
            ImageIO.write(picture, "png", Path.of(arguments[0], name).toFile());
        }
    }

    static Mesh read(Path file) throws IOException {
        return ModelReader.read(file.getFileName().toString(), Files.readAllBytes(file), path -> {
                    Path beside = file.resolveSibling(path);
                    return Files.isRegularFile(beside) ? Optional.of(Files.readAllBytes(beside)) : Optional.empty();
                })
                .mesh();
    }

    private static void drawRow(Graphics2D graphics, int top, Mesh mesh, Simplifier simplifier)
            throws MalformedStreamException {
        EncodedArchive archive = new MeshEncoder(EncoderSettings.defaults().withSimplifier(simplifier))
                .encode(mesh, ProgressListener.NONE);
        BatchIndex index = archive.header().batches();
        int levels = archive.header().levels().size();
        View view = View.framing(mesh.bounds(), 35, 20, 40, 1.2, (double) WIDTH / HEIGHT);
        int column = 0;
        for (int level : chosen(index, levels)) {
            int batch = lastOf(index, level);
            ArchiveDecoder decoder = new ArchiveDecoder();
            decoder.feed(archive.bytes(), 0, (int) index.end(level == levels ? index.size() - 1 : batch));
            int x = column++ * WIDTH;
            graphics.drawImage(draw(decoder.mesh(), view, WIDTH, HEIGHT - 34), x, top + 34, null);
            graphics.setColor(Color.DARK_GRAY);
            String name = level == 0 ? "base" : level == levels ? "original" : "level " + level;
            graphics.drawString(
                    simplifier.name().toLowerCase(Locale.ROOT) + ", " + name + ": " + index.faces(batch) + " faces",
                    x + 8,
                    top + 16);
            graphics.drawString(
                    String.format(Locale.ROOT, "mean error %.3f%%", level == levels ? 0 : index.errorMean(batch)),
                    x + 8,
                    top + 31);
        }
    }

    /** A picture with every face in one shade. */
    static BufferedImage draw(Mesh mesh, View view, int width, int height) {
        return new SoftwareRasteriser(faceted(mesh)).draw(view, LIGHT, width, height);
    }

    /**
     * All levels, or those with face counts nearest to equal steps between base and original on a logarithmic scale.
     */
    private static List<Integer> chosen(BatchIndex index, int levels) {
        TreeSet<Integer> chosen = new TreeSet<>();
        double ratio = Math.log((double) index.faces(index.size() - 1) / index.faces(0));
        for (int i = 0; i < COLUMNS; i++) {
            double wanted = index.faces(0) * Math.exp(ratio * i / (COLUMNS - 1));
            int best = 0;
            for (int level = 1; level <= levels; level++) {
                double distance = Math.abs(Math.log(index.faces(lastOf(index, level)) / wanted));
                if (distance < Math.abs(Math.log(index.faces(lastOf(index, best)) / wanted))) best = level;
            }
            chosen.add(levels < COLUMNS ? Math.min(i, levels) : i + 1 == COLUMNS ? levels : best);
        }
        return new ArrayList<>(chosen);
    }

    private static int lastOf(BatchIndex index, int level) {
        int last = 0;
        for (int b = 0; b < index.size(); b++) if (index.level(b) <= level) last = b;
        return last;
    }

    /** The same mesh with vertices for every face, so that each is drawn flat. */
    private static Mesh faceted(Mesh mesh) {
        int corners = 3 * mesh.faces();
        float[] positions = new float[3 * corners];
        int[] wedges = new int[corners];
        for (int c = 0; c < corners; c++) {
            wedges[c] = c;
            System.arraycopy(mesh.positions(), 3 * mesh.vertex(c / 3, c % 3), positions, 3 * c, 3);
        }
        List<Channel> channels = new ArrayList<>();
        for (Channel channel : mesh.channels()) {
            if (channel.semantic() == Channel.Semantic.NORMAL) continue;
            int n = channel.components();
            int[] values = new int[n * corners];
            for (int c = 0; c < corners; c++)
                System.arraycopy(channel.values(), n * mesh.faceWedges()[c], values, n * c, n);
            channels.add(channel.withValues(values, null));
        }
        return new MeshBuilder()
                .positions(positions)
                .faceWedges(wedges)
                .channels(channels)
                .faceMaterials(mesh.faceMaterials())
                .materials(mesh.materials())
                .textures(mesh.textures())
                .build();
    }
}
