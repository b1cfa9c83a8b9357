package org.dronemap.sim.autopilot.arducopter;

import java.util.function.Supplier;
import org.dronemap.sim.flight.CircleTurns;
import org.dronemap.sim.flight.CruiseSpeeds;
import org.dronemap.sim.flight.HeightAt;
import org.dronemap.sim.flight.Manoeuvre;
import org.dronemap.sim.flight.MissionLegs;
import org.dronemap.sim.flight.MulticopterLegs;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.flight.SimulatedMissionItem;
import org.dronemap.sim.flight.SimulatedParameters;
import org.dronemap.sim.physics.NeuPosition;

/** Makes the manoeuvres by which the simulated ArduCopter flies the items of its mission. Owned by its vehicle. */
final class CopterLegs implements MissionLegs {
    private static final double CENTIMETERS = 100;

    private final MulticopterLegs common;
    private final SimulatedParameters parameters;
    private final CruiseSpeeds cruise;
    private final Supplier<Manoeuvre> returnHome;

    /** {@code returnHome} makes the way home from where it is. */
    CopterLegs(SimulatedParameters parameters, CruiseSpeeds cruise, Supplier<Manoeuvre> returnHome) {
        this.common = new MulticopterLegs(cruise, 0);
        this.returnHome = returnHome;
        this.parameters = parameters;
        this.cruise = cruise;
    }

    @Override
    public boolean flies(SimulatedMissionItem item) {
        return switch (item.command()) {
            case SimulatedMissionItem.LOITER_TURNS, SimulatedMissionItem.LOITER_TO_ALTITUDE -> true;
            default -> common.flies(item);
        };
    }

    @Override
    public Manoeuvre legFor(SimulatedMissionItem item, SimulatedCraft craft, double yaw) {
        NeuPosition target = craft.targetOf(item);
        return switch (item.command()) {
            case SimulatedMissionItem.LOITER_TURNS -> turns(item, target);
            case SimulatedMissionItem.LOITER_TO_ALTITUDE -> new HeightAt(target, cruise);
            case SimulatedMissionItem.RETURN_TO_LAUNCH -> returnHome.get();
            default -> common.legFor(item, craft, yaw);
        };
    }

    private CircleTurns turns(SimulatedMissionItem item, NeuPosition centre) {
        double asked = Math.abs(item.param3());
        double radius = asked > 0 ? asked : parameters.value("CIRCLE_RADIUS") / CENTIMETERS;
        double rate = Math.toRadians(Math.abs(parameters.value("CIRCLE_RATE")));
        return new CircleTurns(centre, radius, item.param1(), item.param3() < 0 ? -rate : rate, cruise);
    }

    @Override
    public long holdMillis(SimulatedMissionItem item) {
        return common.holdMillis(item);
    }

    @Override
    public Manoeuvre afterwards(SimulatedCraft craft, Manoeuvre last) {
        return common.afterwards(craft, last);
    }
}
