package org.jsmesh.app;

import java.io.IOException;
import java.net.BindException;
import java.nio.channels.UnresolvedAddressException;
import java.nio.file.FileSystemException;
import java.nio.file.Path;
import java.util.Set;
import java.util.concurrent.Callable;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.store.ModelFilesEncoder;
import org.jsmesh.store.ModelStore;
import org.jsmesh.store.StoreSettings;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.Spec;

/** {@code jsm serve}: archives and models over HTTP, with the page to look at them. */
@Command(
        name = "serve",
        description = {
            "Serves archives, and models that it encodes when somebody asks for them first.",
            "Prints the address to open in a browser, and runs until it is interrupted."
        },
        footer = {
            "",
            "Example: jsm serve models --port 8080",
            "Every option can also be given by the environment (JSM_PORT for --port; JSM_MODELS for DIR_OR_FILE) or as 'port = 8080' in the file of --config. "
                    + "Flags go before the environment, and that before the file. The password of the keystore is keystore-password there, never a flag."
        })
final class ServeCommand implements Callable<Integer> {
    private static final String KEYSTORE_PASSWORD = "keystore-password";

    /** What is given by the environment or the file alone, and never printed. */
    private static final Set<String> SECRETS = Set.of(KEYSTORE_PASSWORD);

    @Spec
    private CommandSpec spec;

    @Parameters(
            paramLabel = "DIR_OR_FILE",
            arity = "0..1",
            description = "A folder of archives and models, or one such file.")
    private Path source;

    @Option(
            names = "--port",
            paramLabel = "P",
            defaultValue = "8080",
            description = "The port; 0 chooses a free one. Default: ${DEFAULT-VALUE}.")
    private int port;

    @Option(
            names = "--host",
            paramLabel = "H",
            defaultValue = "127.0.0.1",
            description = "The address to listen at; 0.0.0.0 for every machine. Default: ${DEFAULT-VALUE}.")
    private String host;

    @Option(
            names = "--tls-keystore",
            paramLabel = "K",
            description = "Serve HTTPS with the certificate in this keystore.")
    private Path keystore;

    @Option(
            names = "--management-port",
            paramLabel = "P",
            defaultValue = "-1",
            description =
                    "Answer /health/live, /health/ready and /metrics at this port; 0 chooses a free one. Default: off.")
    private int managementPort;

    @Option(
            names = "--cache",
            paramLabel = "DIR",
            description = "Where encoded archives are kept. Default: the user's cache folder.")
    private Path cache;

    @Option(
            names = "--config",
            paramLabel = "FILE",
            description = "Read options from this file of properties, one 'option = value' a line.")
    private Path config;

    @Option(
            names = "--print-config",
            description = "Print every option, its value and where that comes from, and exit.")
    private boolean printConfig;

    @Mixin
    private Output output;

    private Configuration configuration;

    @Override
    public Integer call() throws CommandFailure, InterruptedException {
        configuration = (Configuration) spec.commandLine().getDefaultValueProvider();
        configuration.check(spec, SECRETS);
        if (printConfig) {
            ParseResult parsed = spec.commandLine().getParseResult();
            configuration
                    .describe(spec, parsed, SECRETS)
                    .forEach(spec.commandLine().getOut()::println);
            return 0;
        }
        if (source == null) throw new ParameterException(spec.commandLine(), "DIR_OR_FILE is missing: what to serve");
        // One line per message, unless the user has set up the logging; read when the first message is written.
        String format = "java.util.logging.SimpleFormatter.format";
        if (System.getProperty(format) == null) System.setProperty(format, "%1$tT %4$s %5$s%6$s%n");
        ServerSettings settings = settings();
        try (ModelStore store = open();
                JsmServer server = start(settings, store);
                ManagementServer management = manage(server, store)) {
            // The address is what the user asked for, so that --quiet does not hide it.
            spec.commandLine().getOut().println(server.uri());
            spec.commandLine().getOut().flush();
            output.note("Serving " + source + "; Ctrl+C ends it.");
            if (management != null) output.note("Health and metrics at port " + management.port() + ".");
            server.join();
        }
        return 0;
    }

    private ServerSettings settings() {
        try {
            if (managementPort > 65535)
                throw new IllegalArgumentException("port " + managementPort + " is above 65535");
            ServerSettings settings = ServerSettings.defaults().withAddress(host, port);
            return settings.withKeystore(keystore, configuration.secret(KEYSTORE_PASSWORD));
        } catch (IllegalArgumentException e) {
            throw new ParameterException(spec.commandLine(), "--port or --management-port: " + e.getMessage(), e);
        }
    }

    private ModelStore open() throws CommandFailure {
        try {
            StoreSettings settings = StoreSettings.of(source);
            if (cache != null) settings = settings.withCache(cache);
            EncoderSettings encoding =
                    EncoderSettings.defaults().withThreads(Runtime.getRuntime().availableProcessors());
            return new ModelStore(settings, new ModelFilesEncoder(encoding));
        } catch (IOException e) {
            throw new CommandFailure(source, e);
        }
    }

    private JsmServer start(ServerSettings settings, ModelStore store) throws CommandFailure {
        try {
            return JsmServer.start(settings, store);
        } catch (IOException e) {
            throw explain(e, "--port", port);
        }
    }

    private ManagementServer manage(JsmServer server, ModelStore store) throws CommandFailure {
        if (managementPort < 0) return null;
        try {
            return ManagementServer.start(host, managementPort, store, server.statistics());
        } catch (IOException e) {
            throw explain(e, "--management-port", managementPort);
        }
    }

    private CommandFailure explain(IOException e, String option, int wanted) {
        Throwable reason = e;
        while (reason.getCause() != null) reason = reason.getCause();
        if (!(reason instanceof BindException || reason instanceof UnresolvedAddressException)) {
            if (keystore == null || e instanceof FileSystemException) return new CommandFailure(keystore, e);
            return new CommandFailure(
                    keystore + ": is no keystore, or not one that the password in the environment variable "
                            + "JSM_KEYSTORE_PASSWORD opens (" + e.getMessage()
                            + "). Give a PKCS #12 or JKS file and its password.");
        }
        String why = reason instanceof BindException ? reason.getMessage() : "no such address";
        return new CommandFailure("cannot listen at port " + wanted + " of " + host + ": " + why
                + ". Choose another one with " + option + " (0: any free one) or --host.");
    }
}
