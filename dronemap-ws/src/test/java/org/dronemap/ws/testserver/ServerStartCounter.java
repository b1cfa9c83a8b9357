package org.dronemap.ws.testserver;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/** Counts the servers that this JVM has started, and lets nobody start one who is not listed in {@link DedicatedServers}. */
final class ServerStartCounter {
    private static final Map<String, Integer> BY_CLASS = new ConcurrentHashMap<>();

    private ServerStartCounter() {}

    /** Called by what starts a server, before it does. */
    static void count() {
        String starter = StackWalker.getInstance(StackWalker.Option.RETAIN_CLASS_REFERENCE)
                .walk(frames -> frames.map(StackWalker.StackFrame::getDeclaringClass)
                        .filter(frame -> frame != ServerStartCounter.class && frame != TestServer.class)
                        .findFirst()
                        .orElseThrow())
                .getSimpleName();
        int started = BY_CLASS.merge(starter, 1, Integer::sum);
        if (started > DedicatedServers.allowedTo(starter)) {
            throw new IllegalStateException(
                    starter + " starts " + started + " servers, and may start " + DedicatedServers.allowedTo(starter)
                            + ": share the one of SharedServer, or give a reason in DedicatedServers");
        }
        int all = BY_CLASS.values().stream().mapToInt(Integer::intValue).sum();
        System.out.println("Server " + all + " of this test JVM starts, for " + starter + ".");
    }
}
