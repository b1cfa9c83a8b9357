package org.dronemap.core.zone;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Position;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.jspecify.annotations.Nullable;

/**
 * Detects breaches of zones by one flying drone: warns ahead of one, reports it, and repeats while it lasts. Owned by
 * one thread; times in ns of a monotonic clock.
 */
public final class ZoneBreachDetector {
    /** How far it looks ahead. */
    private static final double AHEAD_SECONDS = 10;

    private static final double STEP_SECONDS = 0.5;
    /** Who was out of danger for so long is warned again. */
    private static final long CALM_NANOS = 3_000_000_000L;
    /** Who was out of a zone for so long breaches it anew; less is the trembling of a position. */
    private static final long OUTSIDE_NANOS = 1_500_000_000L;
    /** Who stays in a breach is told again. */
    private static final long REMINDER_NANOS = 10_000_000_000L;

    private final CoursePredictor course = new CoursePredictor();
    private final Map<String, Alert> alerts = new HashMap<>();

    /** Result of a zone check of a drone in the air: predicted, new or continuing breach. */
    public sealed interface Finding {
        Zone zone();

        /** It will breach the zone in so many seconds, going on like this. */
        record Predicted(Zone zone, double seconds) implements Finding {}

        /** It breaches the zone. */
        record Breach(Zone zone) implements Finding {}

        /** It has not left the breach. */
        record Continuing(Zone zone) implements Finding {}
    }

    /** Times of the last danger, the last breach and its last report for one zone, in nanoseconds; null: not yet. */
    private record Alert(
            long lastNanos,
            @Nullable Long breachNanos,
            @Nullable Long reportedNanos) {}

    /** Looks at a drone in the air. */
    public List<Finding> check(List<Zone> zones, DroneState drone, long nanos) {
        Position position = drone.position();
        Geodetic point = position == null ? null : position.point();
        if (position == null || point == null) {
            return List.of();
        }
        course.add(nanos, point, position);
        HeightReferences levels = HeightReferences.of(drone);
        List<Finding> findings = new ArrayList<>();
        for (Zone zone : zones) {
            if (BreachCheck.breaches(zone, point, position, levels)) {
                breached(zone, nanos, findings);
            } else {
                ahead(zone, position, point, levels).ifPresent(seconds -> danger(zone, seconds, nanos, findings));
            }
        }
        alerts.values().removeIf(alert -> nanos - alert.lastNanos() > CALM_NANOS);
        return findings;
    }

    private void breached(Zone zone, long nanos, List<Finding> findings) {
        Alert before = alerts.get(zone.id());
        Long last = before == null ? null : before.breachNanos();
        Long said = before == null ? null : before.reportedNanos();
        if (last == null || said == null || nanos - last > OUTSIDE_NANOS) {
            findings.add(new Finding.Breach(zone));
            said = nanos;
        } else if (nanos - said >= REMINDER_NANOS) {
            findings.add(new Finding.Continuing(zone));
            said = nanos;
        }
        alerts.put(zone.id(), new Alert(nanos, nanos, said));
    }

    private void danger(Zone zone, double seconds, long nanos, List<Finding> findings) {
        Alert before = alerts.get(zone.id());
        alerts.put(
                zone.id(),
                before == null
                        ? new Alert(nanos, null, null)
                        : new Alert(nanos, before.breachNanos(), before.reportedNanos()));
        if (before == null) {
            findings.add(new Finding.Predicted(zone, seconds));
        }
    }

    /** Seconds to the breach; empty: none as far as can be seen. */
    private Optional<Double> ahead(Zone zone, Position position, Geodetic point, HeightReferences levels) {
        if (!leads(zone, position, point, AHEAD_SECONDS, levels)) {
            return Optional.empty();
        }
        double seconds = STEP_SECONDS;
        while (seconds < AHEAD_SECONDS && !leads(zone, position, point, seconds, levels)) {
            seconds += STEP_SECONDS;
        }
        return Optional.of(seconds);
    }

    private boolean leads(Zone zone, Position position, Geodetic point, double seconds, HeightReferences levels) {
        CoursePredictor.Prediction there = course.ahead(seconds);
        if (there == null) {
            return false;
        }
        List<Altitude> heights = Stream.concat(
                        MissionRouteBuilder.altitudes(position).stream(),
                        MissionRouteBuilder.altitudes(there.position()).stream())
                .toList();
        // Whoever takes off or lands is below the floor of the area that it stays in.
        Leg leg = new Leg(
                "The way ahead",
                point,
                there.point(),
                new LegHeights(heights, zone.shape().inside()));
        return new LegCheck(leg, levels).whyNot(zone).isPresent();
    }
}
