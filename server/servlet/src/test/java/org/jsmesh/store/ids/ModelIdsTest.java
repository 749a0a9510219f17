package org.jsmesh.store.ids;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.text.Normalizer;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class ModelIdsTest {
    private static final List<String> LATIN = List.of("cube", "Big Chair", "big_chair", "Äpfel 2", "v1.2", "a", "A");
    private static final List<String> BEYOND =
            List.of("测试模型", "模型", "椅子 2", "椅子_2", "Модель", "модель", "ガ", "🚀", "!!");
    private static final List<String> FOLDERS = List.of("", "", "kip/", "Kip/", "a/b/", "模/");
    private static final List<String> FORMATS = List.of(".obj", ".stl", ".glb", ".PLY", ".jsm", "");

    @ParameterizedTest
    @CsvSource({
        "chair.obj, chair",
        "Stanford Bunny.obj, stanford-bunny",
        "Äpfel_2.PLY, apfel-2",
        "Straße.off, strasse",
        "Łódź.stl, lodz",
        "-a--b-.stl, a-b",
        "kip/kip.obj, kip--kip",
        "Deep Er/x/Horse.ply, deep-er--x--horse",
        "noextension, noextension",
        "uploads/chair.jsm, chair",
    })
    void shouldSpellLatinNames(String path, String id) {
        assertThat(ids(path)).containsValue(id);
    }

    @ParameterizedTest
    @CsvSource({
        "测试模型.off, 测试模型-off-",
        "椅子 2.obj, 椅子-2-obj-",
        "Модель.glb, модель-glb-",
        "ｶﾞ.ply, ガ-ply-",
        "कुर्सी.stl, कुर्सी-stl-",
        "模/in.off, 模--in-off-",
        "🚀.glb, model-glb-",
        "!!.stl, model-stl-",
    })
    void shouldKeepTheLettersOfOtherScriptsAndAddAHash(String path, String beginning) {
        assertThat(ids(path).get(path)).matches(beginning + "[a-z2-9]{6}");
    }

    @Test
    void shouldStayAsTheyAreInLaterVersions() {
        // Addresses are kept by people and pages. None of these may ever change.
        assertThat(ids("测试模型.off")).containsValue("测试模型-off-8kwx2n");
        assertThat(ids("cube.obj", "cube.stl")).containsValue("cube").containsValue("cube-stl-ynmmqg");
    }

    @Test
    void shouldGiveTheShortIdToTheBestOfOneName() {
        assertThat(ids("a b.obj", "a_b.obj", "a-b.stl").get("a-b.stl")).isEqualTo("a-b");
        assertThat(ids("a b.obj", "a_b.obj").get("a b.obj")).isEqualTo("a-b");
        assertThat(ids("cube.stl", "cube.glb", "cube.obj").get("cube.glb")).isEqualTo("cube");
        assertThat(ids("cube.obj", "sub/cube.glb", "uploads/cube.jsm").get("cube.obj"))
                .isEqualTo("cube");
    }

    @Test
    void shouldTakeBothFormsOfAccentsForOneName() {
        String name = "が.obj";
        String decomposed = Normalizer.normalize(name, Normalizer.Form.NFD);
        assertThat(decomposed).isNotEqualTo(name);
        assertThat(ids(decomposed).get(decomposed)).isEqualTo(ids(name).get(name));
        assertThat(Set.copyOf(ids(name, decomposed).values())).hasSize(2);
    }

    @ParameterizedTest
    @ValueSource(strings = {"a", "椅"})
    void shouldCutIdsThatNoFolderCouldBeNamedBy(String letter) {
        String first = (letter.repeat(70) + "/").repeat(4) + "x.obj";
        String second = (letter.repeat(70) + "/").repeat(4) + "y.obj";
        Map<String, String> ids = ids(first, second);
        assertThat(Set.copyOf(ids.values())).hasSize(2);
        assertThat(ids.values())
                .allSatisfy(id ->
                        assertThat(id.getBytes(StandardCharsets.UTF_8).length).isBetween(238, 240));
    }

    @Test
    void shouldEncodeIdsForAddresses() {
        assertThat(ModelIds.segment("kip--kip-2")).isEqualTo("kip--kip-2");
        assertThat(ModelIds.segment("模-a")).isEqualTo("%E6%A8%A1-a");
    }

    @Test
    void shouldBeUniqueAndIndependentOfTheOrder() {
        Random random = new Random(5);
        for (int run = 0; run < 300; run++) {
            List<String> paths = new ArrayList<>(random(random, 20));
            Map<String, String> ids = ids(paths);
            assertThat(Set.copyOf(ids.values())).hasSameSizeAs(paths);
            Collections.shuffle(paths, random);
            assertThat(ids(paths)).isEqualTo(ids);
        }
    }

    @Test
    void shouldMoveNoModelOfAnotherNameWhenFilesComeAndGo() {
        Random random = new Random(6);
        for (int run = 0; run < 300; run++) {
            Set<String> before = random(random, 10);
            Set<String> added = random(random, 5);
            added.removeAll(before);
            Set<String> after = new LinkedHashSet<>(added);
            after.addAll(before);
            Map<String, String> ids = ids(before);
            Map<String, String> idsAfter = ids(after);
            Set<String> addedNames = new LinkedHashSet<>();
            for (String path : added)
                addedNames.add(String.valueOf(ModelPath.of(path).shortId()));
            for (String path : before) {
                String shortId = ModelPath.of(path).shortId();
                if (shortId == null || !addedNames.contains(shortId))
                    assertThat(idsAfter.get(path)).as(path).isEqualTo(ids.get(path));
            }
        }
    }

    @Test
    void shouldLeadToEveryFileByItsLongIdWhateverComesAndGoes() {
        Random random = new Random(7);
        for (int run = 0; run < 300; run++) {
            List<String> paths = List.copyOf(random(random, 20));
            ModelIds ids = ModelIds.of(paths);
            for (int i = 0; i < paths.size(); i++) {
                String alone = ModelPath.of(paths.get(i)).longId(0);
                assertThat(
                                ids.id(i).equals(alone)
                                        ? Integer.valueOf(i)
                                        : ids.others().get(alone))
                        .isEqualTo(i);
            }
        }
    }

    private static Set<String> random(Random random, int most) {
        Set<String> paths = new LinkedHashSet<>();
        for (int i = random.nextInt(most) + 1; i > 0; i--) {
            List<String> names = random.nextBoolean() ? LATIN : BEYOND;
            String number = random.nextInt(3) == 0 ? Integer.toString(random.nextInt(4)) : "";
            paths.add(any(random, FOLDERS) + any(random, names) + number + any(random, FORMATS));
        }
        return paths;
    }

    private static String any(Random random, List<String> texts) {
        return texts.get(random.nextInt(texts.size()));
    }

    private static Map<String, String> ids(String... paths) {
        return ids(List.of(paths));
    }

    private static Map<String, String> ids(Iterable<String> paths) {
        List<String> list = new ArrayList<>();
        paths.forEach(list::add);
        ModelIds ids = ModelIds.of(list);
        Map<String, String> byPath = new HashMap<>();
        IntStream.range(0, list.size()).forEach(i -> byPath.put(list.get(i), ids.id(i)));
        return byPath;
    }
}
