package org.jsmesh.desktop.files;

import java.io.IOException;
import java.io.InputStream;
import java.net.URI;
import java.net.URISyntaxException;
import java.net.URLDecoder;
import java.net.URLEncoder;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemNotFoundException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jsmesh.archive.PlainText;
import org.jsmesh.archive.coding.ArchiveLayout;
import org.jsmesh.desktop.launch.ModelLink;

/**
 * What a user names to be opened, in whatever way: the address of an archive or a manifest, the address of the page
 * that shows a model, a {@link ModelLink} to one of these, an archive file, or a model file.
 *
 * @param kind how it is opened
 * @param location an address without its fragment, or a path
 */
public record ModelAddress(Kind kind, String location) {
    /** How a location is opened. */
    public enum Kind {
        /** Streamed from a server. */
        REMOTE,
        /** An archive file, read as it is. */
        ARCHIVE,
        /** A file of another format, which is encoded first. */
        MODEL
    }

    private static final String LINK = "jsm:";
    private static final Pattern SCHEME = Pattern.compile("[A-Za-z][A-Za-z0-9+.-]+:.*", Pattern.DOTALL);
    /** Names that are devices on Windows, with any extension. */
    private static final Pattern RESERVED =
            Pattern.compile("(?:con|prn|aux|nul|com[0-9]|lpt[0-9])(?:\\..*)?", Pattern.CASE_INSENSITIVE);

    private static final Pattern PAGE = Pattern.compile("(.*/)m/([^/]+)(?:/(?:index\\.html)?)?");

    /**
     * Understands a location.
     *
     * @param text as a user types, pastes or drops it
     * @return how to open it; whether it is there shows when it is opened
     * @throws IllegalArgumentException when it is neither; the message says what and what to do
     */
    public static ModelAddress of(String text) {
        String location = text.strip();
        if (location.length() > 1 && location.startsWith("\"") && location.endsWith("\""))
            location = location.substring(1, location.length() - 1).strip();
        if (location.isEmpty())
            throw new IllegalArgumentException("no address: name an archive, a manifest, a page of a model or a file");
        if (!isAddress(location)) return ofFile(path(location));
        if (location.regionMatches(true, 0, LINK, 0, LINK.length())) location = ModelLink.location(location);
        URI address = address(location);
        if ("file".equalsIgnoreCase(address.getScheme())) return ofFile(path(address));
        if (!isOfWeb(address)) throw new IllegalArgumentException(location + " is no http, https or file address");
        return new ModelAddress(Kind.REMOTE, ofPage(address));
    }

    /**
     * Tells addresses from paths.
     *
     * @param location either
     * @return true for an address, of whatever scheme; the letter of a drive is none
     */
    public static boolean isAddress(String location) {
        return SCHEME.matcher(location).matches();
    }

    private static boolean isOfWeb(URI address) {
        String scheme = String.valueOf(address.getScheme()).toLowerCase(Locale.ROOT);
        return scheme.equals("http") || scheme.equals("https");
    }

    /**
     * A file of this machine.
     *
     * @param file an archive or a model
     * @return how to open it
     */
    public static ModelAddress ofFile(Path file) {
        String name = file.toString().toLowerCase(Locale.ROOT);
        boolean archive = name.endsWith(".jsm") || beginsAsArchive(file);
        return new ModelAddress(archive ? Kind.ARCHIVE : Kind.MODEL, file.toString());
    }

    private static boolean beginsAsArchive(Path file) {
        // A pipe would wait for its writer.
        if (!Files.isRegularFile(file)) return false;
        try (InputStream in = Files.newInputStream(file)) {
            return Arrays.equals(in.readNBytes(ArchiveLayout.MAGIC.length), ArchiveLayout.MAGIC);
        } catch (IOException e) {
            return false; // opening it will say why
        }
    }

