package org.jsmesh.store;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.text.Normalizer;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import org.jsmesh.store.ids.ModelIds;
import org.jsmesh.store.ids.ModelPath;
import org.junit.jupiter.api.Test;

class FolderIndexTest {
    private static final Path FOLDER = Path.of("models");
    private static final List<String> FOLDERS =
            List.of("", "", "", "kip/", "Kip/", "a/b/", "\u6a21/", "uploads/", "!/");
    private static final List<String> NAMES = List.of(
            "cube",
            "Cube",
            "Big Chair",
            "big_chair",
            "kip",
            "a",
            "model",
            "!!",
            "\u6905\u5b50",
            "\u304c",
            Normalizer.normalize("\u304c", Normalizer.Form.NFD),
            "x.y");
    private static final List<String> FORMATS =
            List.of(".obj", ".stl", ".glb", ".PLY", ".ply.gz", ".jsm", ".JSM", ".3mf");

    /** What listeners were told, which must be what is there. */
    private final SortedMap<String, ModelEntry> told = new TreeMap<>();

    private final FolderIndex index = new FolderIndex(FOLDER, (id, entry) -> {
        if (entry == null) assertThat(told.remove(id)).as(id).isNotNull();
        else told.put(id, entry);
    });

    @Test
    void shouldHoldAfterAnyChangesWhatAFolderWithTheseFilesHas() {
        for (int run = 0; run < 60; run++) {
            Random random = new Random(run);
            Set<String> places = new LinkedHashSet<>();
            List<String> pool = pool(random);
            for (String place : index.below("")) index.remove(place);
            assertThat(told).isEmpty();
            for (int step = 0; step < 60; step++) {
                change(random, pool, places);
                if (step % 3 == 0) check(places);
            }
        }
    }

    /** Files whose long ids are names of others, so that every rule meets every other. */
    private static List<String> pool(Random random) {
        List<String> pool = new ArrayList<>();
        for (int i = 0; i < 25; i++) pool.add(any(random, FOLDERS) + any(random, NAMES) + any(random, FORMATS));
        for (int i = 0; i < 4; i++) {
            ModelPath path = ModelPath.of(any(random, pool));
            pool.add(path.longId(0) + any(random, FORMATS));
            pool.add(path.longId(1) + any(random, FORMATS));
        }
        return pool;
    }

    private void change(Random random, List<String> pool, Set<String> places) {
        String place = any(random, pool);
        if (random.nextInt(3) == 0) {
            places.remove(place);
            index.remove(place);
        } else {
            places.add(place);
            index.put(place, random.nextInt(3), 5);
        }
    }

    private void check(Set<String> places) {
        Map<String, String> expected = ids(places);
        assertThat(Folders.entries(index)).isEqualTo(told);
        Map<String, String> found = new TreeMap<>();
        told.forEach((id, entry) -> found.put(id, entry.place()));
        assertThat(found).isEqualTo(expected);
        Set<String> asked = new HashSet<>(expected.keySet());
        for (String place : places) asked.addAll(ModelPath.of(place).otherIds());
        Map<String, String> others = others(places);
        for (String id : asked) {
            ModelEntry entry = index.find(id);
            assertThat(entry == null ? null : entry.place())
                    .as(id)
                    .isEqualTo(expected.containsKey(id) ? expected.get(id) : others.get(id));
        }
    }

    private static Map<String, String> ids(Set<String> places) {
        List<String> models = models(places);
        ModelIds ids = ModelIds.of(models);
        Map<String, String> byId = new TreeMap<>();
        for (int i = 0; i < models.size(); i++) byId.put(ids.id(i), models.get(i));
        return byId;
    }

    private static Map<String, String> others(Set<String> places) {
        List<String> models = models(places);
        Map<String, String> byId = new TreeMap<>();
        ModelIds.of(models).others().forEach((id, file) -> byId.put(id, models.get(file)));
        return byId;
    }

    /** Without the sources of archives. */
    private static List<String> models(Set<String> places) {
        Set<String> archived = new HashSet<>();
        for (String place : places) if (isArchive(place)) archived.add(stem(place));
        return places.stream()
                .filter(place -> isArchive(place) || !archived.contains(stem(place)))
                .toList();
    }

    private static boolean isArchive(String place) {
        return place.endsWith(".jsm") || place.endsWith(".JSM");
    }

    private static String stem(String place) {
        return place.replaceFirst("\\.gz$", "").replaceFirst("\\.[^./]*$", "");
    }

    @Test
    void shouldFindByNamesAsTheyAreSpelledInIds() {
        for (String place : List.of("a/Big Chair.obj", "big-chair.stl", "chair.obj", "!!.stl")) index.put(place, 1, 1);
        assertThat(index.named("big-chair"))
                .extracting(ModelEntry::place)
                .containsExactlyInAnyOrder("a/Big Chair.obj", "big-chair.stl");
        assertThat(index.named("model")).extracting(ModelEntry::place).containsExactly("!!.stl");
    }

    private static String any(Random random, List<String> texts) {
        return texts.get(random.nextInt(texts.size()));
    }
}
