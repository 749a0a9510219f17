package org.jsmesh.app;

import java.util.List;
import org.jsmesh.app.server.Clients;
import org.jsmesh.app.server.Limits;
import org.jsmesh.app.server.ServerSettings;
import picocli.CommandLine.Option;

/** Limits for the clients of {@code jsm serve}. A mixin. */
final class LimitOptions {
    @Option(
            names = "--max-connections",
            paramLabel = "N",
            defaultValue = "8192",
            description = "Open connections; those beyond are told to come again (503). Default: ${DEFAULT-VALUE}.")
    private int connections;

    @Option(
            names = "--max-connections-per-address",
            paramLabel = "N",
            defaultValue = "1024",
            description = "Connections of one address; those beyond are closed. Default: ${DEFAULT-VALUE}.")
    private int connectionsPerAddress;

    @Option(
            names = "--max-requests-per-address",
            paramLabel = "N",
            defaultValue = "1024",
            description =
                    "Requests of one address being answered; those beyond are told to come again (503). Default: ${DEFAULT-VALUE}.")
    private int requestsPerAddress;

    @Option(
            names = "--max-request-rate",
            paramLabel = "N",
            defaultValue = "1000",
            description = {
                "Requests of one address a second, in the long run; those beyond are told to come again (429).",
                "0: no limit. Default: ${DEFAULT-VALUE}."
            })
    private int requestRate;

    @Option(
            names = "--request-burst",
            paramLabel = "N",
            defaultValue = "2000",
            description = "Requests of one address that may come at once. Default: ${DEFAULT-VALUE}.")
    private int requestBurst;

    @Option(
            names = "--max-header-bytes",
            paramLabel = "N",
            defaultValue = "8192",
            description = "Bytes of one request's address and header. Default: ${DEFAULT-VALUE}.")
    private int headerBytes;

    @Option(
            names = "--header-timeout",
            paramLabel = "T",
            defaultValue = "10s",
            description = "The header of a request must be there by then. Default: ${DEFAULT-VALUE}.")
    private Wait header;

    @Option(
            names = "--body-timeout",
            paramLabel = "T",
            defaultValue = "10s",
            description = "So long, and a second for every 1000 bytes, may the body take. Default: ${DEFAULT-VALUE}.")
    private Wait body;

    @Option(
            names = "--stall-timeout",
            paramLabel = "T",
            defaultValue = "120s",
            description = "A reader that takes less than 256 KiB in that time is dropped. Default: ${DEFAULT-VALUE}.")
    private Wait stall;

    @Option(
            names = "--idle-timeout",
            paramLabel = "T",
            defaultValue = "120s",
            description = "A connection without requests is closed then. Default: ${DEFAULT-VALUE}.")
    private Wait idle;

    @Option(
            names = "--trust-proxy",
            paramLabel = "ADDRESS",
            split = ",",
            description = {
                "Proxies in front: X-Forwarded-For of these addresses (10.0.0.1, 10.0.0.0/8, ::1) tells whose request it is.",
                "Several with commas between. Default: none is believed."
            })
    private List<String> proxies;

    /** @throws IllegalArgumentException that names a wrong option */
    ServerSettings apply(ServerSettings settings) {
        Limits limits = Limits.defaults()
                .withConnections(connections, connectionsPerAddress)
                .withRequestsPerAddress(requestsPerAddress)
                .withRequestRate(requestRate, requestBurst)
                .withHeaderBytes(headerBytes)
                .withMillis(header.millis(), body.millis(), stall.millis(), idle.millis());
        List<String> trusted = proxies == null ? List.of() : proxies;
        checkAddresses(trusted);
        return settings.withLimits(limits).withProxies(trusted);
    }

    private static void checkAddresses(List<String> trusted) {
        try {
            new Clients(trusted);
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException("--trust-proxy: " + e.getMessage(), e);
        }
    }
}
