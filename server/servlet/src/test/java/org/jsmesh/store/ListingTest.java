package org.jsmesh.store;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.SortedMap;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;

class ListingTest {
    private final Listing listing = new Listing(e -> new ModelStatus(e, ModelStatus.State.NEW, null, null, 0, null));
    private final SortedMap<String, ModelEntry> expected = new TreeMap<>();

    @Test
    void shouldListEveryModelOnceInOrder() {
        Random random = new Random(1);
        check();
        for (int round = 0; round < 40; round++) {
            boolean grows = round < 20;
            for (int i = 0; i < 400; i++) {
                String id = "m" + random.nextInt(6000);
                if (random.nextInt(8) < (grows ? 6 : 2)) put(id);
                else remove(id);
            }
            check();
        }
        for (String id : List.copyOf(expected.keySet())) remove(id);
        check();
    }

    @Test
    void shouldFillPagesWithModelsThatComeInOrder() {
        for (int i = 0; i < 3500; i++) put(String.format("m%05d", i));
        assertThat(pages()).extracting(p -> p.models().size()).containsExactly(1000, 1000, 1000, 500);
    }

    @Test
    void shouldLeaveOtherPagesAloneWhenOneChanges() {
        for (int i = 0; i < 5000; i++) put(String.format("m%05d", i));
        Map<String, Long> before = versions();
        put("m02500b");
        listing.touched("m04500");
        Map<String, Long> after = versions();
        assertThat(after.get("")).isEqualTo(before.get(""));
        assertThat(after.get("m00999")).isEqualTo(before.get("m00999"));
        assertThat(after.get("m01999")).isNotEqualTo(before.get("m01999"));
        assertThat(after.get("m02999")).isEqualTo(before.get("m02999"));
        assertThat(after.get("m03999")).isNotEqualTo(before.get("m03999"));
    }

    @Test
    void shouldBeginBehindAnyId() {
        for (int i = 0; i < 2000; i += 2) put(String.format("m%05d", i));
        ModelPage page = listing.page("m01001");
        assertThat(page.models().get(0).entry().id()).isEqualTo("m01002");
        assertThat(page.isWhole()).isFalse();
        assertThat(listing.page("z").models()).isEmpty();
        assertThat(listing.page("z").next()).isNull();
        assertThat(listing.page("a").models()).hasSize(1000);
    }

    private void put(String id) {
        ModelEntry entry = new ModelEntry(id, Path.of(""), id + ".obj", "obj", 1, 1);
        expected.put(id, entry);
        listing.changed(id, entry);
    }

    private void remove(String id) {
        expected.remove(id);
        listing.changed(id, null);
    }

    private void check() {
        List<ModelPage> pages = pages();
        List<ModelEntry> listed = new ArrayList<>();
        for (ModelPage page : pages) page.models().forEach(m -> listed.add(m.entry()));
        assertThat(listed).containsExactlyElementsOf(expected.values());
        assertThat(listing.all()).isEqualTo(listed);
        assertThat(listing.size()).isEqualTo(expected.size());
        for (int i = 0; i < pages.size(); i++) {
            int models = pages.get(i).models().size();
            assertThat(models).isLessThanOrEqualTo(1000);
            if (i > 0) assertThat(models + pages.get(i - 1).models().size()).isGreaterThan(1000);
        }
    }

    private Map<String, Long> versions() {
        Map<String, Long> versions = new HashMap<>();
        for (ModelPage page : pages()) versions.put(page.after() == null ? "" : page.after(), page.version());
        return versions;
    }

    private List<ModelPage> pages() {
        List<ModelPage> pages = new ArrayList<>();
        pages.add(listing.page(null));
        while (pages.get(pages.size() - 1).next() != null)
            pages.add(listing.page(pages.get(pages.size() - 1).next()));
        assertThat(pages).allSatisfy(page -> {
            assertThat(page.isWhole()).isTrue();
            assertThat(page.total()).isEqualTo(expected.size());
        });
        return pages;
    }
}
