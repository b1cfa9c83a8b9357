package org.dronemap.sim.autopilot.ardurover;

import org.dronemap.sim.flight.Braking;
import org.dronemap.sim.flight.CruiseSpeeds;
import org.dronemap.sim.flight.DriveTo;
import org.dronemap.sim.flight.FlightEvent;
import org.dronemap.sim.flight.Manoeuvre;
import org.dronemap.sim.flight.MissionLegs;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.flight.SimulatedMission;
import org.dronemap.sim.flight.SimulatedMissionItem;
import org.dronemap.sim.physics.NeuPosition;

/**
 * Makes the manoeuvres by which the simulated ArduRover drives the items of its mission; take-off and landing it passes
 * over.
 */
final class RoverLegs implements MissionLegs {
    private static final double LEAST_RADIUS = 0.5;

    private final SimulatedMission plan;
    private final CruiseSpeeds cruise;
    private final double radius;

    RoverLegs(SimulatedMission plan, CruiseSpeeds cruise, double radius) {
        this.plan = plan;
        this.cruise = cruise;
        this.radius = radius;
    }

    @Override
    public boolean flies(SimulatedMissionItem item) {
        return isDriven(item);
    }

    static boolean isDriven(SimulatedMissionItem item) {
        return switch (item.command()) {
            case SimulatedMissionItem.WAYPOINT,
                    SimulatedMissionItem.LOITER_UNLIMITED,
                    SimulatedMissionItem.LOITER_TIME,
                    SimulatedMissionItem.LOITER_TURNS,
                    SimulatedMissionItem.RETURN_TO_LAUNCH,
                    SimulatedMissionItem.DELAY -> true;
            default -> false;
        };
    }

    /** It begins the item and is done with it, without a word more. */
    @Override
    public FlightEvent passedOver(int index, SimulatedMissionItem item) {
        return new FlightEvent.ItemStarted(index, item.typeName());
    }

    @Override
    public Manoeuvre legFor(SimulatedMissionItem item, SimulatedCraft craft, double yaw) {
        return switch (item.command()) {
            case SimulatedMissionItem.DELAY -> new Braking();
            case SimulatedMissionItem.LOITER_TURNS -> circle(item, craft.targetOf(item));
            case SimulatedMissionItem.RETURN_TO_LAUNCH -> new DriveTo(craft, craft.homePosition(), cruise, radius);
            default ->
                stopsAt(item)
                        ? new DriveTo(craft, craft.targetOf(item), cruise, radius)
                        : DriveTo.through(craft, craft.targetOf(item), cruise, radius);
        };
    }

    private RoverCircle circle(SimulatedMissionItem item, NeuPosition centre) {
        double size = Math.max(LEAST_RADIUS, Math.abs(item.param3()));
        return new RoverCircle(centre, item.param3() < 0 ? -size : size, item.param1(), cruise);
    }

    private boolean stopsAt(SimulatedMissionItem item) {
        boolean waits = item.command() != SimulatedMissionItem.WAYPOINT || item.param1() > 0;
        return waits || !drivesOnAfter(plan.items().lastIndexOf(item));
    }

    /** The next item to go to is one that it drives to; before a landing it stops. */
    private boolean drivesOnAfter(int index) {
        for (int i = index + 1; i < plan.size(); i++) {
            if (plan.item(i).isNavigation()) {
                return isDriven(plan.item(i));
            }
        }
        return false;
    }

    @Override
    public long holdMillis(SimulatedMissionItem item) {
        return switch (item.command()) {
            case SimulatedMissionItem.WAYPOINT, SimulatedMissionItem.LOITER_TIME, SimulatedMissionItem.DELAY ->
                (long) (Math.max(0, item.param1()) * 1000);
            default -> 0;
        };
    }

    @Override
    public Manoeuvre afterwards(SimulatedCraft craft, Manoeuvre last) {
        return new Braking();
    }
}
