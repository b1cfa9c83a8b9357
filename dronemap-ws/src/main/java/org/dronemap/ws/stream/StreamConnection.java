package org.dronemap.ws.stream;

import java.util.Optional;
import java.util.function.Supplier;
import org.dronemap.core.access.Principal;

/** Connection of one client to the WebSocket stream, as handlers of requests see it. Any thread. */
public interface StreamConnection {
    /** Empty: nobody has signed in, or whoever did was shown out. */
    Optional<Principal> principal();

    /** Asks it for a sign of life, which shows that it stands. */
    void probe();

    /** When it answered a probe last. */
    long answeredNanos();

    /** Now, by the clock by which it answers. */
    long nowNanos();

    /** The one object of a type that is kept with it; made when it is first asked for, and gone when the connection is. */
    <T> T attachment(Class<T> type, Supplier<T> initial);
}
