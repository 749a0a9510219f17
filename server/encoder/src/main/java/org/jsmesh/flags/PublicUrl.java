package org.jsmesh.flags;

import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;

/** The address under which visitors find what is served. */
public final class PublicUrl {
    private PublicUrl() {}

    /**
     * Reads the value of {@code --public-url}.
     *
     * @param spec of the command, for the message
     * @param given address, or null
     * @return with a slash at its end, or null
     * @throws ParameterException when it is no address of HTTP
     */
    public static String of(CommandSpec spec, String given) {
        if (given == null) return null;
        String address = given.endsWith("/") ? given : given + "/";
        if (address.matches("https?://[^\\s\"'<>?#]+/")) return address;
        throw new ParameterException(
                spec.commandLine(), "--public-url " + given + " is no address such as https://example.org/models/");
    }
}
