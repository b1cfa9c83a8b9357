package org.dronemap.ws.testserver;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Proxy;
import java.sql.SQLException;
import java.sql.SQLTransientConnectionException;
import java.util.Set;
import java.util.concurrent.atomic.AtomicInteger;
import org.dronemap.store.StoreException;

/**
 * Before stores: while it is off, each call fails as one to a store that cannot be reached; while it is full, each that
 * would change something does, as PostgreSQL says it.
 */
public final class StoreFaultSwitch {
    private static final Set<Class<?>> ANSWERS_OF_CHANGES = Set.of(void.class, boolean.class);

    private final AtomicInteger refused = new AtomicInteger();
    private volatile boolean off;
    private volatile boolean full;

    <T> T before(Class<T> port, T store) {
        return port.cast(Proxy.newProxyInstance(
                port.getClassLoader(), new Class<?>[] {port}, (proxy, method, given) -> {
                    if (off) {
                        throw StoreException.passing(
                                "The database cannot be reached: it is switched off",
                                new SQLTransientConnectionException("switched off"));
                    }
                    if (full && ANSWERS_OF_CHANGES.contains(method.getReturnType())) {
                        noteRefusal();
                        throw StoreException.passing(
                                "The disk of the database is full: no space left",
                                new SQLException("could not extend file", "53100"));
                    }
                    try {
                        return method.invoke(store, given);
                    } catch (InvocationTargetException e) {
                        throw e.getCause();
                    }
                }));
    }

    /** What is written for a call while it waits; drones and operations are written down by threads of their own. */
    private void noteRefusal() {
        if (Thread.currentThread().getName().startsWith("http-")) {
            refused.incrementAndGet();
        }
    }

    /** From now on nothing is reached. */
    public void off() {
        off = true;
    }

    /** From now on nothing can be changed. */
    public void full() {
        full = true;
    }

    /** From now on all is reached again, and there is room. */
    public void on() {
        off = false;
        full = false;
    }

    /** How many changes of calls found no room so far. */
    public int refused() {
        return refused.get();
    }
}
