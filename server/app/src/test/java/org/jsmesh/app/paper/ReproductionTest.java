package org.jsmesh.app.paper;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import javax.imageio.ImageIO;
import org.jsmesh.app.Bumpy;
import org.jsmesh.mesh.ProgressListener;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** All experiments of small models, over the real servers, proxies and client, at generous rates. */
@Tag("long")
class ReproductionTest {
    private static final int RINGS = 42;
    private static final int FACES = 2 * RINGS * RINGS / 3;
    private static final List<LinkKind> LINKS =
            List.of(new LinkKind("fast", 1e9, 0), new LinkKind("less fast", 1e8, 0), new LinkKind("slow", 4e6, 1));

    @TempDir
    private static Path folder;

    private static Path out;

    @BeforeAll
    static void reproduce() throws Exception {
        Path models = Files.createDirectories(folder.resolve("models"));
        for (String name : List.of("bunny", "dragon", "cessna", "fandisk"))
            Bumpy.write(models.resolve(name + ".ply"), RINGS);
        out = folder.resolve("out");
        // No file has the name of the hand: a generated mesh stands for it.
        new Reproduction(models, out, false, LINKS, new Timing(0), file -> {}, ProgressListener.NONE)
                .run(new HashSet<>(Reproduction.PARTS));
    }

    @ParameterizedTest
    @ValueSource(strings = {"table1", "table2", "table3", "table4", "table5", "figure8", "figure9", "figure10"})
    void shouldWriteAPageThatFits(String part) throws Exception {
        List<String> lines = Files.readAllLines(out.resolve(part + ".md"));
        assertThat(lines.get(0)).startsWith("# " + (part.startsWith("table") ? "Table " : "Figure "));
        assertThat(lines).filteredOn(line -> !line.startsWith("|")).allMatch(line -> line.length() <= 120);
        assertThat(Files.readString(out.resolve("README.md"))).contains("](" + part + ".md)");
    }

    @Test
    void shouldNameTheStandIns() throws Exception {
        assertThat(Files.readString(out.resolve("README.md")))
                .contains("| bunny | 2,915 faces, 1,494 vertices | 1,176 faces", "bunny.ply, 1,176 faces, as it is")
                .contains("a torus with bumps, made for it");
    }

    @ParameterizedTest
    @ValueSource(strings = {"table1", "table2", "table3", "table4", "table5"})
    void shouldSetFiguresBesideThoseOfThePaper(String part) throws Exception {
        List<String[]> rows = csv(part);
        String[] header = rows.get(0);
        int paper = Arrays.asList(header).indexOf("paper");
        int ratios = 0;
        for (String[] row : rows.subList(1, rows.size())) {
            assertThat(row).hasSameSizeAs(header);
            for (int i = paper + 1; i < header.length; i += 2) {
                if (row[i].isEmpty()) continue;
                double here = Double.parseDouble(row[i]);
                assertThat(here).isNotNegative();
                if (row[paper].isEmpty()) continue;
                double expected = here / Double.parseDouble(row[paper]);
                assertThat(Double.parseDouble(row[i + 1])).isCloseTo(expected, within(.02 * expected + .001));
                ratios++;
            }
        }
        assertThat(ratios).isGreaterThanOrEqualTo(15);
    }

    /** As they are printed: the cells of the rows that begin so, in their order. */
    @ParameterizedTest
    @CsvSource(
            delimiter = ';',
            quoteCharacter = '"',
            value = {
                "table1; bunny|faces; 2915 531",
                "table1; bunny|vertices; 1494 302",
                "table1; dragon|faces; 2730 1704",
                "table1; dragon|vertices; 1257 744",
                "table1; hand|faces; 2130 1852",
                "table1; hand|vertices; 1055 916",
                "table1; cessna|faces; 13546 5720",
                "table1; cessna|vertices; 6795 2882",
                "table1; fandisk|faces; 12946 1518",
                "table1; fandisk|vertices; 6475 761",
                "table1; bunny|ms; 681 681",
                "table1; dragon|ms; 540 540",
                "table1; hand|ms; 370 370",
                "table1; cessna|ms; 5040 5040",
                "table1; fandisk|ms; 6477 6477",
                "table2; bunny; 73238 13984 33.5",
                "table2; dragon; 63811 37328 34.1",
                "table2; hand; 50715 42960 33.9",
                "table2; cessna; 528002 183435 25.7",
                "table2; fandisk; 280979 63345 25.1",
                "table3; fast; 411 45 150 206558",
                "table3; less fast; 982 190 761 207814",
                "table3; slow; 10956 2143 6039 -",
                "table3; any; 71962 13644 39859 121459 -",
                "table4; original; 2915 1494 10956",
                "table4; simplified; 531 302 2143",
                "table4; reconstructed, 39% of the faces; 1145 609 4545",
                "table4; reconstructed, 60% of the faces; 1739 906 6737",
                "table4; reconstructed, all; 2915 1494 11182",
                "table5; paper's size|500 ms|fast; 195 2915 1494 -",
                "table5; paper's size|500 ms|less fast; 761 1707 890 -",
                "table5; paper's size|2000 ms|slow; 2143 531 302 -"
            })
    void shouldHaveTheFiguresOfThePaper(String part, String row, String figures) throws Exception {
        List<String[]> rows = csv(part);
        int paper = Arrays.asList(rows.get(0)).indexOf("paper");
        String found = rows.stream()
                .filter(cells -> String.join("|", cells).startsWith(row))
                .map(cells -> cells[paper].isEmpty() ? "-" : cells[paper])
                .collect(Collectors.joining(" "));
        assertThat(found).isEqualTo(figures);
    }

