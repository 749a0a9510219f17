package org.jsmesh.app;

import java.io.IOException;
import java.io.Reader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Properties;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jsmesh.app.console.CommandFailure;
import picocli.CommandLine.IDefaultValueProvider;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.PositionalParamSpec;
import picocli.CommandLine.ParseResult;

/**
 * Finds the options of a command that are not given as flags: in the environment ({@code --tls-keystore} is
 * {@code JSM_TLS_KEYSTORE}), then in the properties file that {@code --config} or {@code JSM_CONFIG} names
 * ({@code tls-keystore = ...}), then the default. Secrets come only from the environment or the file, because a list of
 * processes would show flags.
 */
final class Configuration implements IDefaultValueProvider {
    static final String FILE = "config";

    /** The name of the one positional parameter; the web application looks for the same variable. */
    static final String MODELS = "models";

    private static final Set<String> FLAGS_ONLY = Set.of("help", "version", "print-config");

    private final Map<String, String> environment;
    private final Properties file = new Properties();
    private final Path path;
    private CommandFailure failure;

    /**
     * @param environment variables of the process
     * @param args the command line; the name of the file is looked for in it before it is parsed
     */
    Configuration(Map<String, String> environment, String... args) {
        this.environment = environment;
        String name = fileName(args);
        if (name == null) name = variable(FILE);
        Path named = null;
        try {
            named = name == null ? null : Path.of(name);
            if (named != null) load(named);
        } catch (InvalidPathException e) {
            failure = new CommandFailure("'" + name + "' is no path: " + e.getReason() + ". Check --config.");
        } catch (IOException e) {
            failure = new CommandFailure(named, e);
        } catch (IllegalArgumentException e) {
            failure = new CommandFailure(
                    named + ": is no file of properties: " + e.getMessage() + ". Write one 'option = value' a line.");
        }
        path = named;
    }

    private static String fileName(String... args) {
        String flag = "--" + FILE;
        String found = null;
        for (int i = 0; i < args.length && !args[i].equals("--"); i++) {
            if (args[i].startsWith(flag + "=")) found = args[i].substring(flag.length() + 1);
            else if (args[i].equals(flag) && i + 1 < args.length) found = args[i + 1];
        }
        return found;
    }

    private void load(Path from) throws IOException {
        try (Reader reader = Files.newBufferedReader(from, StandardCharsets.UTF_8)) {
            file.load(reader);
        }
    }

    /** A value and where it was found, in words. */
    record Value(String text, String source) {}

    @Override
    public String defaultValue(ArgSpec arg) {
        Value value = find(name(arg));
        return value == null ? null : value.text();
    }

    /** The value of that name in the environment or the file, or null; an empty variable is none. */
    Value find(String name) {
        if (FLAGS_ONLY.contains(name)) return null;
        String text = variable(name);
        if (text != null) return new Value(text, variableName(name));
        text = file.getProperty(name);
        return text == null ? null : new Value(text.strip(), path.toString());
    }

    /** A secret, or null. */
    String secret(String name) {
        Value value = find(name);
        return value == null ? null : value.text();
    }

    private String variable(String name) {
        String text = environment.get(variableName(name));
        return text == null || text.isBlank() ? null : text;
    }

    static String variableName(String name) {
        return "JSM_" + name.toUpperCase(Locale.ROOT).replace('-', '_');
    }

    /** Name of an option in the file. */
    static String name(ArgSpec arg) {
        return arg instanceof OptionSpec option ? option.longestName().replaceFirst("^-+", "") : MODELS;
    }

    /**
     * Refuses a file that could not be read, and unknown names in it.
     *
     * @param secrets that the command knows
     */
    void check(CommandSpec spec, Set<String> secrets) throws CommandFailure {
        if (failure != null) throw failure;
        Set<String> unknown = new TreeSet<>(file.stringPropertyNames());
        unknown.removeAll(secrets);
        for (ArgSpec arg : spec.args()) {
            if (!FLAGS_ONLY.contains(name(arg)) && !name(arg).equals(FILE)) unknown.remove(name(arg));
        }
        if (!unknown.isEmpty()) {
            throw new CommandFailure(path + ": there is no option " + String.join(", ", unknown)
                    + ". Write options as in 'jsm " + spec.name() + " --help', without the hyphens in front.");
        }
    }

    /** One line per option: name, value in effect, source. For a secret it says only whether there is one. */
    List<String> describe(CommandSpec spec, ParseResult parsed, Set<String> secrets) {
        Map<String, String> lines = new TreeMap<>();
        for (ArgSpec arg : spec.args()) {
            String name = name(arg);
            if (FLAGS_ONLY.contains(name)) continue;
            boolean given = arg instanceof OptionSpec option
                    ? parsed.hasMatchedOption(option)
                    : parsed.hasMatchedPositional((PositionalParamSpec) arg);
            Value found = find(name);
            Value effective = given
                    ? new Value(String.join(",", arg.stringValues()), "flag")
                    : found != null
                            ? found
                            : new Value(arg.defaultValue() == null ? "" : arg.defaultValue(), "default");
            lines.put(name, line(name, effective));
        }
        for (String secret : secrets) {
            Value found = find(secret);
            lines.put(
                    secret, line(secret, found == null ? new Value("", "default") : new Value("***", found.source())));
        }
        return new ArrayList<>(lines.values());
    }

    private static String line(String name, Value value) {
        return name + " = " + value.text() + "  # " + value.source();
    }
}
