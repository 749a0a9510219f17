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
 * Options of a texture become parameters such as {@code map_Kd -s}. The statement {@value #GLTF} has a definition of
 * glTF, as {@link Material#gltf} has it. Beside it only textures under keys of glTF count.
 */
final class MtlReader {
    static final String GLTF = "gltf";
    private static final Set<String> IMAGE_KEYS = Set.of("bump", "disp", "decal", "refl", "norm");
    private static final Set<String> NUMERIC_OPTIONS = Set.of("-o", "-s", "-t", "-mm", "-bm", "-boost", "-texres");
    private static final Set<String> WORD_OPTIONS = Set.of("-blendu", "-blendv", "-cc", "-clamp", "-imfchan", "-type");

    private final TextScanner scanner;
    private final String file;
    private final Map<String, Material> materials;
    private final List<Note> notes;
    private final Set<String> repeated = new LinkedHashSet<>();
    private final Set<String> own = new LinkedHashSet<>();
    private final Set<String> unknownOptions = new LinkedHashSet<>();
    private final Set<String> besideGltf = new LinkedHashSet<>();
    private int strayStatements;
    private int firstStray;
    private String name;
    private List<Material.Parameter> parameters;
    private List<Material.TextureReference> textures;
    private String gltf;

    /** @param materials takes the definitions by name; a later one of the same name replaces the earlier */
    MtlReader(String file, byte[] content, Map<String, Material> materials, List<Note> notes) {
        this.file = file;
        this.materials = materials;
        this.notes = notes;
        scanner = new TextScanner(file, TextFilling.without(content), 0, true, true);
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
        if (!unknownOptions.isEmpty())
            notes.add(Notes.unread(
                    Notes.shown(file) + ": options of textures that are not known, kept and not drawn: "
                            + Notes.names(unknownOptions) + ".",
                    unknownOptions));
        if (!besideGltf.isEmpty())
            notes.add(Notes.dropped(
                    Notes.shown(file) + ": statements beside a definition of glTF left out: " + Notes.names(besideGltf)
                            + ".",
                    besideGltf));
        if (!repeated.isEmpty())
            notes.add(Notes.dropped(
                    Notes.shown(file) + ": defined more than once, the last definition counts: " + Notes.names(repeated)
                            + ".",
                    repeated));
    }

    /** Whether a statement names an image file. */
    static boolean isTextureKey(String key) {
        return key.startsWith("map_") && !key.equals("map_aat") || IMAGE_KEYS.contains(key) || isGltfKey(key);
    }

    private static boolean isGltfKey(String key) {
        return key.contains("Texture") || key.contains(".texture");
    }

    private void start(String newName) {
        name = newName;
        parameters = new ArrayList<>();
        textures = new ArrayList<>();
        gltf = "";
        if (!own.add(newName)) repeated.add(newName);
    }

    private void finish() {
        if (name == null) return;
        if (!gltf.isEmpty()) leaveOthersOut();
        materials.put(name, new Material(name, parameters, textures, gltf));
    }

    /** A definition of glTF is the whole of a material. */
    private void leaveOthersOut() {
        for (Material.Parameter p : parameters) besideGltf.add(name + ": " + p.key());
        parameters.clear();
        for (Material.TextureReference t : textures) if (!isGltfKey(t.key())) besideGltf.add(name + ": " + t.key());
        textures.removeIf(t -> !isGltfKey(t.key()));
    }

    private void statement() {
        String key = scanner.token();
        int start = scanner.position();
        if (key.equals(GLTF)) {
            gltf = scanner.restOfLine();
            return;
        }
        if (isTextureKey(key)) {
            List<Material.Parameter> options = options(key);
            String path = FileNames.unquoted(scanner.restOfLine());
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
            } else if (option.matches("-[a-zA-Z]+") && !scanner.atLineEnd()) {
                Material.Parameter unknown = unknownOption(key + ' ' + option);
                if (scanner.atLineEnd()) {
                    // there is no name behind it, so it is the name
                    scanner.backTo(before);
                    return options;
                }
                unknownOptions.add(option);
                options.add(unknown);
            } else {
                scanner.backTo(before);
                return options;
            }
        }
    }

    /** Its values are what is a number, on or off. */
    private Material.Parameter unknownOption(String key) {
        float[] values = numbers(Integer.MAX_VALUE);
        int before = scanner.position();
        if (values.length > 0 || !scanner.nextOnLine()) return new Material.Parameter(key, values);
        if (scanner.tokenIs("on") || scanner.tokenIs("off")) return new Material.Parameter(key + ' ' + scanner.token());
        scanner.backTo(before);
        return new Material.Parameter(key);
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
