package org.jsmesh.app;

import java.io.IOException;
import java.net.BindException;
import java.nio.channels.UnresolvedAddressException;
import java.nio.file.FileSystemException;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.concurrent.Callable;
import org.jsmesh.app.console.CommandFailure;
import org.jsmesh.app.console.Output;
import org.jsmesh.app.server.AccessLog;
import org.jsmesh.app.server.CalmLog;
import org.jsmesh.app.server.JsmServer;
import org.jsmesh.app.server.ManagementServer;
import org.jsmesh.app.server.ServerSettings;
import org.jsmesh.app.server.Stopper;
import org.jsmesh.flags.PublicUrl;
import org.jsmesh.store.ModelSource;
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
            "Example: jsm serve s3://bucket/prefix",
            "Every option can also be given by the environment (JSM_PORT for --port; JSM_MODELS for DIR_OR_FILE) or as 'port = 8080' in the file of --config. "
                    + "Flags go before the environment, and that before the file. The password of the keystore is keystore-password there, never a flag."
        })
final class ServeCommand implements Callable<Integer> {
    private static final String KEYSTORE_PASSWORD = "keystore-password";

    /** Options that only the environment or the file can give, and that are never printed. */
    private static final Set<String> SECRETS = Set.of(KEYSTORE_PASSWORD);

    @Spec
    private CommandSpec spec;

    @Parameters(
            paramLabel = "DIR_OR_FILE",
            arity = "0..1",
            description = {
                "A folder of archives and models, or one such file; or a site that 'jsm encode --site' has written,",
                "in a bucket (s3://bucket/prefix) or a folder."
            })
    private String source;

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

    @Option(
            names = "--management-host",
            paramLabel = "H",
            defaultValue = "127.0.0.1",
            description = "The address that --management-port belongs to. Default: ${DEFAULT-VALUE}.")
    private String managementHost;

    @Option(
            names = "--cors-origins",
            paramLabel = "ORIGIN",
            split = ",",
            defaultValue = "*",
            description =
                    "Pages of these origins may read archives: https://example.org, * for all. Several with commas between. Default: ${DEFAULT-VALUE}.")
    private List<String> origins;

    @Option(
            names = "--embed-origins",
            paramLabel = "ORIGIN",
            split = ",",
            description =
                    "Pages of these origins may have the page in a frame: https://example.org, * for all. Several with commas between. Default: those of this server alone.")
    private List<String> embedders = List.of();

    @Option(
            names = "--public-url",
            paramLabel = "URL",
            description =
                    "Where visitors find the page, for those who show links to a model. Default: the address that a request names.")
    private String publicUrl;

    @Option(
            names = "--shutdown-grace",
            paramLabel = "T",
            defaultValue = "30s",
            description =
                    "How long transfers that run may go on when the server is told to stop. Default: ${DEFAULT-VALUE}.")
    private Wait grace;

    @Option(
            names = "--sign-key",
            paramLabel = "FILE",
            description = {
                "Serve models under signed addresses alone, see 'jsm sign'. A key of at least 32 bytes a line: the first",
                "signs, all verify. The file is read again when it changes. Default: anybody may have them."
            })
    private Path signKey;

    @Option(
            names = "--access-log",
            paramLabel = "FILE",
            description = "Append a line of JSON for every request to this file; - for stdout. Default: off.")
    private String accessLog;

    @Mixin
    private LimitOptions limits;

    @Mixin
    private EncodeOptions encoding;

    @Mixin
    private UploadOptions uploads;

    @Mixin
    private SiteOptions site;

    @Mixin
    private ViewerOption viewer;

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
        CalmLog.install();
        ServerSettings settings = settings()
                .withSignKeys(signKey == null ? null : SignCommand.keys(signKey))
                .withViewer(viewer.open());
        // The first resource is closed last, so that the process does not end before the log and the store are closed.
        try (Stopper stopper = new Stopper();
                ServedModels served = open();
                AccessLog log = openLog();
                JsmServer server = start(settings, served.models(), log);
                ManagementServer management = manage(server, served.models())) {
            // The user asked for the address, so --quiet does not hide it.
            spec.commandLine().getOut().println(server.uri());
            spec.commandLine().getOut().flush();
            output.note("Serving " + source + "; Ctrl+C ends it.");
            if (management != null) output.note("Health and metrics at port " + management.port() + ".");
            stopper.await(server);
        } catch (IOException e) {
            throw new CommandFailure(accessLog, e); // the only field here that changes
        }
        return 0;
    }

    private AccessLog openLog() throws CommandFailure {
        if (accessLog == null) return null;
        try {
            return accessLog.equals("-") ? AccessLog.to(System.out) : AccessLog.to(Path.of(accessLog));
        } catch (IOException e) {
            throw new CommandFailure(accessLog, e);
        } catch (InvalidPathException e) {
            throw new CommandFailure("--access-log: '" + accessLog + "' is no path: " + e.getReason());
        }
    }

    private ServerSettings settings() {
        try {
            if (managementPort > 65535)
                throw new IllegalArgumentException("port " + managementPort + " is above 65535");
            return limits.apply(ServerSettings.defaults().withAddress(host, port))
                    .withKeystore(keystore, configuration.secret(KEYSTORE_PASSWORD))
                    .withOrigins(origins)
                    .withEmbedders(embedders)
                    .withSenders(uploads.origins())
                    .withPublicUrl(PublicUrl.of(spec, publicUrl))
                    .withGrace(grace.millis());
        } catch (IllegalArgumentException e) {
            String option = e.getMessage().startsWith("port ") ? "--port or --management-port: " : "";
            throw new ParameterException(spec.commandLine(), option + e.getMessage(), e);
        }
    }

    private ServedModels open() throws CommandFailure {
        if (ServedModels.isSite(source)) {
            String why = "means nothing for a site that is written already: nothing is encoded or received there";
            ServedModels.refuse(spec, configuration, List.of("encoding", "uploads"), why);
            ServedModels.refuse(spec, configuration, spec.findOption("--cache"), why);
            return ServedModels.site(source, site);
        }
        ServedModels.refuse(spec, configuration, List.of("site"), "needs a site in a bucket, s3://bucket/prefix");
        try {
            StoreSettings settings =
                    encoding.apply(StoreSettings.of(Path.of(source)).withCache(cache));
            return ServedModels.of(uploads.open(new ModelStore(settings, encoding.encoder())));
        } catch (IllegalArgumentException e) {
            throw new ParameterException(spec.commandLine(), e.getMessage(), e);
        } catch (IOException e) {
            throw new CommandFailure(source, e);
        }
    }

    private JsmServer start(ServerSettings settings, ModelSource store, AccessLog log) throws CommandFailure {
        try {
            return JsmServer.start(settings, store, log);
        } catch (IOException e) {
            throw explain(e, "--port", host, port);
        }
    }

    private ManagementServer manage(JsmServer server, ModelSource store) throws CommandFailure {
        if (managementPort < 0) return null;
        try {
            return ManagementServer.start(managementHost, managementPort, store, server);
        } catch (IOException e) {
            throw explain(e, "--management-port", managementHost, managementPort);
        }
    }

    private CommandFailure explain(IOException e, String option, String where, int wanted) {
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
        return new CommandFailure(
                "cannot listen at port " + wanted + " of " + where + ": " + why + ". Choose another one with " + option
                        + " (0: any free one) or " + option.replace("port", "host") + ".");
    }
}
