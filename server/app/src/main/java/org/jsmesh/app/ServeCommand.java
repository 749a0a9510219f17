package org.jsmesh.app;

import java.io.IOException;
import java.net.BindException;
import java.nio.channels.UnresolvedAddressException;
import java.nio.file.Path;
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
            "With --tls-keystore the password is read from the environment variable JSM_KEYSTORE_PASSWORD."
        })
final class ServeCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @Parameters(paramLabel = "DIR_OR_FILE", description = "A folder of archives and models, or one such file.")
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
            names = "--cache",
            paramLabel = "DIR",
            description = "Where encoded archives are kept. Default: the user's cache folder.")
    private Path cache;

    @Mixin
    private Output output;

    @Override
    public Integer call() throws CommandFailure, InterruptedException {
        ServerSettings settings = settings();
        try (ModelStore store = open();
                JsmServer server = start(settings, store)) {
            // The address is what the user asked for, so that --quiet does not hide it.
            spec.commandLine().getOut().println(server.uri());
            spec.commandLine().getOut().flush();
            output.note("Serving " + source + "; Ctrl+C ends it.");
            server.join();
        }
        return 0;
    }

    private ServerSettings settings() {
        try {
            ServerSettings settings = ServerSettings.defaults().withAddress(host, port);
            return settings.withKeystore(keystore, System.getenv("JSM_KEYSTORE_PASSWORD"));
        } catch (IllegalArgumentException e) {
            throw new ParameterException(spec.commandLine(), "--port: " + e.getMessage(), e);
        }
    }

    private ModelStore open() throws CommandFailure {
        try {
            StoreSettings settings = StoreSettings.of(source);
            if (cache != null) settings = settings.withCache(cache);
            return new ModelStore(settings, new ModelFilesEncoder(EncoderSettings.defaults()));
        } catch (IOException e) {
            throw new CommandFailure(source, e);
        }
    }

    private JsmServer start(ServerSettings settings, ModelStore store) throws CommandFailure {
        try {
            return JsmServer.start(settings, store);
        } catch (IOException e) {
            Throwable reason = e;
            while (reason.getCause() != null) reason = reason.getCause();
            if (reason instanceof BindException || reason instanceof UnresolvedAddressException) {
                String why = reason instanceof BindException ? reason.getMessage() : "no such address";
                throw new CommandFailure("cannot listen at port " + port + " of " + host + ": " + why
                        + ". Choose another one with --port (0: any free one) or --host.");
            }
            throw new CommandFailure(keystore, e);
        }
    }
}
