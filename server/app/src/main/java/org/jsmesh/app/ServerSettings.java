package org.jsmesh.app;

import java.nio.file.Path;

/**
 * How to serve.
 *
 * @param host name or address to listen at
 * @param port to listen at; 0 chooses a free one
 * @param keystore PKCS #12 or JKS file with the server's certificate, or null for plain HTTP
 * @param keystorePassword of the keystore, or null
 */
record ServerSettings(String host, int port, Path keystore, String keystorePassword) {
    ServerSettings {
        if (port < 0 || port > 65535)
            throw new IllegalArgumentException("port " + port + " is not between 0 and 65535");
    }

    /** Plain HTTP for programs of this machine, at a free port. */
    static ServerSettings defaults() {
        return new ServerSettings("127.0.0.1", 0, null, null);
    }

    ServerSettings withAddress(String newHost, int newPort) {
        return new ServerSettings(newHost, newPort, keystore, keystorePassword);
    }

    ServerSettings withKeystore(Path file, String password) {
        return new ServerSettings(host, port, file, password);
    }
}