    @Test
    void shouldHaveThePatchesOfThePaperInFull() {
        assertThat(Arrays.stream(PaperModel.values()).map(model -> model.sizes.patch()))
                .containsExactly(33.451, 34.058, 33.856, 25.653, 25.089);
    }

    @Test
    void shouldHaveTheModelsWithTheirFaces() throws Exception {
        assertThat(cell("table1", "bunny", "faces, original", "jSM, default")).isEqualTo(FACES);
        assertThat(cell("table1", "bunny", "faces, simplified", "jSM, `--simplifier paper`"))
                .isBetween(4., FACES - 2.);
        assertThat(cell("table4", "reconstructed, all", "faces", "here")).isEqualTo(FACES);
        assertThat(cell("table4", "simplified", "faces", "here"))
                .isEqualTo(cell("table1", "bunny", "faces, simplified", "jSM, default"));
        assertThat(cell("table4", "reconstructed, 39% of the faces", "faces", "here"))
                .isBetween(.39 * FACES, (double) FACES);
    }

    @Test
    void shouldFetchPatchByPatch() throws Exception {
        for (String column : List.of("text, gzip", "jSM")) {
            double all = cell("table3", "any", "all patches at once, bytes", column);
            double heads = cell("table3", "any", "one patch at once, bytes with heads", column);
            assertThat(heads).isGreaterThan(5 * all);
        }
        // Each patch of the text is a file, with what gzip puts around it.
        assertThat(cell("table3", "any", "one patch at once, bytes", "text, gzip"))
                .isGreaterThan(2 * cell("table3", "any", "all patches at once, bytes", "text, gzip"));
        // The ranges of the archive are all of it but the base.
        assertThat(cell("table3", "any", "one patch at once, bytes", "jSM"))
                .isEqualTo(cell("table3", "any", "all patches at once, bytes", "jSM"));
    }

    @Test
    void shouldRecordTheConversation() throws Exception {
        List<String[]> rows = csv("figure8");
        assertThat(rows.get(0)).containsExactly("from ms", "to ms", "method", "path", "range", "status", "bytes");
        assertThat(rows.get(1)[3]).isEqualTo("`/m/bunny/`");
        assertThat(rows.get(2)[3]).isEqualTo("`/m/bunny/manifest.json`");
        assertThat(rows.get(3)[3]).isEqualTo("`/m/bunny/SHA.jsm`");
        assertThat(rows.get(3)[4]).startsWith("bytes=0-");
        assertThat(rows.get(3)[5]).isEqualTo("206");
        double last = 0;
        for (String[] row : rows.subList(1, rows.size())) {
            assertThat(row[2]).isEqualTo("GET");
            assertThat(Double.parseDouble(row[0])).isBetween(last, Double.parseDouble(row[1]));
            last = Double.parseDouble(row[0]);
        }
    }

    @Test
    void shouldDrawTheFigures() throws Exception {
        assertThat(colours("figure9", 5 * Drawing.WIDTH, 2 * Drawing.HEIGHT)).isGreaterThan(100);
        assertThat(colours("figure10", 5 * Drawing.WIDTH, 3 * Drawing.HEIGHT)).isGreaterThan(100);
    }

    private static int colours(String name, int width, int height) throws IOException {
        File file = out.resolve(name + ".png").toFile();
        BufferedImage image = ImageIO.read(file);
        assertThat(image.getWidth()).isEqualTo(width);
        assertThat(image.getHeight()).isEqualTo(height);
        Set<Integer> colours = new HashSet<>();
        for (int y = 0; y < height; y++) for (int x = 0; x < width; x++) colours.add(image.getRGB(x, y));
        return colours.size();
    }

    @Test
    void shouldBringALargerModelDown() throws Exception {
        Path models = Files.createDirectories(folder.resolve("larger"));
        Bumpy.write(models.resolve("stanford-bunny.ply"), 90);
        StandIn bunny = StandIn.of(PaperModel.BUNNY, models);
        assertThat(bunny.isReduced()).isTrue();
        assertThat(bunny.whole().faces()).isEqualTo(5400);
        assertThat(bunny.mesh().faces()).isBetween(2800, 2915);
        assertThat(bunny.source()).startsWith("stanford-bunny.ply, 5,400 faces").contains("brought down");
    }

    @Test
    void shouldRunSomePartsAlone() throws Exception {
        Path some = folder.resolve("some");
        new Reproduction(null, some, false, LINKS, new Timing(0), file -> {}, ProgressListener.NONE)
                .run(Set.of("table2"));
        assertThat(some.toFile().list()).containsExactlyInAnyOrder("table2.md", "table2.csv", "README.md");
    }

    private static double cell(String part, String first, String figure, String column) throws IOException {
        List<String[]> rows = csv(part);
        int at = Arrays.asList(rows.get(0)).indexOf(column);
        List<String> found = new ArrayList<>();
        for (String[] row : rows) if (row[0].equals(first) && row[1].equals(figure)) found.add(row[at]);
        assertThat(found).as("%s, %s", first, figure).hasSize(1);
        return Double.parseDouble(found.get(0));
    }

    private static List<String[]> csv(String part) throws IOException {
        Pattern cell = Pattern.compile("(?:^|,)(?:\"((?:[^\"]|\"\")*)\"|([^,\"]*))");
        List<String[]> rows = new ArrayList<>();
        for (String line : Files.readAllLines(out.resolve(part + ".csv"))) {
            List<String> cells = new ArrayList<>();
            Matcher m = cell.matcher(line);
            while (m.find())
                cells.add(m.group(1) == null ? m.group(2) : m.group(1).replace("\"\"", "\""));
            rows.add(cells.toArray(new String[0]));
        }
        return rows;
    }
}