    /** The manifest of the model that a page of ours shows; other addresses as they are, without fragment. */
    private static String ofPage(URI address) {
        String whole = address.toString().replaceAll("#.*", "");
        String query = address.getRawQuery() == null ? "" : address.getRawQuery();
        String path = address.getRawPath() == null ? "" : address.getRawPath();
        if (path.endsWith(".jsm") || path.endsWith(".json")) return whole;
        String archive = parameter(query, "archive");
        if (archive != null) return ofParameter(address, archive);
        String id = parameter(query, "m");
        String folder = path.substring(0, path.lastIndexOf('/') + 1);
        if (id != null) {
            Matcher model = PAGE.matcher(path);
            String models = (model.matches() ? model.group(1) : folder.isEmpty() ? "/" : folder) + "m/";
            String encoded = URLEncoder.encode(id, StandardCharsets.UTF_8).replace("+", "%20");
            return server(address) + models + encoded + "/manifest.json" + signature(query);
        }
        Matcher page = PAGE.matcher(path);
        if (page.matches())
            return server(address) + page.group(1) + "m/" + page.group(2) + "/manifest.json" + signature(query);
        if (parameter(query, "file") != null)
            throw new IllegalArgumentException(whole + " shows a file of this device; open the file itself");
        return whole;
    }

    /** Anybody may write the address of a page, so what it names is on the web, too, and no file of this machine. */
    private static String ofParameter(URI page, String archive) {
        URI found = address(page.resolve(archive.replace(" ", "%20")).toString());
        if (!isOfWeb(found))
            throw new IllegalArgumentException(page + " names no archive of http or https: " + archive);
        return found.toString();
    }

    private static String server(URI address) {
        return address.getScheme() + "://" + address.getRawAuthority();
    }

    /** What opens a model whose addresses must be signed, and nothing else of a page's address. */
    private static String signature(String query) {
        String expires = rawParameter(query, "expires");
        String signature = rawParameter(query, "signature");
        if (signature == null) return "";
        return "?expires=" + (expires == null ? "" : expires) + "&signature=" + signature;
    }

    private static String parameter(String query, String name) {
        String raw = rawParameter(query, name);
        return raw == null ? null : decoded(raw);
    }

    private static String decoded(String raw) {
        try {
            return URLDecoder.decode(raw, StandardCharsets.UTF_8);
        } catch (IllegalArgumentException e) {
            return raw;
        }
    }

    private static String rawParameter(String query, String name) {
        for (String pair : query.split("&")) {
            if (pair.startsWith(name + "=")) return pair.substring(name.length() + 1);
        }
        return null;
    }

    /**
     * An address as it goes over the wire.
     *
     * @param location as people write it
     * @return all of it in ASCII
     * @throws IllegalArgumentException when it is none
     */
    public static URI address(String location) {
        try {
            // Letters beyond ASCII go percent-encoded over the wire.
            return new URI(new URI(location).toASCIIString());
        } catch (URISyntaxException e) {
            throw new IllegalArgumentException(location + " is no address: " + e.getReason(), e);
        }
    }

    private static Path path(URI location) {
        try {
            return Path.of(location);
        } catch (IllegalArgumentException | FileSystemNotFoundException e) {
            throw new IllegalArgumentException(
                    location + " is no address of a file; write it as file:///folder/model.jsm", e);
        }
    }

    /**
     * A path.
     *
     * @param location as people write it
     * @return the path; nothing needs to be there
     * @throws IllegalArgumentException when it is none
     */
    public static Path path(String location) {
        try {
            return Path.of(location);
        } catch (InvalidPathException e) {
            throw new IllegalArgumentException(location + " is no path: " + e.getReason(), e);
        }
    }

    /** {@return the location as it can be opened again, wherever the program is started} */
    public String lasting() {
        return kind == Kind.REMOTE
                ? location
                : Path.of(location).toAbsolutePath().normalize().toString();
    }

    /** {@return the model's name: the last part of a path that is neither a manifest's file name nor a hash} */
    public String title() {
        String path = kind == Kind.REMOTE ? location.replaceAll("[?#].*$", "") : location;
        path = path.replaceAll("/(manifest\\.json|[0-9a-f]{64}\\.jsm)$", "");
        String name = path.replaceAll("[/\\\\]+$", "").replaceAll(".*[/\\\\]", "");
        if (name.isEmpty()) return PlainText.of(location);
        return PlainText.of(kind == Kind.REMOTE ? decoded(name.replace("+", "%2B")) : name);
    }

    /** {@return the title as the name of a file without extension, which every system takes} */
    public String fileName() {
        String name = title().replaceAll("\\.[A-Za-z0-9]{1,4}$", "")
                .replaceAll("[\\\\/:*?\"<>|]", "_")
                .replaceAll("[. ]+$", "");
        if (name.isEmpty()) return "model";
        return RESERVED.matcher(name).matches() ? "_" + name : name;
    }
}
