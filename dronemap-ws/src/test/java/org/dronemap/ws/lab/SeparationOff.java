package org.dronemap.ws.lab;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Proxy;
import java.time.Duration;
import org.dronemap.core.time.Time;
import org.dronemap.core.time.Worker;

/** Time in which the thread never runs that keeps drones apart: what flights are without it. */
final class SeparationOff {
    private static final String THREAD = "separation";

    private SeparationOff() {}

    static Time in(Time time) {
        return (Time) Proxy.newProxyInstance(
                Time.class.getClassLoader(), new Class<?>[] {Time.class}, (proxy, method, arguments) -> {
                    if (method.getName().equals("worker") && THREAD.equals(arguments[0])) {
                        return idle();
                    }
                    try {
                        return method.invoke(time, arguments);
                    } catch (InvocationTargetException e) {
                        throw e.getCause();
                    }
                });
    }

    private static Worker idle() {
        return (Worker) Proxy.newProxyInstance(
                Worker.class.getClassLoader(),
                new Class<?>[] {Worker.class},
                (proxy, method, arguments) -> method.getReturnType() == Duration.class ? Duration.ZERO : null);
    }
}
