package org.dronemap.core.cloud.rule;

import java.time.Instant;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.dronemap.core.drone.Capabilities;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.drone.Identification;
import org.dronemap.core.drone.IdentityTrust;
import org.dronemap.core.drone.LinkQuality;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.LinkStatus;
import org.dronemap.core.drone.MissionProgress;
import org.dronemap.core.drone.PayloadState;
import org.dronemap.core.drone.Position;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.MissionAbilities;
import org.jspecify.annotations.Nullable;

/** A drone as commands are judged by it: live, armed and able to do everything, but for what a test changes. */
record JudgedDrone(
        VehicleKind kind,
        Set<Capability> can,
        String mode,
        boolean armed,
        @Nullable FlightPhase phase,
        double aboveHomeMeters) {
    private static final Instant NOW = Instant.parse("2026-03-04T10:00:00Z");
    private static final Map<String, Steering> STEERING = Map.of(
            "GUIDED", Steering.ORDERS,
            "AUTO", Steering.MISSION,
            "BRAKE", Steering.STANDS,
            "LOITER", Steering.STICKS,
            "RTL", Steering.HOME);
    private static final Map<String, String> ARMING = Map.of("RTL", "GUIDED", "AUTO", "GUIDED");

    static JudgedDrone of(VehicleKind kind) {
        return new JudgedDrone(kind, Set.of(Capability.values()), "GUIDED", true, null, 40);
    }

    JudgedDrone in(String other) {
        return new JudgedDrone(kind, can, other, armed, phase, aboveHomeMeters);
    }

    JudgedDrone without(Capability... missing) {
        Set<Capability> left = new HashSet<>(can);
        List.of(missing).forEach(left::remove);
        return new JudgedDrone(kind, left, mode, armed, phase, aboveHomeMeters);
    }

    JudgedDrone at(double meters) {
        return new JudgedDrone(kind, can, mode, armed, phase, meters);
    }

    JudgedDrone says(FlightPhase other) {
        return new JudgedDrone(kind, can, mode, armed, other, aboveHomeMeters);
    }

    JudgedDrone disarmed() {
        return new JudgedDrone(kind, can, mode, false, phase, aboveHomeMeters);
    }

    DroneState state() {
        DroneKey key = new DroneKey("127.0.0.1", 14620, 7);
        return new DroneState(
                new DroneId("judged"),
                "Judged",
                false,
                new LinkStatus(key, "udp", LinkState.LIVE, NOW, LinkQuality.UNKNOWN, List.of()),
                new Identification(kind, "ArduPilot", "ArduPilot", "4.5.6", null),
                IdentityTrust.UNPROVED,
                new Capabilities(
                        can, List.copyOf(STEERING.keySet()), STEERING, Map.of(), ARMING, MissionAbilities.ALL, true),
                mode,
                armed,
                true,
                phase,
                new Position(new Geodetic(46.1, 7.2), 480 + aboveHomeMeters, aboveHomeMeters),
                null,
                null,
                null,
                null,
                null,
                null,
                null,
                PayloadState.UNKNOWN,
                MissionProgress.UNKNOWN,
                List.of(),
                NOW,
                1,
                480.0);
    }
}
