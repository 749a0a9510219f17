package org.jsmesh.web.build;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** A copy of the sources with all that they import beside them, in which names are replaced before it is bundled. */
final class Staging {
    private static final List<String> SCRIPT_DECODERS = List.of("decoder.js", "first-decoder.js");
    private static final String NO_DECODER =
            "export function instantiate() { throw new Error('this page was built without a decoder'); }\n";

    private final Path folder;

    Staging(Path folder) {
        this.folder = folder;
    }

    Path folder() {
        return folder;
    }

    void fill(Layout layout) throws IOException {
        Folders.clear(folder);
        Folders.copy(layout.sources(), folder, name -> true);
        Folders.copy(layout.decoder(), folder.resolve("decoder"), name -> name.matches("[^/]+\\.(js|wasm)"));
        for (String name : SCRIPT_DECODERS) {
            Path script = folder.resolve("decoder").resolve(name);
            if (Files.exists(script)) continue;
            Files.createDirectories(script.getParent());
            Files.writeString(script, NO_DECODER);
        }
    }

    /** Puts three.js beside the sources. */
    void addThree() throws IOException {
        ThreeSource.unpack(folder.resolve("node_modules/three"))
                .importDirectly(scripts().keySet());
    }

    /** The files that scripts name as {@code new URL('PATH', import.meta.url)}. */
    Set<Path> named() throws IOException {
        Set<Path> found = new TreeSet<>();
        for (Path script : scripts().keySet()) {
            replaced(script, References.OF_SCRIPTS, target -> {
                found.add(target);
                return null;
            });
        }
        return found;
    }

    /** Writes the name of the file that is served wherever a script names a source. */
    void rename(Path target, String name) throws IOException {
        for (Map.Entry<Path, String> script : scripts().entrySet()) {
            String text = replaced(
                    script.getKey(), References.OF_SCRIPTS, found -> found.equals(target) ? "./" + name : null);
            if (!text.equals(script.getValue())) Files.writeString(script.getKey(), text);
        }
    }

    /** Writes one text wherever a script has another. */
    void replace(String text, String replacement) throws IOException {
        for (Map.Entry<Path, String> script : scripts().entrySet()) {
            String changed = script.getValue().replace(text, replacement);
            if (!changed.equals(script.getValue())) Files.writeString(script.getKey(), changed);
        }
    }

    /** The project's own, with their texts. */
    private Map<Path, String> scripts() throws IOException {
        Map<Path, String> scripts = new TreeMap<>();
        for (Path file : Folders.files(folder)) {
            String name = Folders.relative(folder, file);
            boolean own = name.endsWith(".js") && !name.startsWith("node_modules/") && !name.startsWith("decoder/");
            if (own) scripts.put(file, Files.readString(file));
        }
        return scripts;
    }

    /**
     * The text of a file with its references to files that exist replaced by what the function makes of them; null
     * leaves one as it is.
     */
    static String replaced(Path file, Pattern references, Function<Path, String> replacement) throws IOException {
        return references.matcher(Files.readString(file)).replaceAll(found -> {
            Path target = file.resolveSibling(found.group()).normalize();
            String name = Files.isRegularFile(target) ? replacement.apply(target) : null;
            return Matcher.quoteReplacement(name == null ? found.group() : name);
        });
    }
}
