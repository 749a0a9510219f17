package org.jsmesh.web.build;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Names fields in what TeaVM compiles to JavaScript. TeaVM gives each of a thousand fields a name of its own; here
 * those of classes that do not extend each other share names, which packs smaller. Only a minified script will do.
 */
public final class FieldNames {
    /** Lines end anywhere between words and signs. These ends mean nothing. */
    private static final Pattern LINE_END = Pattern.compile("(?<=[=.,;(\\[{])\\n|\\n(?=[=.,;()\\[\\]{}])");

    /** {@code function B(){let a=this;A.call(a);a.c=null;a.d=0;}}, or with {@code this} for a single field. */
    private static final Pattern CLASS = Pattern.compile("function\\s([\\w$]+)\\(\\)\\{(?:let\\sa=this;)?"
            + "([\\w$]+)\\.call\\((?:a|this)\\);((?:(?:a|this)\\.[\\w$]+=[^;{}]*+;)*+)\\}");

    private static final Pattern ROOT = Pattern.compile("function\\s([\\w$]+)\\(\\)\\{this\\.\\$id\\$=0;\\}");

    /** The function that makes classes without fields of the class that they extend. */
    private static final Pattern MAKER = Pattern.compile("([\\w$]+)=superclass=>\\{");

    private static final Pattern FIELD = Pattern.compile("(?:a|this)\\.([\\w$]+)=");
    private static final Pattern STRING = Pattern.compile("\"([^\"\\\\]*+(?:\\\\.[^\"\\\\]*+)*+)\"|'([^'\\\\]*+)'");
    private static final Pattern USE = Pattern.compile(STRING.pattern() + "|\\.([A-Za-z_$][\\w$]*+)");
    private static final Pattern KEY = Pattern.compile("[{,]([\\w$]+):");

    /** Short names of what browsers have. */
    private static final Set<String> FOREIGN = Set.of("at", "id", "is", "of", "x", "y", "z", "w");

    private static final String LETTERS = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_$";

    private final String script;
    private final Map<String, Type> types = new LinkedHashMap<>();
    private final Set<String> fields = new HashSet<>();
    private final List<String> names = new ArrayList<>();

    private record Type(String above, List<String> fields) {}

    private FieldNames(String script) {
        this.script = script;
    }

    /**
     * Renames the fields in all scripts of a folder.
     *
     * @param args the folder, which may be missing, and the one for the new scripts
     * @throws IOException when a file cannot be read or written, or a script is not as TeaVM writes it
     */
    public static void main(String[] args) throws IOException {
        Path from = Path.of(args[0]);
        if (!Files.isDirectory(from)) return;
        for (Path file : Folders.files(from)) {
            if (!file.toString().endsWith(".js")) continue;
            Path to = Path.of(args[1]).resolve(file.getFileName().toString());
            Files.createDirectories(to.getParent());
            try {
                Files.writeString(to, shared(Files.readString(file)));
            } catch (IllegalArgumentException e) {
                throw new IOException(file + ": " + e.getMessage(), e);
            }
        }
    }

    /**
     * The same script with names that classes share.
     *
     * @throws IllegalArgumentException when it is not as TeaVM writes it
     */
    static String shared(String script) {
        FieldNames all = new FieldNames(LINE_END.matcher(script).replaceAll(""));
        all.findTypes();
        all.findNames();
        Map<String, String> renamed = new HashMap<>();
        for (Type type : all.types.values()) {
            int at = all.fieldsOf(type.above);
            for (String field : type.fields) renamed.put(field, all.names.get(at++));
        }
        return USE.matcher(all.script).replaceAll(use -> {
            String name = use.group(3) == null ? null : renamed.get(use.group(3));
            return Matcher.quoteReplacement(name == null ? use.group() : "." + name);
        });
    }

    private void findTypes() {
        Matcher root = ROOT.matcher(script);
        Matcher maker = MAKER.matcher(script);
        if (!root.find() || !maker.find())
            throw strange("no root of all classes is found", "compile it minified, and by the version in the pom");
        types.put(root.group(1), new Type(null, List.of()));
        for (Matcher type = CLASS.matcher(script); type.find(); ) {
            List<String> own = new ArrayList<>();
            for (Matcher field = FIELD.matcher(type.group(3)); field.find(); ) {
                String name = field.group(1);
                if (FOREIGN.contains(name)) continue;
                if (!fields.add(name)) throw strange("two classes have a field " + name, "rename none");
                own.add(name);
            }
            types.put(type.group(1), new Type(type.group(2), own));
        }
        String made = "(?<![\\w$.])([\\w$]+)=" + Pattern.quote(maker.group(1)) + "\\(([\\w$]*)\\)";
        for (Matcher type = Pattern.compile(made).matcher(script); type.find(); ) {
            String above = type.group(2).isEmpty() ? root.group(1) : type.group(2);
            if (!above.equals("0")) types.putIfAbsent(type.group(1), new Type(above, List.of()));
        }
    }

    /** As many names as any class needs, none of which means something else. */
    private void findNames() {
        Set<String> taken = new HashSet<>(FOREIGN);
        for (Matcher use = USE.matcher(script); use.find(); ) {
            for (int i = 1; i <= use.groupCount(); i++)
                if (use.group(i) != null && !(i == 3 && fields.contains(use.group(i)))) taken.add(use.group(i));
        }
        for (Matcher key = KEY.matcher(script); key.find(); ) taken.add(key.group(1));
        int most = 0;
        for (String type : types.keySet()) most = Math.max(most, fieldsOf(type));
        for (int i = 0; names.size() < most; i++) {
            int first = i / LETTERS.length() - 1;
            String name = (first < 0 ? "" : LETTERS.substring(first, first + 1)) + LETTERS.charAt(i % LETTERS.length());
            if (!taken.contains(name)) names.add(name);
        }
    }

    /** With those of the classes above it. */
    private int fieldsOf(String type) {
        int count = 0;
        for (String at = type; at != null; ) {
            Type found = types.get(at);
            if (found == null) throw strange("class " + at + " is not found", "compile it by the version in the pom");
            count += found.fields.size();
            at = found.above;
        }
        return count;
    }

    private static IllegalArgumentException strange(String reason, String remedy) {
        return new IllegalArgumentException("the script is not as TeaVM writes it, " + reason + "; " + remedy);
    }
}
