package org.dronemap.core.cloud.rule;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import org.dronemap.core.drone.OutdatedPart;
import org.dronemap.core.drone.StatePart;
import org.dronemap.core.event.DroneEvent;
import org.jspecify.annotations.Nullable;

/**
 * Ages of the parts of one drone's state: a part is outdated when it was not told for ten seconds, or for three times
 * as long as between the last two times. Owned by the drone's lane.
 */
public final class StatePartAges {
    private static final Duration SHORTEST = Duration.ofSeconds(10);
    private static final int INTERVALS = 3;

    private final Map<StatePart, Received> parts = new EnumMap<>(StatePart.class);
    private List<OutdatedPart> outdated = List.of();
    private @Nullable Instant seldomAt;
    private Duration seldomPatience = Duration.ZERO;

    private record Received(Instant at, Duration interval) {}

    /** Takes in what the vehicle told then. */
    public void apply(DroneEvent event, Instant at) {
        switch (event.kind()) {
            case MODE -> mode((DroneEvent.ModeReported) event, at);
            case READINESS -> received(StatePart.READINESS, ((DroneEvent.ReadinessReported) event).readyToArm(), at);
            case PHASE -> received(StatePart.FLIGHT, ((DroneEvent.PhaseReported) event).phase(), at);
            case POSITION -> received(StatePart.POSITION, event, at);
            case LOCAL_POSITION -> received(StatePart.LOCAL, event, at);
            case MOTION -> received(StatePart.MOTION, event, at);
            case ATTITUDE -> received(StatePart.ATTITUDE, ((DroneEvent.AttitudeReported) event).attitude(), at);
            case BATTERY -> received(StatePart.BATTERY, event, at);
            case GPS -> received(StatePart.GPS, event, at);
            // What is told once, when it changes or when it is asked for, or has its own time.
            case IDENTIFIED, HOME, RETURN_HEIGHT_SET, MISSION_CURRENT, MISSION_ITEM_REACHED, MISSION_READ -> {}
            case PARAMETERS_READ, PARAMETER, LOGS_READ, FENCE_READ, RALLY_POINTS_READ -> {}
            case PHOTO, OUTPUTS, READING, WIND, SCAN, PICTURE, MAP, TEXT -> {}
        }
    }

    /** From now on, as long as {@code patience} is not zero: what is told has so much time until it is told again. */
    public void seldom(Instant at, Duration patience) {
        seldomAt = patience.isZero() ? null : at;
        seldomPatience = patience;
    }

    private void mode(DroneEvent.ModeReported told, Instant at) {
        received(StatePart.MODE, told.mode(), at);
        if (told.armed() != null) {
            received(StatePart.ARMED, told.armed(), at);
        }
    }

    /** What is told to be unknown does not age. */
    private void received(StatePart part, @Nullable Object value, Instant at) {
        Received before = parts.get(part);
        if (value == null) {
            parts.remove(part);
        } else {
            parts.put(part, new Received(at, before == null ? Duration.ZERO : Duration.between(before.at(), at)));
        }
        if (!outdated.isEmpty()) {
            outdated = outdated.stream().filter(old -> old.part() != part).toList();
        }
    }

    /** True when that is news; {@code silent}: nothing at all is told, so that no part is older than the others. */
    public boolean judge(Instant now, boolean silent) {
        List<OutdatedPart> before = outdated;
        outdated = silent ? List.of() : outdatedAt(now);
        return !outdated.equals(before);
    }

    /** As last judged, without what was told since. */
    public List<OutdatedPart> outdated() {
        return outdated;
    }

    private boolean isSeldom(Received part) {
        return seldomAt != null && !part.at().isBefore(seldomAt) && seldomPatience.compareTo(SHORTEST) > 0;
    }

    private List<OutdatedPart> outdatedAt(Instant now) {
        List<OutdatedPart> found = new ArrayList<>();
        parts.forEach((part, received) -> {
            Duration longest = received.interval().multipliedBy(INTERVALS);
            Duration shortest = isSeldom(received) ? seldomPatience : SHORTEST;
            Duration patience = longest.compareTo(shortest) > 0 ? longest : shortest;
            if (Duration.between(received.at(), now).compareTo(patience) > 0) {
                found.add(new OutdatedPart(part, received.at()));
            }
        });
        return List.copyOf(found);
    }
}
