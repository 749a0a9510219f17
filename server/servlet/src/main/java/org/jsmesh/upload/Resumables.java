package org.jsmesh.upload;

import java.io.IOException;
import java.security.SecureRandom;
import java.time.Instant;
import java.util.Collections;
import java.util.HexFormat;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/**
 * The models that come in parts and are not whole yet, and for a while those that have become so: a sender may not have
 * heard of it. Those whose senders do not go on are removed after some time. Thread-safe.
 */
public final class Resumables {
    private static final int MOST_FINISHED = 1000;
    private static final int NAME_BYTES = 16;

    /** So many times as many as the queue holds may be unfinished, and as many as it holds of one sender. */
    private static final int SHARE = 4;

    private final UploadSettings settings;
    private final UploadQueue queue;
    private final Spool spool;
    private final Keeping keeping;
    private final SecureRandom random = new SecureRandom();
    private final Map<String, Resumable> unfinished = new ConcurrentHashMap<>();
    private final Map<String, Resumable> finished = Collections.synchronizedMap(new LinkedHashMap<>(16, .75f, false) {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(Map.Entry<String, Resumable> eldest) {
            return size() > MOST_FINISHED;
        }
    });

    Resumables(UploadSettings settings, UploadQueue queue, Spool spool, Keeping keeping) {
        this.settings = settings;
        this.queue = queue;
        this.spool = spool;
        this.keeping = keeping;
    }

    void goOn(Resumable left) {
        keeping.resume(left.ticket().sender().key(), left.id());
        unfinished.put(left.name(), left);
    }

    /**
     * Begins one.
     *
     * @param sender whose model it is
     * @param id of the model, checked
     * @param extension of the model file, or {@code zip}
     * @param length in bytes, checked
     * @param metadata what the sender says of it, one line of ASCII
     * @return the upload; null when there are too many
     * @throws QuotaException when the server keeps no more for the sender
     * @throws Upload.SpoolException when the disk does not take it, or has no room for all of it
     */
    public Resumable begin(Sender sender, String id, String extension, long length, String metadata)
            throws QuotaException, Upload.SpoolException {
        sweep();
        Ticket ticket;
        synchronized (this) {
            long own = unfinished.values().stream()
                    .filter(one -> one.ticket().sender().key().equals(sender.key()))
                    .count();
            boolean full = unfinished.size() >= SHARE * settings.queued() || own >= settings.queued();
            if (full || queue.length() >= settings.queued()) return null;
            requireRoom(length);
            String refusal = keeping.refusal(sender, id);
            if (refusal != null) throw new QuotaException(refusal);
            ticket = spool.ticket(id, sender);
            try {
                byte[] name = new byte[NAME_BYTES];
                random.nextBytes(name);
                Resumable begun = Resumable.begin(ticket, HexFormat.of().formatHex(name), length, extension, metadata);
                unfinished.put(begun.name(), begun);
                return begun;
            } catch (IOException e) {
                Spool.delete(ticket);
                keeping.gone(sender.key(), id);
                throw new Upload.SpoolException(e);
            }
        }
    }

    /** Room that is promised to others counts as taken: they would find the disk full in the midst of their models. */
    private void requireRoom(long length) throws Upload.SpoolException {
        long promised = length;
        for (Resumable other : unfinished.values()) promised += other.length() - other.offset();
        try {
            long free = spool.freeBytes();
            if (free < promised)
                throw new IOException("unfinished uploads need " + promised + " bytes, and " + free + " are free");
        } catch (IOException e) {
            throw new Upload.SpoolException(e);
        }
    }

    /**
     * Finds one.
     *
     * @param name as {@link Resumable#name()} has it, or any text
     * @return the upload, which may be whole by now; null when there is none
     */
    public Resumable find(String name) {
        sweep();
        Resumable found = unfinished.get(name);
        return found == null ? finished.get(name) : found;
    }

    /**
     * Tells until when an upload can be gone on with.
     *
     * @param upload of this server
     * @return the time; it moves with each part
     */
    public Instant expires(Resumable upload) {
        return upload.expires(settings.unfinishedMillis());
    }

    /**
     * Hands an upload that is whole to the queue. To be called by who has its turn.
     *
     * @param upload all of whose bytes are on disk
     * @throws Upload.SpoolException when the disk does not take it
     */
    public void complete(Resumable upload) throws Upload.SpoolException {
        upload.complete();
        unfinished.remove(upload.name());
        finished.put(upload.name(), upload);
        queue.take(upload.ticket());
    }

    /**
     * Removes one with all its bytes, unless it is whole. To be called by who has its turn.
     *
     * @param upload of this server
     */
    public void remove(Resumable upload) {
        if (unfinished.remove(upload.name()) == null) return;
        upload.give();
        Spool.delete(upload.ticket());
        keeping.gone(upload.ticket().sender().key(), upload.id());
    }

    /** Removes those that nobody has gone on with. */
    void sweep() {
        Instant now = Instant.now();
        for (Resumable upload : unfinished.values()) {
            if (now.isBefore(expires(upload)) || !upload.begin()) continue;
            try {
                remove(upload);
            } finally {
                upload.end();
            }
        }
    }
}
