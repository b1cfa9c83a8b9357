package org.dronemap.core.history;

import java.time.Instant;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.drone.MissionPhase;
import org.dronemap.core.drone.MissionProgress;
import org.dronemap.core.drone.TextMessage;
import org.dronemap.core.lease.ControlChange;
import org.dronemap.core.lease.ControlState;
import org.jspecify.annotations.Nullable;

/**
 * Records the history of one drone: samples its states and derives events from changes between them. States come on the
 * drone's lane, commands and control on other threads too: every method holds the object's lock.
 */
final class DroneHistoryRecorder {
    private final TelemetrySink sink;
    private final FlightTracker flight;
    private final StateSampler sampling;
    private @Nullable DroneState before;

    DroneHistoryRecorder(TelemetrySink sink, HistoryPolicy policy, FlightTracker flight) {
        this.sink = sink;
        this.flight = flight;
        this.sampling = new StateSampler(policy);
    }

    synchronized void changed(DroneState now) {
        DroneState last = before;
        before = now;
        recordChanges(last, now);
        TelemetryPoint point = sampling.shouldStore(now) ? TelemetryPoint.of(now) : null;
        if (point != null) {
            sink.point(point);
        }
        flight.changed(now, point);
    }

    synchronized void commanded(CommandRecord command) {
        HistoryEvent event = CommandHistoryEvents.of(command);
        if (event != null) {
            sink.event(event);
        }
        flight.commanded(command);
    }

    synchronized void controlled(ControlState now, ControlChange change, Instant at) {
        DroneState state = before;
        if (state != null) {
            sink.event(ControlHistoryEvents.of(state.id(), at, change));
        }
        flight.controlled(now);
    }

    synchronized void removed(Instant at) {
        flight.removed(at);
    }

    private void recordChanges(@Nullable DroneState last, DroneState now) {
        if (last != null) {
            recordFlightChanges(last, now);
        }
        String mode = now.mode();
        if (mode != null && (last == null || !mode.equals(last.mode()))) {
            record(now, HistoryEvent.Kind.MODE, mode);
        }
        recordMissionChanges(last == null ? MissionProgress.UNKNOWN : last.mission(), now);
        recordMessages(last == null ? List.of() : last.messages(), now);
    }

    private void recordFlightChanges(DroneState last, DroneState now) {
        Boolean armed = now.armed();
        if (armed != null && last.armed() != null && !armed.equals(last.armed())) {
            record(now, armed ? HistoryEvent.Kind.ARMED : HistoryEvent.Kind.DISARMED, armed ? "Armed." : "Disarmed.");
        }
        FlightPhase phase = now.phase();
        if (phase != null && last.phase() != null && phase != last.phase()) {
            record(now, HistoryEvent.Kind.PHASE, words(phase));
        }
    }

    private void recordMissionChanges(MissionProgress last, DroneState now) {
        MissionProgress mission = now.mission();
        List<Integer> reached = mission.reached();
        int known = reached.size() >= last.reached().size() ? last.reached().size() : 0;
        for (Integer item : reached.subList(known, reached.size())) {
            record(now, HistoryEvent.Kind.MISSION, "Reached item " + (item + 1) + ".");
        }
        MissionPhase phase = mission.phase();
        if (phase != null && last.phase() != null && phase != last.phase()) {
            record(now, HistoryEvent.Kind.MISSION, "The mission is " + words(phase) + ".");
        }
        if (!Objects.equals(mission.items(), last.items()) && mission.items() != null) {
            int size = mission.items().size();
            record(now, HistoryEvent.Kind.MISSION, "The mission on the vehicle has " + size + " items.");
        }
    }

    private void recordMessages(List<TextMessage> last, DroneState now) {
        List<TextMessage> messages = now.messages();
        if (messages == last || messages.isEmpty()) {
            return;
        }
        int first = messages.size();
        TextMessage known = last.isEmpty() ? null : last.get(last.size() - 1);
        // The same sentence may be said twice at one moment: only the very same object is old.
        while (first > 0 && !isSame(messages.get(first - 1), known)) {
            first--;
        }
        for (TextMessage message : messages.subList(first, messages.size())) {
            sink.event(new HistoryEvent(
                    now.id(),
                    message.at(),
                    HistoryEvent.Kind.MESSAGE,
                    message.text(),
                    message.severity(),
                    message.about(),
                    null,
                    null,
                    null));
        }
    }

    @SuppressWarnings("ReferenceEquality")
    private static boolean isSame(TextMessage one, @Nullable TextMessage other) {
        return one == other;
    }

    private void record(DroneState now, HistoryEvent.Kind kind, String text) {
        sink.event(HistoryEvent.of(now.id(), now.lastUpdate(), kind, text));
    }

    /** {@code ON_GROUND} becomes {@code on ground}. */
    private static String words(Enum<?> constant) {
        return constant.name().toLowerCase(Locale.ROOT).replace('_', ' ');
    }
}
