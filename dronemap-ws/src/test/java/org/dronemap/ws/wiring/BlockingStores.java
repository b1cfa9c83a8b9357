package org.dronemap.ws.wiring;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.dronemap.store.Stores;

/** Stores of which one keeps whoever asks it that waiting, as a database that is slow to answer does. */
final class BlockingStores {
    private static final long LONGEST_SECONDS = 60;

    private final Stores stores;
    private final String held;
    private final CountDownLatch asked = new CountDownLatch(1);
    private final CountDownLatch released = new CountDownLatch(1);

    /** {@code held}: a store and its method, as in {@code ZoneStore.zones}. */
    BlockingStores(Stores stores, String held) {
        this.stores = stores;
        this.held = held;
    }

    Stores stores() {
        return before(Stores.class, stores, true);
    }

    private <T> T before(Class<T> port, T store, boolean all) {
        return port.cast(Proxy.newProxyInstance(
                port.getClassLoader(),
                new Class<?>[] {port},
                (proxy, method, given) -> answer(store, method, given, all)));
    }

    /** Of all stores each one, of one store what it answers. */
    private Object answer(Object store, Method method, Object[] given, boolean all) throws Throwable {
        String name = method.getDeclaringClass().getSimpleName() + "." + method.getName();
        if (name.equals(held)) {
            asked.countDown();
            if (!released.await(LONGEST_SECONDS, TimeUnit.SECONDS)) {
                throw new IllegalStateException("nobody released " + held);
            }
        }
        Object answer;
        try {
            answer = method.invoke(store, given);
        } catch (InvocationTargetException e) {
            throw e.getCause();
        }
        return all && method.getReturnType().getSimpleName().endsWith("Store")
                ? held(method.getReturnType(), answer)
                : answer;
    }

    private <T> T held(Class<T> port, Object store) {
        return before(port, port.cast(store), false);
    }

    /** Until somebody waits for it. */
    void awaitAsked() throws InterruptedException {
        if (!asked.await(LONGEST_SECONDS, TimeUnit.SECONDS)) {
            throw new AssertionError("nobody asks for " + held);
        }
    }

    void release() {
        released.countDown();
    }
}
