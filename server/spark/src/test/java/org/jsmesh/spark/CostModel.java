package org.jsmesh.spark;

import java.util.Locale;
import java.util.concurrent.Callable;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** Prints what a run would take on a cluster, by the figures that were measured and the prices that are given. */
@Command(name = "CostModel", mixinStandardHelpOptions = true, showDefaultValues = true)
public final class CostModel implements Callable<Integer> {
    /** Archive, its first bytes, poster, manifest, page of the model. */
    static final int PUTS = 5;

    /** One for each object that is put: whether it is there. */
    static final int FINDS = PUTS;

    /** Two reads of the model, a look for annotations, and those. */
    private static final int GETS = 3 + FINDS;

    private static final int REQUESTS = PUTS + GETS;

    private static final double LIST_SECONDS = .1;
    private static final int KEYS_A_LIST = 1000;

    /** Poster, manifest, page. */
    private static final double SMALL_BYTES = 40_000;

    @Option(names = "--models")
    private long models = 1_000_000;

    @Option(names = "--executors")
    private int executors = 100;

    @Option(names = "--cores", description = "Of an executor.")
    private int cores = 4;

    @Option(names = "--median-faces", description = "Faces are taken to be log-normal.")
    private double median = 8_000;

    @Option(names = "--sigma", description = "Of the logarithm of the faces.")
    private double sigma = 2;

    @Option(names = "--bytes-a-face", description = "Of an archive.")
    private double bytesOfFace = 3.5;

    @Option(names = "--used", description = "Share of the cores' time that encodes.")
    private double used = .85;

    @Option(
            names = "--request-millis",
            description = "A core waits for it, as the requests of a model follow each other.")
    private double requestMillis = 25;

    @Option(names = "--core-hour", description = "Dollars.")
    private double coreHour = .06;

    @Option(names = "--thousand-puts", description = "Dollars.")
    private double puts = .005;

    @Option(names = "--thousand-gets", description = "Dollars.")
    private double gets = .0004;

    @Option(names = "--gigabyte-month", description = "Dollars.")
    private double storage = .023;

    /**
     * Prints.
     *
     * @param args see {@code --help}
     */
    public static void main(String[] args) {
        System.exit(new CommandLine(new CostModel()).execute(args));
    }

    @Override
    public Integer call() {
        double mean = median * Math.exp(sigma * sigma / 2);
        double seconds = models * new PlannedModel("", null, Math.round(mean), 0).seconds();
        double listing = LIST_SECONDS * models / KEYS_A_LIST;
        double waiting = models * REQUESTS * requestMillis / 1000;
        double hours = (listing + (seconds + waiting) / (executors * cores * used)) / 3600;
        double gigabytes = models * (bytesOfFace * mean + SMALL_BYTES) / 1e9;
        double cpu = hours * executors * cores * coreHour;
        double put = puts * models * PUTS / 1000;
        double get = gets * models * GETS / 1000;
        row("models", "%,d", (double) models);
        row("mean faces", "%,.0f", mean);
        row("CPU hours of encoding", "%,.0f", seconds / 3600);
        row("core hours of waiting for " + REQUESTS + " requests a model", "%,.0f", waiting / 3600);
        row("hours with " + executors + " executors of " + cores + " cores", "%.2f", hours);
        row("cores, dollars", "%.2f", cpu);
        row(PUTS + " PUTs a model, dollars", "%.2f", put);
        row(GETS + " GETs and HEADs a model, dollars", "%.2f", get);
        row("sum of one run, dollars", "%.2f", cpu + put + get);
        row("archives, GB", "%,.0f", gigabytes);
        row("storage, dollars a month", "%.2f", gigabytes * storage);
        row("a run in which nothing has changed: GETs and HEADs, dollars", "%.2f", gets * models / 1000);
        row("longest model, a core alone, minutes, of " + models + " log-normal ones", "%.1f", longest() / 60);
        return 0;
    }

    /** Of the largest of so many models: the quantile 1 - 1/n of a normal distribution, about. */
    private double longest() {
        double n = Math.max(3, models);
        double z = Math.sqrt(2 * Math.log(n))
                - (Math.log(Math.log(n)) + Math.log(4 * Math.PI)) / (2 * Math.sqrt(2 * Math.log(n)));
        return new PlannedModel("", null, Math.round(median * Math.exp(sigma * z)), 0).seconds();
    }

    private static void row(String name, String format, double value) {
        String text = format.endsWith("d")
                ? String.format(Locale.ROOT, format, (long) value)
                : String.format(Locale.ROOT, format, value);
        System.out.println("| " + name + " | " + text + " |");
    }
}
