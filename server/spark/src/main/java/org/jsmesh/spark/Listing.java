package org.jsmesh.spark;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.jsmesh.files.Explanation;
import org.jsmesh.mesh.io.ModelFormat;
import org.jsmesh.objects.ObjectKeys;
import org.jsmesh.objects.ObjectStore;
import org.jsmesh.objects.ObjectStores;
import org.jsmesh.objects.StoredObject;

/**
 * Goes through the inputs of a run. From a folder or a bucket it takes every file with the extension of a model format,
 * at any depth; a file that is named itself is taken whatever its name.
 */
final class Listing {
    private final List<byte[]> packed = new ArrayList<>();
    private final List<ListedModel> files = new ArrayList<>();
    private long count;

    /** {@return whether there is nothing to encode in a file} */
    static boolean isArchive(String key) {
        return key.toLowerCase(Locale.ROOT).endsWith(".jsm");
    }

    /** {@return what was found, see {@link Packed}} */
    List<byte[]> packed() {
        flush();
        return packed;
    }

    /** {@return how many files were found} */
    long count() {
        return count;
    }

    /**
     * Lists an input.
     *
     * @param address of a folder, a bucket with or without a prefix, or a file
     * @throws CatalogueException when it cannot be listed or has no model
     */
    void input(String address) throws CatalogueException {
        try {
            String whole = Addresses.whole(address);
            if (isFile(whole)) {
                file(whole, null);
                return;
            }
            String root = Addresses.folder(address);
            ObjectStore store = Worker.store(root);
            long before = count;
            store.list("", "", new ObjectStore.Visitor() {
                @Override
                public boolean visit(StoredObject object) {
                    if (isModel(object.key()))
                        add(new ListedModel(root, object.key(), object.key(), 0, "", Instant.EPOCH).at(object));
                    return true;
                }

                @Override
                public void unnameable(String key, IOException reason) {
                    // Looking for it will fail, for a row of the report.
                    if (isModel(key)) add(new ListedModel(root, key, placeOf(key), -1, "", Instant.EPOCH));
                }
            });
            if (count == before && !ObjectStores.isRemote(root) && !Files.isDirectory(Path.of(root)))
                throw new NoSuchFileException(root);
            if (count == before)
                throw new CatalogueException(address + ": holds no model file (ply, obj, stl, off, m, glb, gltf, 3mf)."
                        + " Choose another folder or prefix");
        } catch (IOException | IllegalArgumentException e) {
            throw failed(address, e);
        }
    }

    private static boolean isModel(String key) {
        String name = key.substring(key.lastIndexOf('/') + 1);
        return ModelFormat.ofName(name) != null && !name.startsWith(".");
    }

    /** A place for what has a name that no file can have. */
    private static String placeOf(String key) {
        StringBuilder place = new StringBuilder();
        for (String part : key.split("/", -1)) {
            String name = part.replaceAll("[\\\\\\p{Cntrl}]", "-");
            boolean isNone = name.isEmpty() || name.equals(".") || name.equals("..");
            place.append(place.length() == 0 ? "" : "/").append(isNone ? "-" : name);
        }
        return place.toString();
    }

    private static boolean isFile(String address) throws IOException {
        if (!ObjectStores.isRemote(address)) return Files.isRegularFile(Path.of(address));
        String key = key(address);
        if (ModelFormat.ofName(key) == null && !isArchive(key)) return false;
        return Worker.store(root(address)).find(key).isPresent();
    }

    /**
     * Reads addresses from a file: one a line. Behind a tab there may be the place of the model in the catalogue, which
     * its id is made of, as {@code chairs/oak.obj}; without it that is the name of the file.
     *
     * @param list address of the file
     */
    void list(String list) throws CatalogueException {
        int number = 0;
        long before = count;
        try (BufferedReader lines = new BufferedReader(new InputStreamReader(open(list), StandardCharsets.UTF_8))) {
            for (String line; (line = lines.readLine()) != null; ) {
                number++;
                if (line.isBlank() || line.startsWith("#")) continue;
                int tab = line.indexOf('\t');
                String address = (tab < 0 ? line : line.substring(0, tab)).strip();
                file(address, tab < 0 ? null : line.substring(tab + 1).strip());
            }
        } catch (IOException | IllegalArgumentException e) {
            throw failed(number == 0 ? list : list + ", line " + number, e);
        }
        if (count == before)
            throw new CatalogueException(
                    list + ": has no address of a model. Write one a line, such as" + " s3://bucket/a.glb");
    }

    private static InputStream open(String list) throws IOException {
        String whole = Addresses.whole(list);
        if (!ObjectStores.isRemote(whole)) return Files.newInputStream(Path.of(whole));
        return Worker.store(root(whole)).open(key(whole));
    }

    /** Nothing is asked of the store: what is not there is a row of the report. */
    private void file(String address, String place) throws IOException {
        String whole = Addresses.whole(address);
        String key = key(whole);
        if (key.isEmpty() || key.endsWith("/"))
            throw new IllegalArgumentException(
                    address + " is no address of a file. Give one such as s3://bucket/a.glb");
        String name = key.substring(key.lastIndexOf('/') + 1);
        if (place != null && !place.isEmpty() && !ObjectKeys.isKey(place))
            throw new IllegalArgumentException(
                    "'" + place + "' is no place in a catalogue. Give one such as chairs/oak.obj, or none");
        Worker.store(root(whole));
        add(new ListedModel(root(whole), key, place == null || place.isEmpty() ? name : place, -1, "", Instant.EPOCH));
    }

    /** The whole bucket, or all files of a machine: few are open, wherever the files of a list lie. */
    private static String root(String address) {
        int begin = address.indexOf("://");
        if (begin < 0) return "/";
        int slash = address.indexOf('/', begin + 3);
        return slash < 0 ? address : address.substring(0, slash);
    }

    private static String key(String address) {
        String root = root(address);
        return address.length() <= root.length() ? "" : address.substring(root.equals("/") ? 1 : root.length() + 1);
    }

    private void add(ListedModel file) {
        files.add(file);
        count++;
        if (files.size() == Packed.MOST) flush();
    }

    private void flush() {
        if (!files.isEmpty()) packed.add(Packed.listed(files));
        files.clear();
    }

    static CatalogueException failed(String about, Exception e) {
        return new CatalogueException(Explanation.of(about, e).toString(), e);
    }

    /** {@return what is known of a listed file now; null when it is gone} */
    static StoredObject find(ListedModel file) throws IOException {
        return Worker.store(file.store()).find(file.key()).orElse(null);
    }
}
