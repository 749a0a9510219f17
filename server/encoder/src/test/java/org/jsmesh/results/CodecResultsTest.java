package org.jsmesh.results;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.Stream;
import org.jsmesh.files.ModelFiles;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.io.ModelFormat;
import org.jsmesh.test.SampleModels;
import org.jsmesh.test.results.RecordedResults;
import org.jsmesh.test.results.ResultTable;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/**
 * Size, error and work of the codec do not get worse than they are recorded. The system property {@value #FOLDER} names
 * a folder of more models, which are compared too.
 */
@Tag("slow")
class CodecResultsTest {
    static final String FOLDER = "jsm.bench.models";
    private static final String COMMAND =
            "mvn -q -pl server/encoder -am test -Dtest=CodecResultsTest -Dsurefire.failIfNoSpecifiedTests=false";

    /** Archives of smaller models are headers above all. */
    private static final int LEAST_FACES = 1000;

    @Test
    void shouldKeepToTheModelsOfTheProject() throws Exception {
        Map<String, Mesh> models = GeneratedModels.all();
        for (Path file : SampleModels.own()) add(file, models);
        compare(models, new RecordedResults("Models of the project", COMMAND));
    }

    @Test
    void shouldKeepToTheModelsOfOthers() throws Exception {
        String folder = System.getProperty(FOLDER, "");
        Assumptions.assumeFalse(folder.isBlank(), "-D" + FOLDER + "=FOLDER names no models of others");
        Map<String, Mesh> models = new LinkedHashMap<>();
        for (Path file : files(SampleModels.project().resolve(folder))) add(file, models);
        compare(models, new RecordedResults("Models of others", COMMAND + " -D" + FOLDER + "=" + folder));
    }

    private static void compare(Map<String, Mesh> models, RecordedResults results) throws Exception {
        ResultTable recorded = results.read(ModelResults.table());
        ResultTable measured = ModelResults.table();
        DecisionCounter counter = new DecisionCounter();
        Map<String, double[]> figures = new ConcurrentHashMap<>();
        models.entrySet().parallelStream().forEach(model -> {
            String name = model.getKey();
            figures.put(name, new ModelResults(model.getValue()).measure(counter, recorded.row(name)));
        });
        for (String name : models.keySet()) measured.put(name, figures.get(name));
        results.check(measured);
    }

    static void add(Path file, Map<String, Mesh> models) throws IOException {
        Mesh mesh = ModelFiles.read(file).mesh();
        if (mesh.faces() >= LEAST_FACES) models.put(file.getFileName().toString(), mesh);
    }

    static List<Path> files(Path folder) throws IOException {
        List<Path> found = List.of();
        if (Files.isDirectory(folder)) {
            try (Stream<Path> walk = Files.walk(folder)) {
                found = walk.filter(file -> ModelFormat.ofName(file.toString()) != null)
                        .sorted()
                        .toList();
            }
        }
        if (found.isEmpty())
            throw new IllegalArgumentException(
                    "-D" + FOLDER + " names " + folder + ", which has no model file: name another folder");
        return found;
    }
}
