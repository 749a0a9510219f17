package org.jsmesh.app;

import java.io.PrintWriter;
import java.net.URI;
import java.net.URISyntaxException;
import java.nio.charset.Charset;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.CancellationException;
import org.jsmesh.app.console.CommandFailure;
import org.jsmesh.app.heap.HeapSize;
import org.jsmesh.app.heap.Relaunch;
import org.jsmesh.files.Explanation;
import org.jsmesh.files.PathNames;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.IVersionProvider;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;
import picocli.CommandLine.TypeConversionException;
import picocli.CommandLine.UnmatchedArgumentException;

/**
 * The {@code jsm} command. Exit code 0: done; 1: failed, one line on stderr says what, where and a remedy; 2: wrong
 * usage.
 */
@Command(
        name = "jsm",
        description = "Turns triangle meshes into archives that stream progressively and come back bit for bit.",
        mixinStandardHelpOptions = true,
        versionProvider = Jsm.Version.class,
        synopsisSubcommandLabel = "COMMAND",
        subcommands = {
            EncodeCommand.class,
            DecodeCommand.class,
            InfoCommand.class,
            PosterCommand.class,
            VerifyCommand.class,
            FetchCommand.class,
            SimulateCommand.class,
            BenchCommand.class,
            ReproduceCommand.class,
            ServeCommand.class,
            SignCommand.class
        },
        footer = {"", "Example: jsm encode bunny.ply -o bunny.jsm", "'jsm COMMAND --help' tells more about a command."})
public final class Jsm implements Runnable {
    /** What Java puts in place of a byte of an argument that the locale cannot hold. */
    private static final char UNREADABLE = '\ufffd';

    private final Relaunch relaunch; // null in the second process

    @Spec
    private CommandSpec spec;

    private Jsm(Relaunch relaunch) {
        this.relaunch = relaunch;
    }

    /** How to start this program again with another heap; null when that was done. */
    Relaunch relaunch() {
        return relaunch;
    }

    /** Runs the command line and ends the process. */
    public static void main(String[] args) {
        PrintWriter out = new PrintWriter(System.out, true, charset("stdout.encoding"));
        PrintWriter err = new PrintWriter(System.err, true, charset("stderr.encoding"));
        int code = run(new Jsm(Relaunch.of(Jsm.class, args)), System.getenv(), out, err, args);
        out.flush();
        err.flush();
        System.exit(code);
    }

    /** Runs a command line in this process. Tests and other programs call this. */
    public static int run(PrintWriter out, PrintWriter err, String... args) {
        return run(System.getenv(), out, err, args);
    }

    static int run(Map<String, String> environment, PrintWriter out, PrintWriter err, String... args) {
        return run(
                new Jsm(Relaunch.impossible("the command runs within another program")), environment, out, err, args);
    }

    private static int run(Jsm jsm, Map<String, String> environment, PrintWriter out, PrintWriter err, String... args) {
        CommandLine line = new CommandLine(jsm);
        line.getSubcommands().get("serve").setDefaultValueProvider(new Configuration(environment, args));
        line.setOut(out).setErr(err);
        line.setCaseInsensitiveEnumValuesAllowed(true);
        line.registerConverter(Wait.class, Wait::parse);
        line.registerConverter(HeapSize.class, HeapSize::parse);
        line.registerConverter(Path.class, Jsm::path);
        line.registerConverter(URI.class, Jsm::address);
        line.setParameterExceptionHandler((e, rest) -> usage(e));
        line.setExecutionExceptionHandler((e, command, result) -> failed(e, command));
        int code = execute(line, args);
        if (!out.checkError()) return code;
        err.println("jsm: the output could not be written to the end. Check where stdout leads, and the space there.");
        return code == 0 ? CommandLine.ExitCode.SOFTWARE : code;
    }

    /** Errors of the machine are told as failures are: memory that is used up, nesting that is too deep. */
    private static int execute(CommandLine line, String... args) {
        try {
            return line.execute(args);
        } catch (VirtualMachineError | LinkageError e) {
            line.getErr().println("jsm: " + Explanation.of(null, e));
            return CommandLine.ExitCode.SOFTWARE;
        }
    }

    /** An empty text would mean the current folder. An unset variable of a script must not mean that. */
    private static Path path(String text) {
        if (text.isEmpty()) throw new TypeConversionException("it is empty; give a path, or . for this folder");
        try {
            return Path.of(text);
        } catch (InvalidPathException e) {
            throw new TypeConversionException(noPath(text, e));
        }
    }

    private static String noPath(String text, InvalidPathException e) {
        return text.indexOf(UNREADABLE) < 0
                ? "'" + text + "' is no path: " + e.getReason()
                : "'" + text + "': the locale of this process cannot hold this name. " + PathNames.REMEDY;
    }

    private static URI address(String text) {
        try {
            // Letters beyond ASCII go percent-encoded over the wire.
            return new URI(new URI(text).toASCIIString());
        } catch (URISyntaxException e) {
            String where = e.getIndex() < 0 ? "" : " at character " + (e.getIndex() + 1);
            throw new TypeConversionException("'" + text + "' is no address: "
                    + e.getReason().toLowerCase(Locale.ROOT) + where + "; write a space as %20");
        }
    }

    @Override
    public void run() {
        throw new ParameterException(spec.commandLine(), "no command is given");
    }

    private static int usage(ParameterException e) {
        String name = e.getCommandLine().getCommandSpec().qualifiedName();
        e.getCommandLine().getErr().println(name + ": " + reason(e) + source(e) + ". See '" + name + " --help'.");
        return CommandLine.ExitCode.USAGE;
    }

    /** The source of a wrong value, when it was not on the command line. */
    private static String source(ParameterException e) {
        if (!(e.getCommandLine().getDefaultValueProvider() instanceof Configuration configuration)) return "";
        Configuration.Value value =
                e.getArgSpec() == null ? null : configuration.find(Configuration.name(e.getArgSpec()));
        return value != null && value.text().equals(e.getValue()) ? " (from " + value.source() + ")" : "";
    }

    /** The message without the word that picocli puts before some. */
    private static String reason(ParameterException e) {
        if (e instanceof UnmatchedArgumentException unmatched
                && unmatched.getUnmatched().contains("")) return "an argument: it is empty";
        if (e instanceof UnmatchedArgumentException unmatched) {
            // A name that is no path is left over where any number of paths may stand.
            for (String argument : unmatched.getUnmatched()) {
                try {
                    Path.of(argument);
                } catch (InvalidPathException invalid) {
                    return noPath(argument, invalid);
                }
            }
        }
        String text = oneLine(e.getMessage());
        return text.startsWith("Error: ") ? text.substring("Error: ".length()) : text;
    }

    private static int failed(Exception e, CommandLine command) {
        String message = e instanceof CommandFailure || e instanceof CancellationException
                ? e.getMessage()
                : Explanation.of(null, e).toString();
        command.getErr().println(command.getCommandSpec().qualifiedName() + ": " + oneLine(message));
        return CommandLine.ExitCode.SOFTWARE;
    }

    private static String oneLine(String text) {
        return String.valueOf(text).strip().replaceAll("\\s*\\R\\s*", " ");
    }

    private static Charset charset(String property) {
        String name = System.getProperty(property);
        return name == null ? Charset.defaultCharset() : Charset.forName(name);
    }

    /** The version that the build wrote into the jar. */
    static final class Version implements IVersionProvider {
        @Override
        public String[] getVersion() {
            String version = Jsm.class.getPackage().getImplementationVersion();
            return new String[] {"jsm " + (version == null ? "(not packaged)" : version)};
        }
    }
}
