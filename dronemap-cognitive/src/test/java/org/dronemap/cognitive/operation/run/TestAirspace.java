package org.dronemap.cognitive.operation.run;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.operation.OperationObservation;
import org.dronemap.core.separation.AirspacePicture;
import org.dronemap.core.separation.FlightIntent;
import org.dronemap.core.separation.FlightPace;
import org.dronemap.core.separation.GiveWay;
import org.dronemap.core.separation.GroundVelocity;
import org.dronemap.core.separation.Handling;
import org.dronemap.core.separation.Separation;
import org.dronemap.core.separation.SeparationDecision;
import org.dronemap.core.separation.SeparationGuard;
import org.dronemap.core.separation.SeparationOrder;
import org.dronemap.core.separation.TrackedDrone;
import org.dronemap.core.separation.Yielding;
import org.jspecify.annotations.Nullable;

/** Keeps the vehicles of a test bench apart, as the conductor of separation does. */
final class TestAirspace {
    private Map<DroneId, Yielding> yielding = Map.of();
    private Map<DroneId, GiveWay> giveWays = Map.of();

    List<SeparationOrder> look(
            Instant now, Map<DroneId, FlightIntent> intents, OperationObservation scene, Separation least) {
        List<TrackedDrone> drones = new ArrayList<>();
        for (OperationObservation.ObservedDrone seen : scene.drones()) {
            FlightIntent meant = intents.get(seen.state().id());
            boolean held = seen.whyNotCommandable() == null;
            boolean counts = held || (meant != null && meant.countsForAnybody());
            boolean silent = seen.state().link().state() == LinkState.LOST;
            drones.add(new TrackedDrone(
                    seen.state(),
                    silent ? seen.silence() : Duration.ZERO,
                    counts ? meant : null,
                    held ? Handling.COMMANDED : Handling.FOREIGN,
                    held ? "run" : null,
                    GroundVelocity.NONE,
                    FlightPace.of(seen.state().identification())));
        }
        SeparationDecision decision =
                SeparationGuard.decide(new AirspacePicture(now, drones, least, (drone, there) -> true), yielding);
        yielding = decision.yielding();
        giveWays = decision.giveWays();
        return decision.orders();
    }

    @Nullable
    GiveWay giveWay(DroneId drone) {
        return giveWays.get(drone);
    }

    /** It has been told to make room for the other one, which takes it so long. */
    void makesRoom(DroneId drone, DroneId other, Instant now, long seconds) {
        GiveWay give = new GiveWay(other, "Drone " + other, GiveWay.Manner.MOVE, now, false, "climbs 6 m");
        yielding = Map.of(drone, new Yielding(give, now, now.plusSeconds(seconds), true, null, null, null));
        giveWays = Map.of(drone, give);
    }
}
