package org.jsmesh.spark;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.util.HashMap;
import java.util.Map;
import org.apache.spark.SparkConf;
import org.jsmesh.memory.MemoryAdmission;
import org.jsmesh.objects.ObjectStore;
import org.jsmesh.objects.ObjectStores;

/** What the tasks in one executor share as long as its process lives: stores, and the gate before its heap. */
final class Worker {
    /** Of the heap; Spark takes as much from it before it divides the rest. */
    private static final long SPARKS_BYTES = 300L << 20;

    private static final double LEAST_SHARE = .5;

    /** G1 needs a quarter more heap for the same models. */
    private static final double SHARE_OF_G1 = .8;

    private static final Map<String, ObjectStore> STORES = new HashMap<>();
    private static final MemoryAdmission GATE =
            new MemoryAdmission(room(Runtime.getRuntime().maxMemory(), isG1()));

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

    /** {@return bytes for models in a heap of so many} */
    static long room(long heap, boolean isG1) {
        double room = Math.max(heap - SPARKS_BYTES, LEAST_SHARE * heap);
        return (long) (isG1 ? SHARE_OF_G1 * room : room);
    }

    private static boolean isG1() {
        return ManagementFactory.getGarbageCollectorMXBeans().stream()
                .anyMatch(collector -> collector.getName().startsWith("G1"));
    }

    /** {@return cores of an executor; 0 when it gets all of its machine} */
    static int coresToTake(SparkConf conf) {
        String master = conf.get("spark.master", "");
        boolean isOne = master.startsWith("yarn") || master.startsWith("k8s");
        return conf.getInt("spark.executor.cores", isOne ? 1 : 0);
    }
}
