package org.dronemap.core.separation;

import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.dronemap.core.drone.DroneId;

/** Shows drones to the guard, as often as wanted, and keeps what it decides. */
abstract class SeparationTestBase {
    Map<DroneId, Yielding> yielding = Map.of();
    Map<DroneId, GiveWay> giveWays = Map.of();
    List<SeparationOrder> orders = List.of();
    Instant now = FlyingDrone.NOW;

    /** What is commanded then. */
    List<SeparationOrder> look(FlyingDrone... drones) {
        AirspacePicture picture = new AirspacePicture(
                now, Stream.of(drones).map(FlyingDrone::seen).toList(), Separation.USUAL, (drone, there) -> true);
        SeparationDecision decision = SeparationGuard.decide(picture, yielding);
        yielding = decision.yielding();
        giveWays = decision.giveWays();
        orders = decision.orders();
        return orders;
    }

    static Yielding stood(FlyingDrone to) {
        return Yielding.restored(
                new GiveWay(to.id, "Copter " + to.id, GiveWay.Manner.STOP, FlyingDrone.NOW, false, null));
    }
}
