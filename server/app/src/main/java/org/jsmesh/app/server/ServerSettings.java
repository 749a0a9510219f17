package org.jsmesh.app.server;

import java.nio.file.Path;
import java.util.List;
import org.jsmesh.secret.SignKeys;
import org.jsmesh.servlet.ServletSettings;
import org.jsmesh.servlet.ViewerJar;

/**
 * How to serve.
 *
 * @param host name or address to listen at
 * @param port to listen at; 0 chooses a free one
 * @param keystore PKCS #12 or JKS file with the server's certificate, or null for plain HTTP
 * @param keystorePassword of the keystore, or null
 * @param limits for clients
 * @param proxies addresses, ranges or networks of trusted proxies
 * @param servlet how the application answers
 * @param graceMillis time for running transfers to end when the server stops
 */
public record ServerSettings(
        String host,
        int port,
        Path keystore,
        String keystorePassword,
        Limits limits,
        List<String> proxies,
        ServletSettings servlet,
        long graceMillis) {
    public ServerSettings {
        if (port < 0 || port > 65535)
            throw new IllegalArgumentException("port " + port + " is not between 0 and 65535");
        proxies = List.copyOf(proxies);
    }

    /** Plain HTTP for programs of this machine, at a free port; stops at once. */
    public static ServerSettings defaults() {
        ServletSettings servlet = ServletSettings.defaults();
        return new ServerSettings("127.0.0.1", 0, null, null, Limits.defaults(), List.of(), servlet, 0);
    }

    public ServerSettings withAddress(String newHost, int newPort) {
        return new ServerSettings(newHost, newPort, keystore, keystorePassword, limits, proxies, servlet, graceMillis);
    }

    public ServerSettings withKeystore(Path file, String password) {
        return new ServerSettings(host, port, file, password, limits, proxies, servlet, graceMillis);
    }

    public ServerSettings withLimits(Limits newLimits) {
        return new ServerSettings(host, port, keystore, keystorePassword, newLimits, proxies, servlet, graceMillis);
    }

    public ServerSettings withProxies(List<String> trusted) {
        return new ServerSettings(host, port, keystore, keystorePassword, limits, trusted, servlet, graceMillis);
    }

    public ServerSettings withOrigins(List<String> origins) {
        return new ServerSettings(
                host, port, keystore, keystorePassword, limits, proxies, servlet.withOrigins(origins), graceMillis);
    }

    /** @param embedders origins of pages that may have the page in a frame; {@code *} for all */
    public ServerSettings withEmbedders(List<String> embedders) {
        ServletSettings changed = servlet.withEmbedders(embedders);
        return new ServerSettings(host, port, keystore, keystorePassword, limits, proxies, changed, graceMillis);
    }

    /** @param address under which visitors find the page, with a slash at its end; null to take what they asked for */
    public ServerSettings withPublicUrl(String address) {
        return new ServerSettings(
                host, port, keystore, keystorePassword, limits, proxies, servlet.withPublicUrl(address), graceMillis);
    }

    /** @param senders origins of other pages that may send models; {@code *} for all */
    public ServerSettings withSenders(List<String> senders) {
        ServletSettings changed = servlet.withSenders(senders);
        return new ServerSettings(host, port, keystore, keystorePassword, limits, proxies, changed, graceMillis);
    }

    /** @param keys that sign the addresses of models; null for models that anybody may have */
    public ServerSettings withSignKeys(SignKeys keys) {
        return new ServerSettings(
                host, port, keystore, keystorePassword, limits, proxies, servlet.withSignKeys(keys), graceMillis);
    }

    /** @param viewer that visitors start from the browser; null for none */
    public ServerSettings withViewer(ViewerJar viewer) {
        return new ServerSettings(
                host, port, keystore, keystorePassword, limits, proxies, servlet.withViewer(viewer), graceMillis);
    }

    public ServerSettings withGrace(long millis) {
        return new ServerSettings(host, port, keystore, keystorePassword, limits, proxies, servlet, millis);
    }
}
