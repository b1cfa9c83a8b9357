package org.dronemap.ws.flights.separation;

import java.util.List;
import org.dronemap.core.access.Role;
import org.dronemap.ws.follow.FollowRequest;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.SimulatedPhone;

/**
 * A phone that walks straight on for a while as soon as its drone has come, and then needs no drone any more.
 *
 * @param phone where it stands at first
 * @param northward in m/s
 * @param up of the drone while it follows
 */
record FollowParty(String name, Spot pad, Spot phone, double northward, double eastward, double seconds, double up)
        implements Party {
    private static final double DISTANCE = 6;
    private static final double PATIENCE_SECONDS = 60;
    private static final double COME_METERS = 12;

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
        SimulatedPhone walker = lab.phone(
                lab.pilot(name.replace(' ', '-'), Role.OPERATOR),
                drone,
                phone.north() - pad.north(),
                phone.east() - pad.east());
        return new Walked(lab, drone, walker);
    }

    private enum Stage {
        WAITING,
        COMING,
        WALKING,
        STOPPED
    }

    private final class Walked implements Flight {
        private final Laboratory lab;
        private final LabDrone drone;
        private final SimulatedPhone walker;
        private Stage stage = Stage.WAITING;
        private long begunNanos;
        private long walkingNanos;
        private double walked;

        Walked(Laboratory lab, LabDrone drone, SimulatedPhone walker) {
            this.lab = lab;
            this.drone = drone;
            this.walker = walker;
        }

        @Override
        public List<LabDrone> drones() {
            return List.of(drone);
        }

        @Override
        public void begin() {
            var place = new FollowRequest.PlaceRequest("behind", null, null, DISTANCE, up - pad.up());
            walker.asks(drone, place, PATIENCE_SECONDS).starts();
            begunNanos = lab.time().nanos();
            stage = Stage.COMING;
        }

        @Override
        public void step() {
            boolean come = drone.distanceTo(walker.place()) < COME_METERS;
            if (stage == Stage.COMING && come && walker.view().state().equals("tracking")) {
                walker.walks(northward, eastward);
                walkingNanos = lab.time().nanos();
                stage = Stage.WALKING;
            } else if (stage == Stage.WALKING && (lab.time().nanos() - walkingNanos) / 1e9 >= seconds) {
                walker.walks(0, 0);
                stage = Stage.STOPPED;
                walked = (lab.time().nanos() - begunNanos) / 1e9;
                if (!walker.view().state().equals("over")) {
                    var unused = walker.stops();
                }
            }
        }

        /** On its way home: while it follows, a follow gives way to others by itself. */
        @Override
        public double meetsAfter() {
            return walked;
        }

        @Override
        public boolean isOver() {
            return stage != Stage.WAITING && walker.view().state().equals("over");
        }
    }
}
