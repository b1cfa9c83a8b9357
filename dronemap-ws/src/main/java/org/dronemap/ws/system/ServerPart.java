package org.dronemap.ws.system;

import java.time.Duration;
import java.util.Optional;
import java.util.function.Supplier;

/**
 * A part of the server, such as a thread or the endpoints for vehicles, with the check whether it works.
 *
 * @param name for ever: clients go by it
 * @param trouble why it does not work now, as a sentence; empty: it does
 */
public record ServerPart(String name, Supplier<Optional<String>> trouble) {
    /** A thread that is told of when it has been at the same thing for longer than that. */
    public static ServerPart thread(String name, Duration longest, Supplier<Duration> busyFor) {
        return new ServerPart(
                name,
                () -> Optional.of(busyFor.get())
                        .filter(busy -> busy.compareTo(longest) > 0)
                        .map(busy -> "It has been at the same thing for " + busy.toSeconds() + " s."));
    }
}
