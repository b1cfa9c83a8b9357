package org.dronemap.ws.flights.separation;

import java.util.List;
import java.util.SplittableRandom;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.ManualControl;
import org.dronemap.sim.autopilot.MavCmd;
import org.dronemap.sim.autopilot.MavCommand;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.Laboratory;

/**
 * A drone that somebody flies by hand within an area, without the cloud, which only receives what it reports: straight on
 * for five seconds, then in another direction that chance chooses. It pursues nobody and gives way to nobody.
 *
 * @param seed of its directions
 * @param corner of the area, in the south-west at the height that it flies at
 * @param side of the area, m
 * @param seconds until it returns by itself
 */
record HandParty(String name, Spot pad, long seed, Spot corner, double side, double seconds) implements Party {
    private static final long GUIDED = 4;
    private static final long LOITER = 5;
    private static final long RTL = 6;
    private static final int GROUND_STATION = 255;
    private static final double LEG_SECONDS = 5;
    private static final double SLOWEST = 4;
    private static final double FASTEST = 8;
    /** As LOITER makes of a stick at its end, m/s. */
    private static final double AT_THE_END = 12.5;

    private static final int TRIES = 50;

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
        drone.vehicle().setDeaf(true);
        return new ByHand(lab, drone);
    }

    private enum Stage {
        WAITING,
        RISING,
        FLYING,
        RETURNING
    }

    private final class ByHand implements Flight {
        private final SplittableRandom chance = new SplittableRandom(seed);
        private final Laboratory lab;
        private final LabDrone drone;
        private Stage stage = Stage.WAITING;
        private long begunNanos;
        private long legNanos;
        private double northward;
        private double eastward;
        /** As the pilot takes it to be: what gusts do to it changes no direction. */
        private double north = pad.north();

        private double east = pad.east();

        ByHand(Laboratory lab, LabDrone drone) {
            this.lab = lab;
            this.drone = drone;
        }

        @Override
        public List<LabDrone> drones() {
            return List.of(drone);
        }

        @Override
        public void begin() {
            drone.switchedTo(GUIDED);
            orders(MavCmd.ARM_DISARM, 1, 0);
            orders(MavCmd.TAKEOFF, 0, corner.up() - pad.up());
            begunNanos = lab.time().nanos();
            stage = Stage.RISING;
        }

        private void orders(int command, float first, double seventh) {
            var unused = drone.vehicle()
                    .autopilot()
                    .execute(MavCommand.of(new CommandLong(
                            drone.vehicle().systemId(), 1, command, 0, first, 0, 0, 0, 0, 0, (float) seventh)));
        }

        @Override
        public void step() {
            if (stage == Stage.RISING && drone.amsl() > corner.amsl() - 1) {
                drone.switchedTo(LOITER);
                stage = Stage.FLYING;
            }
            if (stage == Stage.FLYING) {
                fly();
            }
        }

        private void fly() {
            long now = lab.time().nanos();
            if ((now - begunNanos) / 1e9 >= seconds) {
                drone.switchedTo(RTL);
                stage = Stage.RETURNING;
                return;
            }
            if ((now - legNanos) / 1e9 >= LEG_SECONDS) {
                legNanos = now;
                chooseDirection();
            }
            double yaw = drone.craft().body().yaw();
            double forward = northward * Math.cos(yaw) + eastward * Math.sin(yaw);
            double right = eastward * Math.cos(yaw) - northward * Math.sin(yaw);
            drone.vehicle()
                    .autopilot()
                    .manual(
                            new ManualControl(
                                    drone.vehicle().systemId(), stick(forward), stick(right), 500, 0, 0, 0, 0, 0, 0),
                            GROUND_STATION);
        }

        private static int stick(double speed) {
            return (int) Math.round(1_000 * speed / AT_THE_END);
        }

        /** One that does not lead out of the area, where there is one; else towards the middle. */
        private void chooseDirection() {
            for (int attempt = 0; attempt < TRIES; attempt++) {
                double speed = chance.nextDouble(SLOWEST, FASTEST);
                double direction = chance.nextDouble(2 * Math.PI);
                if (goesOn(speed * Math.cos(direction), speed * Math.sin(direction))) {
                    return;
                }
            }
            double northwards = corner.north() + side / 2 - north;
            double eastwards = corner.east() + side / 2 - east;
            double share = FASTEST / Math.hypot(northwards, eastwards);
            goTo(northwards * share, eastwards * share);
        }

        private boolean goesOn(double toNorth, double toEast) {
            double ahead = north + toNorth * LEG_SECONDS - corner.north();
            double aside = east + toEast * LEG_SECONDS - corner.east();
            boolean within = ahead > 0 && ahead < side && aside > 0 && aside < side;
            if (within) {
                goTo(toNorth, toEast);
            }
            return within;
        }

        private void goTo(double toNorth, double toEast) {
            northward = toNorth;
            eastward = toEast;
            north += toNorth * LEG_SECONDS;
            east += toEast * LEG_SECONDS;
        }

        @Override
        public boolean isOver() {
            return stage == Stage.RETURNING && drone.isDown();
        }
    }
}
