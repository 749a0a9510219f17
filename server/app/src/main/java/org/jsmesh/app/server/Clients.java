package org.jsmesh.app.server;

import java.net.Inet6Address;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.SocketAddress;
import java.net.UnknownHostException;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.ConcurrentHashMap;
import org.eclipse.jetty.util.InetAddressSet;

/**
 * The clients that have a connection or a request now, by address. Behind a trusted proxy, the address is the one that
 * the proxy names. Thread-safe.
 */
public final class Clients {
    private static final int NETWORK_BYTES = 8;
    private static final int LONGEST_ADDRESS = 45;

    private final ConcurrentHashMap<String, Client> byAddress = new ConcurrentHashMap<>();
    private final InetAddressSet proxies = new InetAddressSet();
    private final boolean anyProxy;

    /** @param trusted addresses, ranges or networks such as {@code 10.0.0.0/8} of trusted proxies */
    public Clients(List<String> trusted) {
        anyProxy = !trusted.isEmpty();
        for (String proxy : trusted) proxies.add(proxy);
    }

    boolean isProxy(SocketAddress address) {
        return anyProxy && address instanceof InetSocketAddress inet && proxies.test(inet.getAddress());
    }

    /** The client behind a connection, held until it is released. */
    Client connect(SocketAddress address) {
        return hold(text(address), 1);
    }

    /** @param connections 1 for a connection, 0 for a request */
    private Client hold(String address, int connections) {
        return byAddress.compute(address, (key, known) -> {
            Client client = known == null ? new Client(key) : known;
            client.holders++;
            client.connections += connections;
            return client;
        });
    }

    void disconnect(Client client) {
        release(client, 1);
    }

    private void release(Client client, int connections) {
        byAddress.computeIfPresent(client.address(), (key, known) -> {
            known.connections -= connections;
            return --known.holders == 0 ? null : known;
        });
    }

    /** The client that a trusted proxy names, held until it is released; null when it names none. */
    Client forwarded(String field) {
        String address = field == null ? null : lastUntrusted(field);
        return address == null ? null : hold(address, 0);
    }

    void release(Client client) {
        release(client, 0);
    }

    /**
     * Each proxy appends the address that asked it. Anybody may have written what stands before the first address that
     * is not trusted.
     */
    private String lastUntrusted(String field) {
        String found = null;
        String[] hops = field.split(",");
        for (int i = hops.length - 1; i >= 0; i--) {
            InetAddress address = parse(hops[i].strip());
            if (address == null) break;
            found = text(address);
            if (!proxies.test(address)) break;
        }
        return found;
    }

    /** Only literal addresses, because a name would be looked up. */
    private static InetAddress parse(String text) {
        String plain = text.startsWith("[") && text.endsWith("]") ? text.substring(1, text.length() - 1) : text;
        boolean literal = plain.matches("\\d{1,3}(\\.\\d{1,3}){3}|[0-9A-Fa-f:.]*:[0-9A-Fa-f:.]*");
        if (!literal || plain.length() > LONGEST_ADDRESS) return null;
        try {
            return InetAddress.getByName(plain);
        } catch (UnknownHostException e) {
            return null;
        }
    }

    private static String text(SocketAddress address) {
        return address instanceof InetSocketAddress inet && inet.getAddress() != null
                ? text(inet.getAddress())
                : String.valueOf(address);
    }

    /** One household or machine has a whole IPv6 network of 64 bits. */
    private static String text(InetAddress address) {
        if (!(address instanceof Inet6Address)) return address.getHostAddress();
        byte[] bytes = address.getAddress();
        Arrays.fill(bytes, NETWORK_BYTES, bytes.length, (byte) 0);
        try {
            return InetAddress.getByAddress(bytes).getHostAddress() + "/64";
        } catch (UnknownHostException e) {
            throw new IllegalStateException(e);
        }
    }

    int size() {
        return byAddress.size();
    }
}
