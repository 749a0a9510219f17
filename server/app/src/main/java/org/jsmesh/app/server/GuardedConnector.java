package org.jsmesh.app.server;

import java.util.Collection;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.eclipse.jetty.io.EndPoint;
import org.eclipse.jetty.server.ConnectionFactory;
import org.eclipse.jetty.server.Server;
import org.eclipse.jetty.server.ServerConnector;

/** A connector that knows the connected clients and closes connections beyond the limits. */
final class GuardedConnector extends ServerConnector {
    /** Connections beyond the limit that are still kept, so that they can be answered. */
    private static final int TOLD = 256;

    private final Limits limits;
    private final Clients clients;
    private final Map<EndPoint, Peer> peers = new ConcurrentHashMap<>();

    GuardedConnector(Server server, Limits limits, Clients clients, ConnectionFactory... factories) {
        super(server, factories);
        this.limits = limits;
        this.clients = clients;
    }

    /** Whoever is connected. */
    Collection<Peer> peers() {
        return peers.values();
    }

    int connections() {
        return peers.size();
    }

    /** The peer of a request; null when it is gone by now. */
    Peer peer(EndPoint endPoint) {
        EndPoint socket = endPoint;
        while (socket instanceof EndPoint.Wrapper wrapper) socket = wrapper.unwrap();
        return peers.get(socket);
    }

    @Override
    protected void onEndPointOpened(EndPoint endPoint) {
        super.onEndPointOpened(endPoint);
        int open = peers.size();
        Client client = clients.connect(endPoint.getRemoteSocketAddress());
        boolean proxy = clients.isProxy(endPoint.getRemoteSocketAddress());
        peers.put(endPoint, new Peer(endPoint, client, proxy, open >= limits.connections()));
        boolean tooMany = !proxy && client.connections > limits.connectionsPerAddress();
        if (tooMany || open >= limits.connections() + TOLD) endPoint.close();
    }

    @Override
    protected void onEndPointClosed(EndPoint endPoint) {
        Peer peer = peers.remove(endPoint);
        if (peer != null) clients.disconnect(peer.client());
        super.onEndPointClosed(endPoint);
    }
}
