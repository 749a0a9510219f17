package org.jsmesh.site;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.HexFormat;
import java.util.List;
import java.util.Set;
import org.jsmesh.objects.ObjectContent;
import org.jsmesh.objects.ObjectStore;
import org.jsmesh.objects.Upload;
import org.jsmesh.store.ModelPage;

/** One try to change a catalogue: goes through the changes and the pages they are on, in order. */
final class CataloguePages {
    static final int MOST = ModelPage.MOST;
    /** Of many models, so that the root stays small. */
    static final int MOST_IN_ROOT = 100;

    private static final int NAME_BYTES = 8;

    private final ObjectStore store;
    private final CatalogueRoot before;
    private final long generation;
    private final Superseded superseded;
    private final Set<String> written;
    private final int most;
    private final int mostInRoot;

    private final List<CatalogueRoot.Page> out = new ArrayList<>();
    private final List<CatalogueRow> buffer = new ArrayList<>(); // rows of the page that is being made
    private List<CatalogueRow> root; // null until it is known which rows the root has
    private long added;
    private long changed;
    private long removed;

    /**
     * Begins.
     *
     * @param generation that new pages are named after
     * @param written files of pages that were written by earlier tries, and from now on by this one
     */
    CataloguePages(
            ObjectStore store,
            CatalogueRoot before,
            long generation,
            Superseded superseded,
            Set<String> written,
            int most,
            int mostInRoot) {
        this.store = store;
        this.before = before;
        this.generation = generation;
        this.superseded = superseded;
        this.written = written;
        this.most = most;
        this.mostInRoot = mostInRoot;
    }

    void apply(Iterable<CatalogueRow> changes) throws IOException {
        RowChanges rows = new RowChanges(changes.iterator(), this::count);
        List<CatalogueRoot.Page> pages = before.pages();
        String end = pages.isEmpty() ? null : pages.get(0).first();
        rows.merge(before.rows(), end, this::add);
        if (!pages.isEmpty()) {
            endRoot();
            split();
        }
        for (int i = 0; i < pages.size(); i++) {
            CatalogueRoot.Page page = pages.get(i);
            end = i + 1 < pages.size() ? pages.get(i + 1).first() : null;
            if (buffer.isEmpty() && lastCount() + page.count() <= most) joinLast();
            boolean isJoined = !buffer.isEmpty() && buffer.size() + page.count() <= most;
            boolean isEmptyRoot = isRootOpen();
            if (!isJoined && !isEmptyRoot && !rows.isBefore(end)) {
                flush();
                out.add(page);
                continue;
            }
            List<CatalogueRow> there = read(page);
            long changesBefore = added + changed + removed;
            if (!buffer.isEmpty() && !isJoined && buffer.size() >= most / 2) flush();
            int start = buffer.size();
            int pagesBefore = out.size();
            rows.merge(there, end, this::add);
            boolean isSame = changesBefore == added + changed + removed && start == 0 && out.size() == pagesBefore;
            if (isSame && !isEmptyRoot) {
                // All that was to be changed was so before.
                buffer.clear();
                out.add(page);
            } else if (isEmptyRoot) {
                endRoot();
            }
            // What is left may be joined with the page that follows.
            if (end != null) split();
        }
        finish();
    }

    private void count(CatalogueRow old, CatalogueRow row) throws IOException {
        if (old == null) added++;
        else if (row.isRemoval()) removed++;
        else changed++;
        if (old != null) superseded.replaced(old, row);
    }

    private void add(CatalogueRow row) throws IOException {
        buffer.add(row);
        if (isRootOpen() && buffer.size() > most) endRoot();
        if (buffer.size() == 2 * most) write(buffer.subList(0, most));
    }

    private boolean isRootOpen() {
        return root == null || root.isEmpty() && out.isEmpty();
    }

    /** There are pages: the root takes the first few rows. */
    private void endRoot() {
        if (root != null && !root.isEmpty()) return;
        int count = buffer.size() <= mostInRoot ? buffer.size() : Math.max(1, mostInRoot / 2);
        List<CatalogueRow> rows = buffer.subList(0, count);
        root = new ArrayList<>(rows);
        rows.clear();
    }

