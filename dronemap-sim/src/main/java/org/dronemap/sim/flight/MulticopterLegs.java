package org.dronemap.sim.flight;

import org.dronemap.sim.physics.NeuPosition;

/** Makes the manoeuvres by which a simulated multicopter flies the items of its mission. */
public final class MulticopterLegs implements MissionLegs {
    private static final long WAIT_AT_HOME_MILLIS = 5_000;

    private final CruiseSpeeds cruise;
    private final double returnHeight;

    /** {@code returnHeight} in metres above home. */
    public MulticopterLegs(CruiseSpeeds cruise, double returnHeight) {
        this.cruise = cruise;
        this.returnHeight = returnHeight;
    }

    @Override
    public Manoeuvre legFor(SimulatedMissionItem item, SimulatedCraft craft, double yaw) {
        NeuPosition target = craft.targetOf(item);
        return switch (item.command()) {
            case SimulatedMissionItem.TAKEOFF -> new TakeOff(craft, target.up(), cruise);
            case SimulatedMissionItem.RETURN_TO_LAUNCH ->
                new ReturnHome(craft, cruise, returnHeight, WAIT_AT_HOME_MILLIS);
            case SimulatedMissionItem.LAND ->
                new LandingAt(item.hasPlace() ? target : craft.body().position(), cruise);
            case SimulatedMissionItem.DELAY -> new Hover(craft, cruise);
            default -> GoTo.leg(target, cruise, yaw);
        };
    }

    @Override
    public long holdMillis(SimulatedMissionItem item) {
        return switch (item.command()) {
            case SimulatedMissionItem.WAYPOINT, SimulatedMissionItem.LOITER_TIME, SimulatedMissionItem.DELAY ->
                (long) (Math.max(0, item.param1()) * 1000);
            default -> 0;
        };
    }

    /** Stays over its last waypoint, or where its last item left it. */
    @Override
    public Manoeuvre afterwards(SimulatedCraft craft, Manoeuvre last) {
        if (craft.landed()) {
            return new Grounded();
        }
        return last instanceof GoTo ? last : new Hover(craft, cruise);
    }
}
