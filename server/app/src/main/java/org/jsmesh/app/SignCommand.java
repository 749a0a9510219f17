package org.jsmesh.app;

import java.io.IOException;
import java.net.URI;
import java.net.URLDecoder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Instant;
import java.util.concurrent.Callable;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jsmesh.app.console.CommandFailure;
import org.jsmesh.app.console.Output;
import org.jsmesh.secret.SignKeys;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code jsm sign}: an address that opens a model of a server with {@code --sign-key}. */
@Command(
        name = "sign",
        description = {
            "Prints an address that opens a model, or the catalogue and every model, on a server with --sign-key.",
            "A signature for any address of a model opens all of them: its page, manifest, archive and pictures."
        },
        footer = {
            "",
            "Example: jsm sign --sign-key keys --expires 1h https://meshes.example.org/m/chair/",
            "An address that ends with /m/ or /index.json is that of the catalogue."
        })
final class SignCommand implements Callable<Integer> {
    private static final Pattern TIME = Pattern.compile("(\\d{1,9})([smhd])");
    private static final Pattern CATALOGUE = Pattern.compile("(.*/)?(m/|index\\.json)");

    /** The folder of a model, and what may be in it. */
    private static final Pattern MODEL = Pattern.compile(
            "(?:.*/)?([^/]+)/" + "(|manifest\\.json|annotations\\.json|status|[0-9a-f]{64}\\.jsm|[0-9a-f]{64}/.+)");

    @Spec
    private CommandSpec spec;

    @Option(names = "--sign-key", required = true, paramLabel = "FILE", description = "The keys of the server.")
    private Path keys;

    @Option(
            names = "--expires",
            paramLabel = "T",
            defaultValue = "1h",
            description = "How long the address is good: 90s, 30m, 1h, 7d. Default: ${DEFAULT-VALUE}.")
    private String expires;

    @Parameters(paramLabel = "URL", description = "Address of a model or of the catalogue.")
    private URI address;

    @Mixin
    private Output output;

    @Override
    public Integer call() throws CommandFailure {
        Instant until = Instant.now().plusSeconds(seconds());
        String plain = address.toString().replaceFirst("[?#].*", "");
        String query = keys(keys).query(id(), until);
        // What was asked for, so --quiet does not hide it.
        spec.commandLine().getOut().println(plain + "?" + query);
        return 0;
    }

    private long seconds() {
        Matcher time = TIME.matcher(expires);
        if (!time.matches() || Long.parseLong(time.group(1)) == 0)
            throw new ParameterException(
                    spec.commandLine(), "--expires: '" + expires + "' is no time such as 90s, 30m, 1h or 7d");
        long unit = switch (time.group(2)) {
            case "s" -> 1;
            case "m" -> 60;
            case "h" -> 3600;
            default -> 86_400;
        };
        return Long.parseLong(time.group(1)) * unit;
    }

    private String id() {
        String path = address.getRawPath() == null ? "" : address.getRawPath();
        if (CATALOGUE.matcher(path).matches()) return SignKeys.ALL;
        Matcher model = MODEL.matcher(path);
        if (!model.matches())
            throw new ParameterException(
                    spec.commandLine(),
                    "'" + address + "' is no address of a model, such as https://example.org/m/chair/");
        return URLDecoder.decode(model.group(1).replace("+", "%2B"), StandardCharsets.UTF_8);
    }

    static SignKeys keys(Path file) throws CommandFailure {
        try {
            return SignKeys.read(file);
        } catch (IOException e) {
            throw new CommandFailure(file, e);
        }
    }
}
