package org.jsmesh.objects;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Locale;
import java.util.ServiceLoader;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Finds the store of an address. */
public final class ObjectStores {
    /** One letter is a drive of Windows. */
    private static final Pattern SCHEME = Pattern.compile("([A-Za-z][A-Za-z0-9+.-]+)://.*", Pattern.DOTALL);

    private ObjectStores() {}

    /**
     * Tells whether a text is the address of something other than a folder or a file of this machine.
     *
     * @param address any text
     * @return true for {@code s3://bucket/prefix}, false for a path
     */
    public static boolean isRemote(String address) {
        String scheme = scheme(address);
        return scheme != null && !scheme.equals("file");
    }

    /**
     * Opens a store.
     *
     * @param address the path of a folder, which need not exist, or an address such as {@code s3://bucket/prefix}
     * @return the store, to be closed
     * @throws IllegalArgumentException when nothing that is there opens such an address, or it is none
     * @throws IOException when the store cannot be opened
     */
    public static ObjectStore open(String address) throws IOException {
        return open(address, null);
    }

    /**
     * Opens a store for somebody who waits, such as a visitor of a server: a store that does not answer is given up
     * soon rather than asked again for minutes.
     *
     * @param address the path of a folder, which need not exist, or an address such as {@code s3://bucket/prefix}
     * @param patience how long an answer is waited for, as far as the kind of store can be told; null for as long as
     *     may help
     * @return the store, to be closed
     * @throws IllegalArgumentException when nothing that is there opens such an address, or it is none
     * @throws IOException when the store cannot be opened
     */
    public static ObjectStore open(String address, Duration patience) throws IOException {
        String scheme = scheme(address);
        if (scheme == null) return new FolderObjectStore(Path.of(address));
        if (scheme.equals("file")) return new FolderObjectStore(Path.of(URI.create(address)));
        for (ObjectStoreProvider provider :
                ServiceLoader.load(ObjectStoreProvider.class, ObjectStores.class.getClassLoader())) {
            if (provider.scheme().equals(scheme))
                return patience == null ? provider.open(address) : provider.open(address, patience);
        }
        throw new IllegalArgumentException(address + ": nothing here opens addresses that begin with " + scheme
                + "://. Give a folder or s3://bucket/prefix, and put jsm-s3 on the class path for the latter");
    }

    private static String scheme(String address) {
        Matcher matcher = SCHEME.matcher(address);
        return matcher.matches() ? matcher.group(1).toLowerCase(Locale.ROOT) : null;
    }
}
