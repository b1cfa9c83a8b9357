package org.dronemap.proxy.mavlink.procedure;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.VehicleLog;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.LogEntry;
import org.dronemap.mavlink.message.LogRequestList;
import org.jspecify.annotations.Nullable;

/**
 * Downloads the list of a vehicle's onboard logs, and asks again for entries that did not arrive. Never asks for 0 to
 * 0, of which some autopilots never recover.
 */
public final class LogListDownload implements Exchange {
    private static final int LAST = 0xFFFF;
    private static final long IDLE_NANOS = 1_000_000_000L;

    private final MavlinkTarget target;
    private final ExchangeObserver observer;
    private final TransferTimeout patience = new TransferTimeout();
    private final SortedMap<Integer, VehicleLog> found = new TreeMap<>();
    private RetrySchedule pace = new RetrySchedule(0, 0, 0);
    private int first = -1;
    private int last = -1;
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

    @Override
    public void start(long nowNanos) {
        pace = RetrySchedule.of(target.roundTrip(), 0);
        patience.begin(nowNanos);
        ask(nowNanos);
    }

    private void ask(long nowNanos) {
        int from = first;
        while (from >= 0 && from < last && found.containsKey(from)) {
            from++;
        }
        int until = last < 0 ? LAST : Math.max(1, last);
        target.send(new LogRequestList(target.systemId(), target.componentId(), Math.max(0, from), until));
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
        last = entry.lastLogNum();
        first = Math.max(0, last - entry.numLogs() + 1);
        if (entry.id() < first || entry.id() > last) {
            return;
        }
        Instant at = entry.timeUtc() == 0 ? null : Instant.ofEpochSecond(entry.timeUtc());
        if (found.put(entry.id(), new VehicleLog(entry.id(), at, entry.size())) == null) {
            tries = 0;
            patience.progressed(nowNanos);
            observer.progress(found.size(), entry.numLogs());
        }
        found.headMap(first).clear();
        if (found.size() == entry.numLogs()) {
            outcome = new Outcome.Succeeded();
        }
    }

    @Override
    public void advance(long nowNanos) {
        long quiet =
                Math.min(nowNanos - lastSentNanos, tries == 0 ? patience.sinceNewsNanos(nowNanos) : Long.MAX_VALUE);
        if (outcome == null && quiet >= Math.max(IDLE_NANOS, pace.pauseNanos(tries))) {
            outcome = patience.end(nowNanos);
            if (outcome == null) {
                ask(nowNanos);
            }
        }
    }

    @Override
    public @Nullable Outcome outcome() {
        return outcome;
    }
}
