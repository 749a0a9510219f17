package org.jsmesh.test.source;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.tools.Diagnostic;
import javax.tools.DiagnosticCollector;
import javax.tools.JavaCompiler;
import javax.tools.JavaFileObject;
import javax.tools.ToolProvider;

/**
 * A source file that stands in a document.
 *
 * @param name of its class
 * @param source the whole file, without a package
 */
public record JavaProgram(String name, String source) {
    private static final Pattern BLOCK = Pattern.compile("(?ms)^```java\\n(.*?)^```$");
    private static final Pattern NAME = Pattern.compile("(?m)^public (?:final )?class (\\w+)");

    /** The blocks of Java in a document, each of which is a source file. */
    public static List<JavaProgram> in(Path document) throws IOException {
        List<JavaProgram> programs = new ArrayList<>();
        Matcher block = BLOCK.matcher(Files.readString(document));
        while (block.find()) {
            Matcher name = NAME.matcher(block.group(1));
            if (!name.find()) throw new AssertionError(document + " has Java without a public class: " + block.group());
            programs.add(new JavaProgram(name.group(1), block.group(1)));
        }
        return programs;
    }

    /** The block of that name. */
    public static JavaProgram in(Path document, String name) throws IOException {
        return in(document).stream()
                .filter(program -> program.name.equals(name))
                .findFirst()
                .orElseThrow(() -> new AssertionError(document + " has no Java class " + name));
    }

    /**
     * Compiles it for Java 17 against the class path of the tests. Every warning is an error.
     *
     * @param folder for the class
     * @return what the compiler says, a line each; empty when the program is right
     */
    public List<String> compile(Path folder) throws IOException {
        Path file = Files.writeString(folder.resolve(name + ".java"), source);
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        DiagnosticCollector<JavaFileObject> said = new DiagnosticCollector<>();
        // Jars of others name jars that are not there, and annotations of tools that are not.
        List<String> options = new ArrayList<>(List.of("--release", "17", "-Xlint:all,-path,-classfile,-options"));
        options.addAll(List.of("-proc:none", "-cp", classPath(), "-d", folder.toString()));
        try (var files = compiler.getStandardFileManager(said, null, null)) {
            compiler.getTask(null, files, said, options, null, files.getJavaFileObjects(file))
                    .call();
        }
        return said.getDiagnostics().stream().map(this::line).toList();
    }

    private String line(Diagnostic<?> diagnostic) {
        return name + ".java:" + diagnostic.getLineNumber() + ": " + diagnostic.getMessage(null);
    }

    /** A process that runs the compiled program with these arguments; its messages are among its output. */
    public ProcessBuilder process(Path folder, Object... arguments) {
        List<String> command = new ArrayList<>();
        command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        command.add(name);
        for (Object argument : arguments) command.add(argument.toString());
        ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true);
        builder.environment().put("CLASSPATH", folder + File.pathSeparator + classPath());
        return builder;
    }

    /** Surefire hides the class path of tests in a jar. */
    private static String classPath() {
        return System.getProperty("surefire.test.class.path", System.getProperty("java.class.path"));
    }
}
