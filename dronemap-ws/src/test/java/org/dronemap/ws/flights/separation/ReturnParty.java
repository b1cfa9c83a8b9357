package org.dronemap.ws.flights.separation;

import java.time.Duration;
import java.util.List;
import org.dronemap.core.access.Role;
import org.dronemap.ws.lab.CommandRequests;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.Pilot;

/**
 * A drone that its user has flown beyond the area that others fly in, and calls home through it.
 *
 * @param away where it waits
 */
record ReturnParty(String name, Spot pad, Spot away) implements Party {
    private static final Duration OUTWARD = Duration.ofMinutes(2);
    /** So that its user counts as being there. */
    private static final Duration RHYTHM = Duration.ofSeconds(10);

    private static final double THERE_METERS = 2;

    @Override
    public List<Spot> pads() {
        return List.of(pad);
    }

    @Override
    public List<Spot> waypoints() {
        return List.of();
    }

    @Override
    public Flight prepared(Laboratory lab) {
        LabDrone drone = Vehicles.put(lab, pad);
        Pilot user = lab.pilot(name.replace(' ', '-'), Role.OPERATOR);
        double height = away.up() - pad.up();
        user.takesOff(drone, height);
        lab.until(name + " is up", OUTWARD, () -> drone.height() > height - 1);
        user.fliesTo(drone, away.place(), height);
        lab.until(name + " is away", OUTWARD, () -> drone.distanceTo(away.place()) < THERE_METERS);
        Home flight = new Home(drone, user, height);
        var unused = lab.time().worker("hands of " + user.name(), 1).every(RHYTHM, RHYTHM, flight::stay);
        return flight;
    }

    private final class Home implements Flight {
        private final LabDrone drone;
        private final Pilot user;
        private final double height;
        private boolean begun;

        Home(LabDrone drone, Pilot user, double height) {
            this.drone = drone;
            this.user = user;
            this.height = height;
        }

        private void stay() {
            if (!begun) {
                var unused = user.give(
                        drone,
                        CommandRequests.goTo(
                                away.place().latitudeDegrees(), away.place().longitudeDegrees(), height));
            }
        }

        @Override
        public List<LabDrone> drones() {
            return List.of(drone);
        }

        @Override
        public void begin() {
            begun = true;
            var unused = user.give(drone, CommandRequests.returnToLaunch());
        }

        @Override
        public boolean isOver() {
            return begun && drone.isDown();
        }
    }
}
