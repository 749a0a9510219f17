package org.jsmesh.store;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.file.ClosedWatchServiceException;
import java.nio.file.Path;
import java.nio.file.StandardWatchEventKinds;
import java.nio.file.WatchEvent;
import java.nio.file.WatchKey;
import java.nio.file.WatchService;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import org.jsmesh.files.PathNames;

/**
 * Hears of changes in folders from the operating system, as far as it tells them: it watches a limited number of
 * folders, forgets changes that come too fast, and knows nothing of what other machines change in a network folder.
 * Thread-safe.
 */
final class FolderWatch implements AutoCloseable {
    private static final Logger LOG = System.getLogger(FolderWatch.class.getName());
    private static final int MOST_CHANGES = 10_000;
    private static final long QUIET_MILLIS = 50;

    private static final WatchEvent.Kind<?>[] KINDS = {
        StandardWatchEventKinds.ENTRY_CREATE, StandardWatchEventKinds.ENTRY_DELETE, StandardWatchEventKinds.ENTRY_MODIFY
    };

    private final WatchService service;
    private final Map<WatchKey, String> places = new HashMap<>();
    private final TreeMap<String, WatchKey> keys = new TreeMap<>();
    private boolean whole;
    private boolean told;

    /**
     * What has changed.
     *
     * @param places files and folders that came, changed or went
     * @param isSure false when there may be others
     */
    record Changes(Set<String> places, boolean isSure) {}

    private FolderWatch(WatchService service) {
        this.service = service;
        whole = service != null;
    }

    /** As far as the system has the means. */
    static FolderWatch of(Path source) {
        try {
            return new FolderWatch(source.getFileSystem().newWatchService());
        } catch (IOException | UnsupportedOperationException e) {
            FolderWatch none = none();
            none.tell(e);
            return none;
        }
    }

    /** Hears of nothing. */
    static FolderWatch none() {
        return new FolderWatch(null);
    }

    /** Whether all folders that were named are watched. */
    synchronized boolean isWhole() {
        return whole;
    }

    /** All folders are named anew. */
    synchronized void restart() {
        whole = service != null;
    }

    /** Watches a folder from now on, if that is possible. */
    synchronized void add(String place, Path folder) {
        if (!whole) return; // each further one would fail, too
        try {
            WatchKey key = folder.register(service, KINDS);
            // A folder that was moved keeps its key.
            String before = places.put(key, place);
            if (before != null && !before.equals(place)) keys.remove(before, key);
            WatchKey old = keys.put(place, key);
            if (old != null && old != key) cancel(old);
        } catch (IOException | ClosedWatchServiceException e) {
            whole = false;
            tell(e);
        }
    }

    /** Forgets a folder and those in it. */
    synchronized void remove(String place) {
        WatchKey own = keys.remove(place);
        if (own != null) cancel(own);
        Map<String, WatchKey> below = keys.subMap(place + '/', place + '0');
        List.copyOf(below.values()).forEach(this::cancel);
        below.clear();
    }

    private void cancel(WatchKey key) {
        places.remove(key);
        key.cancel();
    }

    private void tell(Exception reason) {
        if (!told)
            LOG.log(
                    Level.WARNING,
                    "Not every folder of models can be watched ({0}): the server looks for changes now and then. On "
                            + "Linux, fs.inotify.max_user_watches and fs.inotify.max_user_instances set the limits",
                    reason.getMessage());
        told = true;
    }

    /** Waits for changes, at most so long, and then a moment for those that come with them. */
    Changes await(long millis) throws InterruptedException {
        Set<String> changed = new LinkedHashSet<>();
        if (service == null) {
            Thread.sleep(millis);
            return new Changes(changed, true);
        }
        boolean isSure = true;
        WatchKey key = service.poll(millis, TimeUnit.MILLISECONDS);
        if (key != null) Thread.sleep(QUIET_MILLIS);
        while (key != null && changed.size() < MOST_CHANGES) {
            isSure &= collect(key, changed);
            key = service.poll();
        }
        if (key != null) isSure &= collect(key, changed);
        return new Changes(changed, isSure);
    }

    private synchronized boolean collect(WatchKey key, Set<String> changed) {
        String place = places.get(key);
        boolean isSure = true;
        for (WatchEvent<?> event : key.pollEvents()) {
            if (!(event.context() instanceof Path name)) isSure = false;
            else if (place != null && PathNames.areRepresentable(name))
                changed.add(place.isEmpty() ? name.toString() : place + '/' + name);
        }
        // A folder that is gone sends no more.
        if (!key.reset() && place != null && places.remove(key, place)) {
            keys.remove(place, key);
            if (place.isEmpty()) isSure = false;
            else changed.add(place);
        }
        return isSure;
    }

    @Override
    public void close() {
        try {
            if (service != null) service.close();
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "A watch was not closed", e);
        }
    }
}
