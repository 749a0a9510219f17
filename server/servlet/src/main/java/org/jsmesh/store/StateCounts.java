package org.jsmesh.store;

import java.util.concurrent.atomic.AtomicIntegerArray;
import java.util.function.Consumer;
import org.jsmesh.store.ModelStatus.State;

/** How many models are in each state, kept by steps so that nobody needs to look at all. Thread-safe. */
final class StateCounts {
    private final AtomicIntegerArray counts = new AtomicIntegerArray(State.values().length);
    private volatile Consumer<String> listener = id -> {};

    /** @param told of the id of a model after each change of its state, on any thread */
    void listen(Consumer<String> told) {
        listener = told;
    }

    /** The number of models in a state other than {@link State#NEW}, which is that of all others. */
    int count(State state) {
        return counts.get(state.ordinal());
    }

    /** A model that begins to be prepared. */
    Counted begin(String id) {
        Counted counted = new Counted(id);
        counted.become(State.PREPARING);
        return counted;
    }

    /** One model that is counted in at most one state. */
    final class Counted {
        private final String id;
        private State state = State.NEW;
        private boolean ended;

        private Counted(String id) {
            this.id = id;
        }

        void become(State next) {
            step(next, false);
        }

        /** The model is gone, or is prepared anew and counted by another. */
        void end() {
            step(State.NEW, true);
        }

        private void step(State next, boolean isEnd) {
            synchronized (this) {
                if (ended) return;
                ended = isEnd;
                if (state == next) return;
                if (state != State.NEW) counts.decrementAndGet(state.ordinal());
                if (next != State.NEW) counts.incrementAndGet(next.ordinal());
                state = next;
            }
            listener.accept(id);
        }
    }
}
