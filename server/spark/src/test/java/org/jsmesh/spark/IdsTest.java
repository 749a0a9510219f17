package org.jsmesh.spark;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.stream.Collectors;
import org.jsmesh.store.ids.ModelIds;
import org.junit.jupiter.api.Test;

class IdsTest {
    private static Map<String, String> ids(List<String> places) {
        Map<String, List<ListedModel>> first = new HashMap<>();
        for (String place : places) {
            ListedModel file = new ListedModel("s", place, place, 1, "", Instant.EPOCH);
            first.computeIfAbsent(Ids.first(file), id -> new ArrayList<>()).add(file);
        }
        Map<String, List<Ids.Given>> second = first.values().stream()
                .flatMap(group -> Ids.assign(group).stream())
                .collect(Collectors.groupingBy(Ids.Given::id));
        return second.values().stream()
                .flatMap(group -> Ids.separate(group).stream())
                .collect(Collectors.toMap(g -> g.file().place(), Ids.Given::id));
    }

    @Test
    void shouldBeThoseOfASite() {
        String[] names = {"Chair", "chair", "CHAIR!", "椅子", "chair-ply-2qz", "a b", "a-b", "Ä b", "", "é"};
        String[] folders = {"", "x/", "X/", "x/y/", "uploads/", "椅/"};
        String[] extensions = {".ply", ".obj", ".PLY", ".stl.gz", ".glb"};
        Random random = new Random(3);
        for (int round = 0; round < 50; round++) {
            Set<String> chosen = new LinkedHashSet<>();
            for (int i = 0; i < 60; i++)
                chosen.add(folders[random.nextInt(folders.length)]
                        + names[random.nextInt(names.length)]
                        + extensions[random.nextInt(extensions.length)]);
            List<String> places = new ArrayList<>(chosen);
            // A file that is named as another's long id.
            ModelIds before = ModelIds.of(places);
            for (int i = 0; i < 5; i++) places.add(before.id(i) + "-obj-abcdef.obj");
            for (int i = 5; i < 10; i++) if (!places.contains(before.id(i) + ".ply")) places.add(before.id(i) + ".ply");
            ModelIds all = ModelIds.of(places);
            Map<String, String> expected = new HashMap<>();
            for (int i = 0; i < places.size(); i++) expected.put(places.get(i), all.id(i));
            Collections.shuffle(places, random);
            assertThat(ids(places)).isEqualTo(expected);
        }
    }
}
