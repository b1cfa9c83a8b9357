package org.dronemap.cognitive.follow;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.Comparator;
import java.util.Deque;
import org.jspecify.annotations.Nullable;

/**
 * Converts time stamps of a phone to the cloud's clock, while drones follow that phone. A message that went quickly
 * shows best how far the clocks are apart; of the last minute that one counts. Owned by one thread.
 */
public final class PhoneClockOffset {
    private static final Duration REMEMBERED = Duration.ofMinutes(1);
    private static final int MOST = 240;
    /** Of the quickest message of a phone that does not say how long its messages take. */
    private static final Duration USUAL_WAY = Duration.ofMillis(50);

    private final Deque<OffsetSample> exchanges = new ArrayDeque<>();

    /** {@code slowness}: by what it is compared with others. */
    private record OffsetSample(Instant receivedAt, Duration ahead, Duration slowness) {}

    /**
     * A message of the phone.
     *
     * @param sent by the phone's clock
     * @param heard by the cloud's
     * @param roundTrip from sending one to its answer, as the phone measured it lately; null: it did not
     */
    public void messageReceived(Instant sent, Instant heard, @Nullable Duration roundTrip) {
        OffsetSample before = exchanges.peekLast();
        if (before != null && before.receivedAt().equals(heard)) {
            // Several positions in one message.
            return;
        }
        Duration apart = Duration.between(sent, heard);
        Duration way = roundTrip == null ? USUAL_WAY : roundTrip.dividedBy(2);
        // What says how long it took is worth more than what does not.
        Duration slowness = roundTrip == null ? Duration.ofDays(10_000).plus(apart) : roundTrip;
        exchanges.addLast(new OffsetSample(heard, apart.minus(way), slowness));
        while (exchanges.size() > MOST
                || Duration.between(exchanges.getFirst().receivedAt(), heard).compareTo(REMEMBERED) > 0) {
            exchanges.removeFirst();
        }
    }

    /** A time of the phone by the cloud's clock; as it is while nothing was heard. */
    public Instant toCloud(Instant phone) {
        return exchanges.stream()
                .min(Comparator.comparing(OffsetSample::slowness))
                .map(quickest -> phone.plus(quickest.ahead()))
                .orElse(phone);
    }
}