    /** Writes half of what is more than a page. */
    private void split() throws IOException {
        if (buffer.size() <= most) return;
        if (lastCount() + buffer.size() / 2 <= most) buffer.addAll(0, read(out.remove(out.size() - 1)));
        write(buffer.subList(0, buffer.size() / 2));
    }

    /** Writes what is left of a page that others follow. */
    private void flush() throws IOException {
        if (buffer.isEmpty()) return;
        joinLast();
        write(buffer);
    }

    /** Takes back the page before when this one has become so small that both are one. */
    private void joinLast() throws IOException {
        if (lastCount() + buffer.size() > most) return;
        buffer.addAll(0, read(out.remove(out.size() - 1)));
    }

    private int lastCount() {
        return out.isEmpty() ? most + 1 : out.get(out.size() - 1).count();
    }

    private void finish() throws IOException {
        // Models that come in order fill their pages.
        if (buffer.size() > most) write(buffer.subList(0, most));
        if (!buffer.isEmpty()) joinLast();
        long total = (root == null ? 0 : root.size())
                + buffer.size()
                + out.stream().mapToLong(CatalogueRoot.Page::count).sum();
        if (total <= most) {
            // Few enough for the root alone.
            List<CatalogueRow> all = root == null ? new ArrayList<>() : root;
            for (CatalogueRoot.Page page : out) all.addAll(read(page));
            all.addAll(buffer);
            out.clear();
            root = all;
        } else if (!buffer.isEmpty()) {
            write(buffer);
        }
    }

    private List<CatalogueRow> read(CatalogueRoot.Page page) throws IOException {
        try (InputStream in = store.open(page.key())) {
            return CatalogueJson.rows(in.readAllBytes(), store.address() + "/" + page.key());
        }
    }

    private void write(List<CatalogueRow> rows) throws IOException {
        byte[] content = CatalogueRoot.page(rows);
        String file = "page-" + name(content) + ".json";
        if (written.add(file))
            store.put(Upload.of("m/" + file, ObjectContent.of(content))
                    .withHeaders(SiteHeaders.JSON, SiteHeaders.FOR_EVER));
        out.add(new CatalogueRoot.Page(rows.get(0).id(), rows.size(), file));
        rows.clear();
    }

    /** Another one in each generation: what was replaced and is to be removed is never named again. */
    private String name(byte[] content) {
        try {
            MessageDigest digest = MessageDigest.getInstance("SHA-256");
            digest.update((generation + "\n").getBytes(StandardCharsets.UTF_8));
            return HexFormat.of().formatHex(digest.digest(content), 0, NAME_BYTES);
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException(e);
        }
    }

    /** Files of the pages that the catalogue has now. */
    Set<String> files() {
        Set<String> files = new HashSet<>();
        for (CatalogueRoot.Page page : out) files.add(page.file());
        return files;
    }

    /**
     * The new root; null when nothing has changed.
     *
     * @param old that was superseded before and has to stay for now
     */
    CatalogueRoot root(List<CatalogueRoot.Old> old) throws IOException {
        Set<String> now = files();
        for (CatalogueRoot.Page page : before.pages()) if (!now.contains(page.file())) superseded.page(page.file());
        for (String file : written) if (!now.contains(file)) superseded.page(file);
        boolean isSame = root.equals(before.rows()) && out.equals(before.pages());
        List<CatalogueRoot.Old> all = new ArrayList<>(old);
        all.addAll(superseded.lists());
        if (isSame && all.equals(before.superseded()) && before.object() != null) return null;
        boolean isPaged = !out.isEmpty() || before.generation() > 0;
        long next = isPaged ? Math.max(before.generation() + 1, generation) : 0;
        return new CatalogueRoot(before.object(), next, root, List.copyOf(out), all);
    }

    CatalogueWriter.Result result() {
        long total =
                root.size() + out.stream().mapToLong(CatalogueRoot.Page::count).sum();
        return new CatalogueWriter.Result(total, added, changed, removed);
    }
}
