package org.jsmesh.webapp;

import java.lang.reflect.Proxy;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import org.jsmesh.objects.ObjectStore;
import org.jsmesh.objects.ObjectStoreProvider;

/** Opens {@code empty://} and counts what is open. */
public final class EmptyStores implements ObjectStoreProvider {
    static final AtomicInteger OPENED = new AtomicInteger();
    static final AtomicInteger CLOSED = new AtomicInteger();

    @Override
    public String scheme() {
        return "empty";
    }

    @Override
    public ObjectStore open(String address) {
        OPENED.incrementAndGet();
        Class<?>[] types = {ObjectStore.class};
        return (ObjectStore) Proxy.newProxyInstance(
                EmptyStores.class.getClassLoader(), types, (store, method, args) -> {
                    switch (method.getName()) {
                        case "address" -> {
                            return address.toString();
                        }
                        case "find" -> {
                            return Optional.empty();
                        }
                        case "close" -> {
                            CLOSED.incrementAndGet();
                            return null;
                        }
                        default -> throw new UnsupportedOperationException(method.getName());
                    }
                });
    }
}
