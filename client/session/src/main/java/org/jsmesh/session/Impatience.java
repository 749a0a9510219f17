package org.jsmesh.session;

import java.util.function.BooleanSupplier;

/** Whether a user wants a pause to end now. Thread-safe. */
final class Impatience implements BooleanSupplier {
    private volatile boolean isShown;

    /** A pause begins. */
    void forget() {
        isShown = false;
    }

    void show() {
        isShown = true;
    }

    @Override
    public boolean getAsBoolean() {
        return isShown;
    }
}
