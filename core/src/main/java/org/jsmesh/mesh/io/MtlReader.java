package org.jsmesh.mesh.io;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Note;

/**
 * Reads a material library of OBJ. Statements of numbers become parameters, and texture statements become references.
 * Any other statement becomes a parameter without values whose key is the statement's text, so that nothing is lost.
 * Options of a texture become parameters such as {@code map_Kd -s}.
 */
final class MtlReader {
    private static final Set<String> IMAGE_KEYS = Set.of("bump", "disp", "decal", "refl", "norm");
    private static final Set<String> NUMERIC_OPTIONS = Set.of("-o", "-s", "-t", "-mm", "-bm", "-boost", "-texres");
    private static final Set<String> WORD_OPTIONS = Set.of("-blendu", "-blendv", "-cc", "-clamp", "-imfchan", "-type");

    private final TextScanner scanner;
    private final String file;
    private final Map<String, Material> materials;
    private final List<Note> notes;
    private final Set<String> repeated = new LinkedHashSet<>();
    private final Set<String> own = new LinkedHashSet<>();
    private int strayStatements;
    private int firstStray;
    private String name;
    private List<Material.Parameter> parameters;
    private List<Material.TextureReference> textures;

    /** @param materials takes the definitions by name; a later one of the same name replaces the earlier */
    MtlReader(String file, byte[] content, Map<String, Material> materials, List<Note> notes) {
        this.file = file;
        this.materials = materials;
        this.notes = notes;
        scanner = new TextScanner(file, content, 0, true, true);
    }

    void read() {
        boolean skipNext = false;
        do {
            if (!scanner.nextOnLine()) {
                skipNext = skipNext || scanner.lineIs(MtlStatements.DERIVED);
            } else if (skipNext) {
                skipNext = false;
            } else if (scanner.tokenIs("newmtl")) {
                finish();
                start(scanner.restOfLine());
            } else if (name == null) {
                if (strayStatements++ == 0) firstStray = scanner.line();
            } else {
                statement();
            }
        } while (scanner.nextLine());
        finish();
        if (strayStatements > 0)
            notes.add(Note.unread(
                    Notes.shown(file) + ": " + Notes.count(strayStatements, "statement")
                            + " before the first newmtl skipped.",
                    strayStatements,
                    "line " + firstStray));
        if (!repeated.isEmpty())
            notes.add(Notes.dropped(
                    Notes.shown(file) + ": defined more than once, the last definition counts: " + Notes.names(repeated)
                            + ".",
                    repeated));
    }

    /** Whether a statement names an image file. */
    static boolean isTextureKey(String key) {
        return key.startsWith("map_") && !key.equals("map_aat") || IMAGE_KEYS.contains(key) || key.endsWith("Texture");
    }

    private void start(String newName) {
        name = newName;
        parameters = new ArrayList<>();
        textures = new ArrayList<>();
        if (!own.add(newName)) repeated.add(newName);
    }

    private void finish() {
        if (name != null) materials.put(name, new Material(name, parameters, textures));
    }

    private void statement() {
        String key = scanner.token();
        int start = scanner.position();
        if (isTextureKey(key)) {
            List<Material.Parameter> options = options(key);
            String path = scanner.restOfLine();
            if (!path.isEmpty()) {
                parameters.addAll(options);
                textures.add(new Material.TextureReference(key, path));
                return;
            }
        } else {
            float[] values = numbers(Integer.MAX_VALUE);
            if (scanner.atLineEnd()) {
                parameters.add(new Material.Parameter(key, values));
                return;
            }
        }
        scanner.backTo(start);
        String rest = scanner.restOfLine();
        parameters.add(new Material.Parameter(rest.isEmpty() ? key : key + ' ' + rest));
    }

    private List<Material.Parameter> options(String key) {
        List<Material.Parameter> options = new ArrayList<>();
        while (true) {
            int before = scanner.position();
            boolean found = scanner.nextOnLine();
            String option = found ? scanner.token() : "";
            if (NUMERIC_OPTIONS.contains(option)) {
                options.add(new Material.Parameter(key + ' ' + option, numbers(option.equals("-mm") ? 2 : 3)));
            } else if (WORD_OPTIONS.contains(option) && scanner.nextOnLine()) {
                options.add(new Material.Parameter(key + ' ' + option + ' ' + scanner.token()));
            } else {
                scanner.backTo(before);
                return options;
            }
        }
    }

    /** Numbers up to the first token that is not a number. */
    private float[] numbers(int most) {
        IntList bits = new IntList();
        while (bits.size() < most) {
            int before = scanner.position();
            if (!scanner.nextOnLine()) break;
            float value = scanner.tokenIsNumber() ? scanner.number() : Float.NaN;
            if (Float.isNaN(value) || Float.isInfinite(value)) {
                scanner.backTo(before);
                break;
            }
            bits.add(Float.floatToRawIntBits(value));
        }
        return bits.toFloats();
    }
}
