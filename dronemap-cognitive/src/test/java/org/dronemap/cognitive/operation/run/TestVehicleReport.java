package org.dronemap.cognitive.operation.run;

import java.time.Instant;
import java.util.ArrayList;
import java.util.Collections;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.dronemap.cognitive.PlanningFixtures;
import org.dronemap.core.drone.Attitude;
import org.dronemap.core.drone.Battery;
import org.dronemap.core.drone.Capabilities;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.drone.Home;
import org.dronemap.core.drone.Identification;
import org.dronemap.core.drone.IdentityTrust;
import org.dronemap.core.drone.LinkQuality;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.LinkStatus;
import org.dronemap.core.drone.MissionPhase;
import org.dronemap.core.drone.MissionProgress;
import org.dronemap.core.drone.Motion;
import org.dronemap.core.drone.PayloadState;
import org.dronemap.core.drone.Position;
import org.jspecify.annotations.Nullable;

/** What the cloud knows of a vehicle of the tests. */
final class TestVehicleReport {
    private static final Capabilities CAN = new Capabilities(
            EnumSet.allOf(Capability.class),
            List.of("GUIDED", "AUTO", "BRAKE", "HOLD", "LOITER", "RTL", "LAND"),
            Map.of(
                    "GUIDED",
                    Steering.ORDERS,
                    "BRAKE",
                    Steering.ORDERS,
                    "HOLD",
                    Steering.STANDS,
                    "AUTO",
                    Steering.MISSION,
                    "LOITER",
                    Steering.STICKS,
                    "RTL",
                    Steering.SAFETY,
                    "LAND",
                    Steering.SAFETY));

    private final TestVehicle vehicle;
    private final Map<Integer, Instant> photoHeard = new HashMap<>();

    TestVehicleReport(TestVehicle vehicle) {
        this.vehicle = vehicle;
    }

    private PayloadState payload(Instant now) {
        PayloadState payload = PayloadState.UNKNOWN;
        if (!vehicle.photos.isEmpty() && vehicle.tellsPhotos) {
            photoHeard.putIfAbsent(vehicle.photos.size(), now);
            payload = payload.with(new PayloadState.Photo(
                    vehicle.photos.size(),
                    Objects.requireNonNull(photoHeard.get(vehicle.photos.size())),
                    vehicle.photos.get(vehicle.photos.size() - 1)));
        }
        if (!vehicle.moved.isEmpty()) {
            List<Integer> outputs = new ArrayList<>(Collections.nCopies(16, 0));
            vehicle.moved.forEach(servo -> outputs.set(servo.output() - 1, servo.pulseMicros()));
            payload = payload.withOutputs(outputs);
        }
        return vehicle.reading == null ? payload : payload.with(new PayloadState.Reading("temp", vehicle.reading, now));
    }

    DroneState of(Instant now) {
        return new DroneState(
                vehicle.id,
                "Drone " + vehicle.id.value(),
                false,
                new LinkStatus(
                        new DroneKey("127.0.0.1", 1, 1), "udp", LinkState.LIVE, now, LinkQuality.UNKNOWN, List.of()),
                new Identification(vehicle.kind, "ArduPilot", "ArduCopter", null, null),
                IdentityTrust.UNPROVED,
                CAN.with(vehicle.missions),
                vehicle.mode,
                vehicle.armed,
                true,
                vehicle.armed && vehicle.isUp() ? FlightPhase.IN_AIR : FlightPhase.ON_GROUND,
                new Position(
                        PlanningFixtures.point(vehicle.east, vehicle.north),
                        vehicle.altitude + 3,
                        vehicle.altitude - TestVehicle.GROUND),
                null,
                new Motion(0.0, 0.0, vehicle.tumbles ? -5 : vehicle.climb, 0.0),
                new Attitude(vehicle.tumbles ? 64 : 0, 0, 0),
                new Battery((int) Math.floor(Math.max(0, 100 * vehicle.joules / vehicle.fullJoules)), null, null),
                null,
                new Home(PlanningFixtures.point(vehicle.homeEast, vehicle.homeNorth), TestVehicle.GROUND),
                vehicle.returning,
                payload(now),
                vehicle.untold > 0
                        ? MissionProgress.UNKNOWN
                        : new MissionProgress(
                                vehicle.items, null, currentItem(), phase(), List.copyOf(vehicle.reached), null),
                List.of(),
                now,
                0,
                null);
    }

    /** It heads for nothing where it stands after its mission. */
    private @Nullable Integer currentItem() {
        return vehicle.complete && !vehicle.isUp() ? null : Integer.valueOf(vehicle.current);
    }

    private MissionPhase phase() {
        return vehicle.complete
                ? MissionPhase.COMPLETE
                : vehicle.fliesMission() ? MissionPhase.RUNNING : MissionPhase.PAUSED;
    }
}
