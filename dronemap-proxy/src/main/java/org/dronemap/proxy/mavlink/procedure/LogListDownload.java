package org.dronemap.proxy.mavlink.procedure;

import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.IntStream;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.VehicleLog;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.LogEntry;
import org.dronemap.mavlink.message.LogRequestList;
import org.jspecify.annotations.Nullable;

/**
 * Downloads the list of a vehicle's onboard logs, and asks again for entries that did not arrive. A number that is not
 * told though later ones are was deleted, and is not waited for. Never asks for 0 to 0, of which some autopilots never
 * recover.
 */
public final class LogListDownload implements Exchange {
    private static final int LAST = 0xFFFF;
    private static final long IDLE_NANOS = 1_000_000_000L;
    private static final int VAIN = 4;
    private static final int MOST_NAMED = 5;

    private final MavlinkTarget target;
    private final ExchangeObserver observer;
    private final TransferTimeout patience = new TransferTimeout();
    private final SortedMap<Integer, VehicleLog> found = new TreeMap<>();
    private final Map<Integer, Integer> askedInVain = new HashMap<>();
    private RetrySchedule pace = new RetrySchedule(0, 0, 0);
    private int count;
    private int last = -1;
    private int newest = -1;
    private int begun;
    private int askedFrom;
    private int answeredUpTo = -1;
    private boolean lookedAgain;
    private int tries;
    private long lastSentNanos;
    private @Nullable Outcome outcome;

    public LogListDownload(MavlinkTarget target, ExchangeObserver observer) {
        this.target = target;
        this.observer = observer;
    }

    /** In the order of their numbers. */
    public List<VehicleLog> logs() {
        return new ArrayList<>(found.values());
    }

    /** Which numbers the vehicle counts among its logs and does not list, as a sentence; empty when it lists all. */
    public Optional<String> incomplete() {
        if (found.size() >= count) {
            return Optional.empty();
        }
        List<Integer> missing = missing(true);
        List<String> named =
                missing.stream().limit(MOST_NAMED).map(String::valueOf).toList();
        int more = missing.size() - named.size();
        return Optional.of("The vehicle says that it keeps " + count + " logs and lists " + found.size()
                + " of them; it does not list number " + String.join(", ", named)
                + (more > 0 ? " and " + more + " more" : "") + ", which may have been deleted.");
    }

    @Override
    public void start(long nowNanos) {
        pace = RetrySchedule.of(target.roundTrip(), 0);
        patience.begin(nowNanos);
        ask(0, nowNanos);
    }

    private void ask(int from, long nowNanos) {
        int until = last < 0 ? LAST : Math.max(1, last);
        target.send(new LogRequestList(target.systemId(), target.componentId(), from, until));
        askedFrom = from;
        answeredUpTo = -1;
        patience.asked(nowNanos);
        tries++;
        lastSentNanos = nowNanos;
    }

    @Override
    public void received(Frame frame, long nowNanos) {
        if (outcome != null) {
            return;
        }
        patience.received(nowNanos);
        if (frame.messageId() == LogEntry.ID) {
            entryReceived(LogEntry.decode(frame), nowNanos);
        }
    }

    private void entryReceived(LogEntry entry, long nowNanos) {
        if (entry.numLogs() == 0) {
            outcome = new Outcome.Succeeded();
            return;
        }
        begun += newest < 0 ? 0 : Math.max(0, entry.lastLogNum() - newest);
        newest = Math.max(newest, entry.lastLogNum());
        count = entry.numLogs();
        last = Math.max(newest, entry.id());
        answeredUpTo = Math.max(answeredUpTo, entry.id());
        Instant at = entry.timeUtc() == 0 ? null : Instant.ofEpochSecond(entry.timeUtc());
        if (found.put(entry.id(), new VehicleLog(entry.id(), at, entry.size())) == null) {
            tries = 0;
            patience.progressed(nowNanos);
            observer.progress(Math.min(found.size(), count), count);
        }
        // Some count less than they list: only for those that were begun meanwhile the oldest went.
        if (found.size() >= count + begun && found.lastKey() >= last) {
            for (; begun > 0 && found.size() > count; begun--) {
                found.remove(found.firstKey());
            }
            outcome = new Outcome.Succeeded();
        }
    }

    @Override
    public void advance(long nowNanos) {
        long quiet =
                Math.min(nowNanos - lastSentNanos, tries == 0 ? patience.sinceNewsNanos(nowNanos) : Long.MAX_VALUE);
        if (outcome == null && quiet >= Math.max(IDLE_NANOS, pace.pauseNanos(tries))) {
            outcome = patience.end(nowNanos);
            if (outcome != null && !found.isEmpty() && !patience.isBrokenOff(nowNanos)) {
                outcome = new Outcome.Succeeded();
            }
            if (outcome == null) {
                goOn(nowNanos);
            }
        }
    }

    private void goOn(long nowNanos) {
        for (int number : missing(true)) {
            if (number >= askedFrom && number < answeredUpTo) {
                askedInVain.merge(number, 1, Integer::sum);
            }
        }
        List<Integer> missing = missing(false);
        if (!missing.isEmpty() || found.isEmpty()) {
            ask(missing.isEmpty() ? 0 : missing.get(0), nowNanos);
        } else if (!lookedAgain) {
            // Where numbers are left out, the first one may be a smaller one than the count tells.
            lookedAgain = true;
            ask(0, nowNanos);
        } else {
            outcome = new Outcome.Succeeded();
        }
    }

    /** {@code gone}: with those that were asked for so often that they are not there. */
    private List<Integer> missing(boolean gone) {
        return IntStream.rangeClosed(Math.max(0, last - count + 1), last)
                .filter(number -> !found.containsKey(number))
                .filter(number -> gone || askedInVain.getOrDefault(number, 0) < VAIN)
                .boxed()
                .toList();
    }

    @Override
    public @Nullable Outcome outcome() {
        return outcome;
    }
}
