package org.jsmesh.spark;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.Charset;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import org.apache.spark.SparkConf;
import org.apache.spark.api.java.JavaSparkContext;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.flags.EncodeFlags;
import org.jsmesh.flags.PublicUrl;
import org.jsmesh.objects.ObjectStores;
import org.jsmesh.webapp.ViewerFiles;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Encodes a catalogue on a cluster: {@code spark-submit --class org.jsmesh.spark.EncodeCatalogue jsm-spark.jar}. */
@Command(
        name = "EncodeCatalogue",
        sortOptions = false,
        mixinStandardHelpOptions = true,
        exitCodeOnExecutionException = EncodeCatalogue.NOT_DONE,
        description = {
            "Encodes model files of folders and buckets, and publishes them as a static site.",
            "Run again, it does only what has changed. A file that cannot be encoded fails alone."
        },
        footer = {
            "",
            "Exit code: 0, or 1 when models failed, or 2 when the run did not come to its end.",
            "Example:",
            "  spark-submit --class org.jsmesh.spark.EncodeCatalogue jsm-spark.jar s3://scans/raw --site s3://public/models"
        })
public final class EncodeCatalogue implements Callable<Integer> {
    /** Code of a run that could not begin or did not come to its end. */
    static final int NOT_DONE = 2;

    private static final String MOST_FAILURES_OF_A_TASK = "16";

    @Spec
    private CommandSpec spec;

    @Parameters(
            arity = "0..*",
            paramLabel = "INPUT",
            description = "Folders, s3://bucket/prefix, or single files. Folders must be the same for all machines.")
    private List<String> inputs = new ArrayList<>();

    @Option(
            names = "--list",
            paramLabel = "FILE",
            description = {
                "A file with the address of a model a line, here or in a bucket.",
                "Behind a tab there may be the model's place in the catalogue, which its id is made of."
            })
    private List<String> lists = new ArrayList<>();

    @Option(
            names = "--site",
            required = true,
            paramLabel = "OUT",
            description = "The folder or s3://bucket/prefix of the site. Models that are in it already stay.")
    private String site;

    @Option(
            names = "--report",
            paramLabel = "OUT",
            description = {
                "The folder or s3://bucket/prefix of the report, which the next run begins with.",
                "Default: beside the site, its name with -report at its end."
            })
    private String report;

    @Option(
            names = "--public-url",
            paramLabel = "URL",
            description = "Where visitors find the site. Those who show links to a model then find its picture.")
    private String publicUrl;

    @Option(names = "--prune", description = "Take the models off the site that are not among the inputs.")
    private boolean prune;

    @Mixin
    private EncodeFlags encode = new EncodeFlags();

    /**
     * Runs, and ends this process with the exit code.
     *
     * @param args as {@code --help} describes them
     */
    public static void main(String[] args) {
        int code = run(args);
        // Without a failure Spark ends the process itself, also where it belongs to a cluster manager.
        if (code != 0) System.exit(code);
    }

    static int run(String... args) {
        return new CommandLine(new EncodeCatalogue())
                .setOut(new PrintWriter(System.out, true, Charset.defaultCharset()))
                .setErr(new PrintWriter(System.err, true, Charset.defaultCharset()))
                .execute(args);
    }

    @Override
    public Integer call() throws IOException {
        CatalogueSettings settings = settings();
        PrintWriter err = spec.commandLine().getErr();
        SparkConf conf = new SparkConf();
        conf.setIfMissing("spark.app.name", "jSM " + settings.site());
        // An executor may be lost to a model that does not fit; the tasks then find out which.
        conf.setIfMissing("spark.task.maxFailures", MOST_FAILURES_OF_A_TASK);
        // What tasks read lies in stores, which are as near to one executor as to the other.
        conf.setIfMissing("spark.locality.wait", "0s");
        try (JavaSparkContext spark = begin(conf)) {
            Outcome outcome = CatalogueRun.run(spark, settings, ViewerFiles.read(), EncodeModel::new);
            for (Row row : outcome.failures()) err.println(line(row.failure()));
            if (outcome.failed() > outcome.failures().size())
                err.println("All that failed is in " + settings.report() + " (state = failed).");
            spec.commandLine().getOut().println(settings.site() + ": " + outcome);
            return outcome.failed() == 0 ? 0 : 1;
        } catch (CatalogueException e) {
            err.println(e.getMessage());
            return NOT_DONE;
        }
    }

    private static JavaSparkContext begin(SparkConf conf) throws CatalogueException {
        // Scala's code throws checked exceptions that it does not declare.
        Callable<JavaSparkContext> spark = () -> new JavaSparkContext(conf);
        try {
            return spark.call();
        } catch (Exception e) {
            throw CatalogueException.notBegun(e);
        }
    }

    private static String line(Row.Failure failure) {
        return failure.place() + ": " + failure.reason() + "."
                + (failure.remedy().isEmpty() ? "" : " " + failure.remedy() + ".");
    }

    private CatalogueSettings settings() {
        if (inputs.isEmpty() && lists.isEmpty())
            throw new ParameterException(spec.commandLine(), "Missing required parameter: 'INPUT', or '--list FILE'");
        EncoderSettings encoder = encode.settings(spec);
        String place = folder("--site", site);
        if (report == null && isWholeBucket(place))
            throw new ParameterException(
                    spec.commandLine(),
                    "--site " + site + " is a whole bucket, and beside it is no place for the report. Say with --report"
                            + " where it goes, such as s3://another-bucket/report");
        String reportPlace = report == null ? place + "-report" : folder("--report", report);
        if (Addresses.isWithin(reportPlace, place) || Addresses.isWithin(place, reportPlace))
            throw new ParameterException(
                    spec.commandLine(),
                    "--report " + reportPlace + ": it and the site " + place
                            + " must not lie in each other, as visitors"
                            + " would see the addresses of the inputs. Say another place");
        return new CatalogueSettings(
                List.copyOf(inputs),
                List.copyOf(lists),
                place,
                reportPlace,
                PublicUrl.of(spec, publicUrl),
                prune,
                encoder);
    }

    private static boolean isWholeBucket(String place) {
        return ObjectStores.isRemote(place) && place.indexOf('/', place.indexOf("://") + 3) < 0;
    }

    private String folder(String option, String given) {
        try {
            return Addresses.folder(given);
        } catch (IllegalArgumentException e) {
            throw new ParameterException(spec.commandLine(), option + " " + e.getMessage(), e);
        }
    }
}
