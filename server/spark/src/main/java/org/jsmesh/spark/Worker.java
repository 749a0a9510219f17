package org.jsmesh.spark;

import java.io.IOException;
import java.util.HashMap;
import java.util.Map;
import org.jsmesh.memory.MemoryAdmission;
import org.jsmesh.objects.ObjectStore;
import org.jsmesh.objects.ObjectStores;

/** What the tasks in one executor share as long as its process lives: stores, and the gate before its heap. */
final class Worker {
    /** Of the heap; Spark takes as much from it before it divides the rest. */
    private static final long SPARKS_BYTES = 300L << 20;

    private static final double LEAST_SHARE = .5;
    private static final Map<String, ObjectStore> STORES = new HashMap<>();
    private static final MemoryAdmission GATE = new MemoryAdmission(room());

    private Worker() {}

    /** {@return the store of an address; opened once, and open until the process ends} */
    static ObjectStore store(String address) throws IOException {
        synchronized (STORES) {
            ObjectStore store = STORES.get(address);
            if (store == null) {
                store = ObjectStores.open(address);
                STORES.put(address, store);
            }
            return store;
        }
    }

    static MemoryAdmission gate() {
        return GATE;
    }

    private static long room() {
        long heap = Runtime.getRuntime().maxMemory();
        return Math.max(heap - SPARKS_BYTES, (long) (LEAST_SHARE * heap));
    }
}
