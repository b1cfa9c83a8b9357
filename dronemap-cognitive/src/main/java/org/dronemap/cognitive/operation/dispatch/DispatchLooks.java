package org.dronemap.cognitive.operation.dispatch;

import org.dronemap.cognitive.operation.dispatch.DispatchInput.Look;
import org.dronemap.core.drone.Battery;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.Position;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.operation.OperationObservation.ControlStatus;
import org.dronemap.core.operation.OperationObservation.ObservedDrone;
import org.jspecify.annotations.Nullable;

/** Reduces what is known of a drone to what matters to a dispatch. */
final class DispatchLooks {
    private DispatchLooks() {}

    static Look of(DispatchState dispatch, @Nullable DispatchLeg leg, ObservedDrone seen) {
        DroneState drone = seen.state();
        ControlStatus control = seen.control();
        return new Look(
                drone.id(),
                new DispatchInput.Control(
                        control.whyNotHeld(), control.whyNotAllowed(), control.owned(), control.free()),
                flight(drone),
                place(dispatch.order().place(), leg, seen),
                seen.giveWay(),
                drone.link().trend().isFalling() ? drone.link().trend().words() : null);
    }

    private static DispatchInput.Flight flight(DroneState drone) {
        Steering steering =
                drone.mode() == null ? null : drone.capabilities().steering().get(drone.mode());
        return new DispatchInput.Flight(
                Boolean.TRUE.equals(drone.armed()),
                drone.airborne(),
                steering == Steering.ORDERS,
                steering != null && steering.isSafe(),
                steering == Steering.STICKS,
                drone.mode(),
                drone.capabilities().mode(Steering.ORDERS).orElse(null));
    }

    private static DispatchInput.Place place(Geodetic wanted, @Nullable DispatchLeg leg, ObservedDrone seen) {
        DroneState drone = seen.state();
        Position position = drone.position();
        Battery battery = drone.battery();
        Geodetic point = position == null ? null : position.point();
        return new DispatchInput.Place(
                silentSeconds(seen),
                battery == null ? null : battery.percent(),
                point == null || leg == null
                        ? null
                        : (Double) Geodesy.distanceMeters(point, leg.chosen().home()),
                point == null ? null : (Double) Geodesy.distanceMeters(point, wanted),
                position == null ? null : position.altitudeAboveHomeMeters());
    }

    /** Not zero either while a vehicle has not said how it is since the process began. */
    private static int silentSeconds(ObservedDrone seen) {
        DroneState drone = seen.state();
        boolean unknown = drone.link().state() == LinkState.LOST
                || drone.mode() == null
                || drone.armed() == null
                || (drone.phase() == null && drone.position() == null);
        return Math.max(unknown ? 1 : 0, (int) seen.silence().toSeconds());
    }
}
