package org.jsmesh.results;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.test.SampleModels;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/**
 * Prints what the bits of archives are for, per vertex, and holds that nearly all bits have a kind. The system property
 * {@value CodecResultsTest#FOLDER} names a folder of more models, to which it adds those of the project.
 */
@Tag("slow")
class BitBudgetTest {
    /** Part of an archive that may be header, index, checksums and ends of streams. */
    private static final double MOST_OVERHEAD = .06;

    /** Part of the bits that may be the header's, and signs of what comes next. */
    private static final double MOST_WITHOUT_KIND = .03;

    @Test
    void shouldKnowWhatBitsAreFor() throws Exception {
        BitBudget budget = new BitBudget();
        Set<String> generated = GeneratedModels.all().keySet();
        System.out.println("| bits per vertex | " + String.join(" | ", BitBudget.names())
                + " | rest | stage | sweeps after it | lattice after it | whole |");
        System.out.println("|---|" + "---:|".repeat(BitBudget.names().length + 5));
        for (Map.Entry<String, Mesh> model : models().entrySet()) {
            ModelResults.Staged staged = new ModelResults(model.getValue()).staged();
            double[][] bits = budget.count(staged.archive(), staged.end());
            print(model.getKey(), staged, bits);
            if (!generated.contains(model.getKey())) continue; // whose headers may be large beside little else
            double known = Arrays.stream(bits[1]).sum();
            assertThat(known / 8 / staged.archive().length)
                    .as("part of the bytes of %s that were read as bits", model.getKey())
                    .isBetween(1 - MOST_OVERHEAD, 1.0);
            double other = bits[1][BitLedger.Kind.OTHER.ordinal()];
            assertThat(other / known).as("part without a kind").isLessThan(MOST_WITHOUT_KIND);
            for (BitLedger.Kind kind : new BitLedger.Kind[] {
                BitLedger.Kind.FLAGS,
                BitLedger.Kind.CUTS,
                BitLedger.Kind.TANGENTIAL,
                BitLedger.Kind.NORMAL,
                BitLedger.Kind.BASE,
                BitLedger.Kind.SWEEPS
            }) assertThat(bits[1][kind.ordinal()]).as(kind.name()).isPositive();
        }
        assertThat(budget.missing())
                .as("methods that the codec has no more; name others in BitBudget")
                .isEmpty();
    }

    private static Map<String, Mesh> models() throws Exception {
        Map<String, Mesh> models = new TreeMap<>(GeneratedModels.all());
        String folder = System.getProperty(CodecResultsTest.FOLDER, "");
        if (folder.isBlank()) return models;
        for (Path file : SampleModels.own()) CodecResultsTest.add(file, models);
        for (Path file : CodecResultsTest.files(SampleModels.project().resolve(folder)))
            CodecResultsTest.add(file, models);
        return models;
    }

    private static void print(String name, ModelResults.Staged staged, double[][] bits) {
        double vertices = staged.vertices();
        StringBuilder line = new StringBuilder("| " + name);
        for (double kind : bits[0]) add(line, kind / vertices);
        add(line, (8.0 * staged.end() - Arrays.stream(bits[0]).sum()) / vertices);
        add(line, 8.0 * staged.end() / vertices);
        for (BitLedger.Kind kind : new BitLedger.Kind[] {BitLedger.Kind.SWEEPS, BitLedger.Kind.LATTICE})
            add(line, (bits[1][kind.ordinal()] - bits[0][kind.ordinal()]) / vertices);
        add(line, 8.0 * staged.archive().length / vertices);
        System.out.println(line + " |");
    }

    private static void add(StringBuilder line, double bits) {
        line.append(String.format(Locale.ROOT, " | %.2f", bits));
    }
}
