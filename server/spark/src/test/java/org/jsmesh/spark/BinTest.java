package org.jsmesh.spark;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

class BinTest {
    private static PlannedModel model(String id, long faces) {
        ListedModel file = new ListedModel("s3://b", id + ".ply", id + ".ply", faces, "t", Instant.ofEpochSecond(3, 4));
        return new PlannedModel(id, file, faces, 300 * faces);
    }

    @Test
    void shouldCutModelsIntoBinsOfAboutTheSameTime() {
        Random random = new Random(5);
        List<PlannedModel> models = new ArrayList<>();
        for (int i = 0; i < 5000; i++) models.add(model("m" + i, (long) Math.exp(random.nextDouble() * 16)));
        models.sort((a, b) -> Double.compare(b.seconds(), a.seconds()));
        List<PlannedModel> found = new ArrayList<>();
        int bins = 0;
        for (Iterator<byte[]> i = Bin.cut(models.iterator(), 5); i.hasNext(); bins++) {
            List<PlannedModel> bin = new Bin(0, i.next()).models();
            double seconds = bin.stream().mapToDouble(PlannedModel::seconds).sum();
            assertThat(bin.size() == 1 || seconds <= 5).isTrue();
            found.addAll(bin);
        }
        assertThat(found).isEqualTo(models);
        double least =
                models.stream().mapToDouble(m -> Math.max(0, m.seconds())).sum() / 5;
        assertThat(bins).isBetween(1, (int) (2 * least) + 1);
    }

    @Test
    void shouldHoldAMillionFilesInLittle() {
        List<ListedModel> files = new ArrayList<>();
        for (int i = 0; i < Packed.MOST; i++) {
            String key = String.format("objaverse/glbs/000-%03d/%032x.glb", i / 100, i * 7919L);
            String tag = String.format("\"%032x\"", new Random(i).nextLong());
            files.add(new ListedModel("s3://models", key, key, 12_345 + i, tag, Instant.ofEpochSecond(i)));
        }
        byte[] packed = Packed.listed(files);
        assertThat(Packed.listed(packed)).isEqualTo(files);
        assertThat(packed.length / Packed.MOST).isLessThan(80);
    }
}
