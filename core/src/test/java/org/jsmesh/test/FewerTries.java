package org.jsmesh.test;

import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import net.jqwik.api.lifecycle.AroundTryHook;
import net.jqwik.api.lifecycle.Lifespan;
import net.jqwik.api.lifecycle.PropagationMode;
import net.jqwik.api.lifecycle.Store;
import net.jqwik.api.lifecycle.TryExecutionResult;
import net.jqwik.api.lifecycle.TryExecutor;
import net.jqwik.api.lifecycle.TryLifecycleContext;

/**
 * In the fast set, tries of a property beyond the first {@value #FAST_TRIES} pass without being run. These are the same
 * as the first ones of the full set.
 */
public final class FewerTries implements AroundTryHook {
    private static final int FAST_TRIES = 30;

    /** To the properties of the class that has this hook. */
    @Override
    public PropagationMode propagateTo() {
        return PropagationMode.ALL_DESCENDANTS;
    }

    @Override
    public TryExecutionResult aroundTry(TryLifecycleContext context, TryExecutor aTry, List<Object> parameters) {
        Store<AtomicInteger> tries = Store.getOrCreate(FewerTries.class, Lifespan.PROPERTY, () -> new AtomicInteger());
        if (FastSet.isOn() && tries.get().incrementAndGet() > FAST_TRIES) return TryExecutionResult.satisfied();
        return aTry.execute(parameters);
    }
}
