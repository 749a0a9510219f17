package org.jsmesh.app.paper;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.jsmesh.files.AtomicFiles;
import org.jsmesh.files.OutputFiles;
import org.jsmesh.mesh.ProgressListener;

/**
 * Runs the experiments of Chen and Nishita 2002, and writes for each a page of Markdown, its figures as CSV, and its
 * picture as PNG; and a page that leads to them.
 */
public final class Reproduction {
    /** Names of the experiments, in the order in which they run. */
    public static final List<String> PARTS =
            List.of("table1", "table2", "table3", "table4", "table5", "figure8", "figure9", "figure10");

    private static final Set<String> OVER_LINKS = Set.of("table3", "table4", "table5", "figure8");

    private final Path models;
    private final Path out;
    private final boolean kernel;
    private final List<LinkKind> links;
    private final Timing timing;
    private final Consumer<Path> written;
    private final ProgressListener progress;
    private List<StandIn> standIns;

    /**
     * @param models folder with the models or their stand-ins; null for none
     * @param out folder to write to, made when it is missing
     * @param kernel whether the kernel shapes the links, instead of a proxy
     * @param written hears of every file
     * @param progress hears of the stages
     */
    public Reproduction(Path models, Path out, boolean kernel, Consumer<Path> written, ProgressListener progress) {
        this(models, out, kernel, LinkKind.ALL, Timing.USUAL, written, progress);
    }

    /** @param links from the fastest to the slowest: three, as in the paper */
    Reproduction(
            Path models,
            Path out,
            boolean kernel,
            List<LinkKind> links,
            Timing timing,
            Consumer<Path> written,
            ProgressListener progress) {
        this.models = models;
        this.out = out;
        this.kernel = kernel;
        this.links = links;
        this.timing = timing;
        this.written = written;
        this.progress = progress;
    }

    /**
     * Runs experiments.
     *
     * @param parts some of {@link #PARTS}; their order does not count
     */
    public void run(Set<String> parts) throws IOException {
        Files.createDirectories(out);
        standIns = new ArrayList<>();
        for (PaperModel model : PaperModel.values()) {
            progress.step("models", (double) model.ordinal() / PaperModel.values().length);
            standIns.add(StandIn.of(model, models));
        }
        String loadBefore = load();
        ModelTables tables = new ModelTables(standIns, timing, progress);
        PaperFigures figures = new PaperFigures(standIns, progress);
        if (parts.contains("table1")) write(tables.first());
        if (parts.contains("table2")) write(tables.second());
        if (parts.stream().anyMatch(OVER_LINKS::contains)) overLinks(parts);
        if (parts.contains("figure9")) write(figures.ninth());
        if (parts.contains("figure10")) write(figures.tenth());
        write(
                "README.md",
                Contents.of(out, standIns, machine(), loadBefore, load()).getBytes(StandardCharsets.UTF_8));
    }

    private void overLinks(Set<String> parts) throws IOException {
        Path folder = Files.createTempDirectory("jsm-reproduce-");
        try {
            progress.step("archives", 0);
            Served served = Served.in(folder, standIns.get(0));
            try (Wire wire = kernel ? new KernelWire(folder) : new ProxyWire(folder)) {
                TransmissionTable transmission = new TransmissionTable(served, wire, links, progress);
                if (parts.contains("table3")) write(transmission.measure());
                RefinementTables tables = new RefinementTables(served, wire, links, progress);
                if (parts.contains("table4")) write(tables.fourth(transmission));
                if (parts.contains("table5")) write(tables.fifth());
                LinkKind slowest = links.get(links.size() - 1);
                if (parts.contains("figure8")) write(new Conversation(served, wire, folder, progress).record(slowest));
            }
        } finally {
            delete(folder);
        }
    }

    private void write(PaperTable table) throws IOException {
        write(table.name() + ".md", table.markdown().getBytes(StandardCharsets.UTF_8));
        write(table.name() + ".csv", table.csv().getBytes(StandardCharsets.UTF_8));
    }

    private void write(Drawing.Figure figure) throws IOException {
        write(figure.name() + ".png", figure.png());
        write(figure.name() + ".md", figure.markdown().getBytes(StandardCharsets.UTF_8));
    }

    private void write(String name, byte[] content) throws IOException {
        Path file = out.resolve(name);
        OutputFiles.requireReplaceable(file);
        AtomicFiles.write(file, content);
        written.accept(file);
    }

    private static void delete(Path folder) throws IOException {
        try (Stream<Path> all = Files.walk(folder)) {
            for (Path file : all.sorted(Comparator.reverseOrder()).toList()) Files.delete(file);
        }
    }

    private static String machine() throws IOException {
        Path cpus = Path.of("/proc/cpuinfo");
        String model = System.getProperty("os.arch");
        if (Files.isReadable(cpus)) {
            model = Files.readAllLines(cpus).stream()
                    .filter(line -> line.startsWith("model name"))
                    .map(line -> line.substring(line.indexOf(':') + 1).strip())
                    .findFirst()
                    .orElse(model);
        }
        return model + ", " + Runtime.getRuntime().availableProcessors() + " processors, "
                + System.getProperty("os.name") + ", Java " + System.getProperty("java.version");
    }

    /** Programs that wanted to run in the last minute, on average. */
    private static String load() {
        double load = ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage();
        return load < 0 ? "unknown" : String.format(Locale.ROOT, "%.2f", load);
    }
}
