package org.jsmesh.bench;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.openjdk.jmh.runner.Runner;
import org.openjdk.jmh.runner.RunnerException;
import org.openjdk.jmh.runner.options.CommandLineOptionException;
import org.openjdk.jmh.runner.options.CommandLineOptions;
import org.openjdk.jmh.runner.options.OptionsBuilder;

/**
 * Runs the benchmarks on the generated mesh and on the model files, separated by commas, that the system property
 * {@code jmh.models} names. Takes JMH's arguments.
 */
public final class Benchmarks {
    private Benchmarks() {}

    public static void main(String[] args) throws CommandLineOptionException, RunnerException {
        new Runner(new OptionsBuilder()
                        .parent(new CommandLineOptions(args))
                        .param("model", models().toArray(new String[0]))
                        .build())
                .run();
    }

    /** The generated mesh and the files named. */
    public static List<String> models() {
        List<String> models = new ArrayList<>(List.of(BenchmarkMesh.GENERATED));
        Arrays.stream(System.getProperty("jmh.models", "").split(","))
                .map(String::strip)
                .filter(file -> !file.isEmpty())
                .forEach(models::add);
        return models;
    }
}
