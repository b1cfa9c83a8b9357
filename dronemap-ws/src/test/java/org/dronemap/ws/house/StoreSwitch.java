package org.dronemap.ws.house;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Proxy;
import java.sql.SQLTransientConnectionException;
import org.dronemap.store.StoreException;

/** Before stores: while it is off, each call fails as one to a store that cannot be reached. */
public final class StoreSwitch {
    private volatile boolean off;

    <T> T before(Class<T> port, T store) {
        return port.cast(Proxy.newProxyInstance(
                port.getClassLoader(), new Class<?>[] {port}, (proxy, method, given) -> {
                    if (off) {
                        throw StoreException.passing(
                                "The database cannot be reached: it is switched off",
                                new SQLTransientConnectionException("switched off"));
                    }
                    try {
                        return method.invoke(store, given);
                    } catch (InvocationTargetException e) {
                        throw e.getCause();
                    }
                }));
    }

    /** From now on nothing is reached. */
    public void off() {
        off = true;
    }

    /** From now on all is reached again. */
    public void on() {
        off = false;
    }
}
