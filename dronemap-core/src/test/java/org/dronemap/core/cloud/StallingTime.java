package org.dronemap.core.cloud;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Proxy;
import java.time.Duration;
import java.util.concurrent.atomic.AtomicLong;
import org.dronemap.core.time.Time;

/** A time that goes on while this process stands still, as the machine's own does when a process is stopped. */
final class StallingTime {
    private final AtomicLong stalledNanos = new AtomicLong();
    private final Time time;

    StallingTime(Time stepped) {
        time = (Time) Proxy.newProxyInstance(
                Time.class.getClassLoader(), new Class<?>[] {Time.class}, (proxy, method, given) -> {
                    try {
                        Object answer = method.invoke(stepped, given);
                        return method.getName().equals("nanos")
                                ? (Object) ((Long) answer + stalledNanos.get())
                                : answer;
                    } catch (InvocationTargetException e) {
                        throw e.getCause();
                    }
                });
    }

    Time time() {
        return time;
    }

    void stall(Duration length) {
        stalledNanos.addAndGet(length.toNanos());
    }
}
