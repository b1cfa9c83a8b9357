package org.dronemap.ws.security;

import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.dronemap.ws.reading.SecretGenerator;

/** One-use tickets that carry a sign-in from the page to the stream's port within 30 s. Any thread. */
public final class StreamTickets {
    private static final Duration LENGTH = Duration.ofSeconds(30);
    private static final int MOST = 10_000;

    private final SecretGenerator secrets;
    private final Clock clock;

    /** Guarded by this; the eldest goes when it is full. */
    private final Map<String, Ticket> tickets = new LinkedHashMap<>() {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(Map.Entry<String, Ticket> eldest) {
            return size() > MOST;
        }
    };

    private record Ticket(AuthenticatedCaller caller, Instant until) {}

    public StreamTickets(SecretGenerator secrets, Clock clock) {
        this.secrets = secrets;
        this.clock = clock;
    }

    public synchronized String issue(AuthenticatedCaller caller) {
        Instant now = clock.instant();
        tickets.values().removeIf(ticket -> !ticket.until().isAfter(now));
        String token = secrets.token();
        tickets.put(SecretGenerator.hash(token), new Ticket(caller, now.plus(LENGTH)));
        return token;
    }

    /** Empty when there is no such ticket, or it was used, or it is too old. */
    public synchronized Optional<AuthenticatedCaller> redeem(String token) {
        return Optional.ofNullable(tickets.remove(SecretGenerator.hash(token)))
                .filter(ticket -> ticket.until().isAfter(clock.instant()))
                .map(Ticket::caller);
    }
}
