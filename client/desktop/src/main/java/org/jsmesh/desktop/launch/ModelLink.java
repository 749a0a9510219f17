package org.jsmesh.desktop.launch;

import java.net.URI;
import java.net.URISyntaxException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;

/**
 * Links that start the viewer: {@code jsm:} in front of the address of a model, such as
 * {@code jsm:https://example.org/m/chair/manifest.json}. {@code jsm://example.org/m/chair/} stands for
 * {@code https://example.org/m/chair/}. Anybody may write a link, so it leads to addresses of http and https alone,
 * never to a file of this machine.
 */
public final class ModelLink {
    static final String SCHEME = "jsm";

    private static final String PREFIX = SCHEME + ":";
    private static final String FILE_PREFIX = "file:";

    private ModelLink() {}

    /**
     * Refuses what stands beside a link: where a system puts a link into a command line without care, what somebody
     * wrote behind it would be opened, too.
     *
     * @param arguments of the command: links, addresses or paths
     * @throws IllegalArgumentException when there is a link among several
     */
    public static void requireAlone(List<String> arguments) {
        if (arguments.size() > 1 && arguments.stream().anyMatch(argument -> begins(argument, PREFIX)))
            throw new IllegalArgumentException("a jsm: link stands alone: open one at a time, and nothing beside it");
    }

    /**
     * What an argument of the command means.
     *
     * @param argument a link, an address or a path
     * @return an address, or a path as file managers may have written it as {@code file:} address
     * @throws IllegalArgumentException when a link leads nowhere where it may lead
     */
    public static String location(String argument) {
        if (begins(argument, PREFIX)) return address(argument);
        return begins(argument, FILE_PREFIX) ? path(argument) : argument;
    }

    private static boolean begins(String text, String prefix) {
        return text.regionMatches(true, 0, prefix, 0, prefix.length());
    }

    private static String address(String link) {
        String rest = link.substring(PREFIX.length());
        try {
            URI address = new URI(rest.startsWith("//") ? "https:" + rest : rest);
            String scheme = String.valueOf(address.getScheme()).toLowerCase(Locale.ROOT);
            boolean mayLead = scheme.equals("http") || scheme.equals("https");
            if (mayLead && address.getHost() != null && address.getRawUserInfo() == null) return address.toString();
        } catch (URISyntaxException e) {
            throw wrong(link, e);
        }
        throw wrong(link, null);
    }

    private static IllegalArgumentException wrong(String link, Exception cause) {
        return new IllegalArgumentException(
                link + " leads to no address of http or https: write jsm: in front of the address of a model, such as "
                        + "jsm:https://example.org/m/chair/manifest.json",
                cause);
    }

    private static String path(String address) {
        try {
            return Path.of(new URI(address)).toString();
        } catch (URISyntaxException | IllegalArgumentException e) {
            throw new IllegalArgumentException(address + " is no address of a file: give its path", e);
        }
    }
}
