package org.jsmesh.upload;

import java.util.LinkedHashMap;
import java.util.Map;

/** The states of the models that were sent last; the oldest are forgotten. Thread-safe. */
final class UploadStatuses {
    private static final int MOST = 1000;

    private record Noted(Ticket ticket, UploadStatus status) {}

    private final Map<String, Noted> byId = new LinkedHashMap<>();

    synchronized UploadStatus of(String id) {
        Noted noted = byId.get(id);
        return noted == null ? null : noted.status();
    }

    /** A model waits for its turn, and what is noted of an earlier one under its id counts no more. */
    synchronized void begin(Ticket ticket) {
        byId.remove(ticket.id());
        note(ticket, UploadStatus.queued(ticket.id()));
    }

    /** Unless the model has come to its end, or was sent again meanwhile; then the status of the later one counts. */
    synchronized void note(Ticket ticket, UploadStatus status) {
        Noted before = byId.get(status.id());
        if (before != null
                && (!before.ticket().equals(ticket) || before.status().isOver())) return;
        byId.remove(status.id());
        byId.put(status.id(), new Noted(ticket, status));
        if (byId.size() > MOST) byId.remove(byId.keySet().iterator().next());
    }

    /** Of a model that was removed while it was encoded. */
    synchronized void forget(Ticket ticket) {
        Noted noted = byId.get(ticket.id());
        if (noted != null && noted.ticket().equals(ticket)) byId.remove(ticket.id());
    }

    synchronized boolean forget(String id) {
        return byId.remove(id) != null;
    }
}
