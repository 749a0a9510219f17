package org.jsmesh.spark;

import java.io.File;
import java.io.IOException;
import java.util.List;
import org.apache.spark.SparkConf;
import org.apache.spark.api.java.JavaSparkContext;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.s3.testing.S3Mock;
import org.jsmesh.webapp.ViewerFiles;

/** Two executors of one core and 1 GiB in processes of their own, which know of a service that speaks S3. */
final class Cluster {
    private static JavaSparkContext shared;

    private Cluster() {}

    /** One for all tests of a JVM; it ends with that. */
    static synchronized JavaSparkContext shared() {
        if (shared == null) shared = start();
        return shared;
    }

    /** Ends it; the next test begins another. */
    static synchronized void stop() {
        shared().stop();
        shared = null;
    }

    private static JavaSparkContext start() {
        // Of an installation, which there is none of: the class path has all.
        if (!new File("jars").mkdir() && !new File("jars").isDirectory()) throw new IllegalStateException("jars");
        SparkConf conf = new SparkConf()
                .setMaster("local-cluster[2,1,1024]")
                .setAppName("jSM tests")
                .set("spark.ui.enabled", "false")
                .set("spark.driver.host", "127.0.0.1")
                .set("spark.driver.bindAddress", "127.0.0.1")
                .set("spark.task.maxFailures", "16")
                .set("spark.executor.extraJavaOptions", "-XX:TieredStopAtLevel=1 -XX:+UseSerialGC")
                .set("spark.executor.extraClassPath", System.getProperty("java.class.path"));
        S3Mock.shared().environment().forEach((name, value) -> conf.setExecutorEnv(name, value));
        return new JavaSparkContext(conf);
    }

    static CatalogueSettings settings(String input, String site) {
        return new CatalogueSettings(
                List.of(input), List.of(), site, site + "-report", null, false, EncoderSettings.defaults());
    }

    static Outcome run(CatalogueSettings settings) throws CatalogueException, IOException {
        return run(settings, EncodeModel::new);
    }

    static Outcome run(CatalogueSettings settings, CatalogueRun.Works works) throws CatalogueException, IOException {
        return CatalogueRun.run(shared(), settings, ViewerFiles.read(), works);
    }

    /** {@return the rows of the report} */
    static List<Row> report(CatalogueSettings settings) throws IOException {
        Ledger ledger = new Ledger(Worker.store(settings.report()));
        List<Row> rows = new java.util.ArrayList<>();
        for (String part : ledger.summary().orElseThrow().parts()) ledger.read(part, rows::add);
        return rows;
    }
}
