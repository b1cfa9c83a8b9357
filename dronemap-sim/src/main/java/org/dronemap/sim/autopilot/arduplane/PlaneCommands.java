package org.dronemap.sim.autopilot.arduplane;

import org.dronemap.mavlink.message.SetPositionTargetGlobalInt;
import org.dronemap.mavlink.message.SetPositionTargetLocalNed;
import org.dronemap.sim.autopilot.MavCmd;
import org.dronemap.sim.autopilot.MavCommand;
import org.dronemap.sim.autopilot.SimulatedCommandResult;
import org.dronemap.sim.autopilot.ardupilot.ArduPilotCommands;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.flight.SimulatedParameters;
import org.dronemap.sim.flight.TextSeverity;

/** Executes the MAV_CMDs and position targets that the simulated ArduPlane takes, and refuses the others as it does. */
final class PlaneCommands extends ArduPilotCommands {
    private static final int LAND_START = 189;
    private static final int GO_AROUND = 191;
    private static final int CHANGE_MODE_FLAG = 1;
    private static final int TYPE_AIRSPEED = 0;
    private static final int TYPE_GROUND_SPEED = 1;
    private static final float DEFAULT_SPEED = -2;
    private static final int OTHER_THAN_HEIGHT = 0xFFFB;
    private static final int FRAME_FROM_HERE = 7;

    private final SimulatedArduPlane plane;
    private final PlaneFlight flight;
    private final SimulatedCraft craft;
    private final SimulatedParameters parameters;

    PlaneCommands(SimulatedArduPlane plane, PlaneFlight flight) {
        super(plane);
        this.plane = plane;
        this.flight = flight;
        this.craft = plane.craft();
        this.parameters = plane.parameters();
    }

    @Override
    protected SimulatedCommandResult executeOwn(MavCommand order) {
        return switch (order.command()) {
            case MavCmd.TAKEOFF -> SimulatedCommandResult.acceptedIf(plane.liftOff(order.altitude()));
            case MavCmd.RETURN_TO_LAUNCH -> enter(PlaneMode.RTL);
            case MavCmd.LOITER_UNLIMITED -> enter(PlaneMode.LOITER);
            case MavCmd.MISSION_START -> enter(PlaneMode.AUTO);
            case MavCmd.REPOSITION -> reposition(order);
            case MavCmd.CHANGE_SPEED -> SimulatedCommandResult.acceptedIf(changesSpeed(order));
            case LAND_START -> SimulatedCommandResult.acceptedIf(startsLanding());
            case GO_AROUND -> SimulatedCommandResult.acceptedIf(goesAround(order.param1()));
            default -> SimulatedCommandResult.UNSUPPORTED;
        };
    }

    /** Accepted whether the mode could be changed or not. */
    private SimulatedCommandResult enter(PlaneMode mode) {
        plane.change(mode);
        return SimulatedCommandResult.ACCEPTED;
    }

    private SimulatedCommandResult reposition(MavCommand order) {
        if (!order.withFrame()) {
            return SimulatedCommandResult.UNSUPPORTED;
        }
        if (!order.isOnEarth()) {
            return SimulatedCommandResult.DENIED;
        }
        boolean mayChangeMode = ((int) order.param2() & CHANGE_MODE_FLAG) != 0;
        if (flight.mode() != PlaneMode.GUIDED && !mayChangeMode) {
            return SimulatedCommandResult.FAILED;
        }
        plane.change(PlaneMode.GUIDED);
        double radius = order.param3() > 0 ? order.param3() : 0;
        boolean left = !Float.isNaN(order.param4()) && order.param4() != 0;
        double above = order.isAmsl() ? order.altitude() - craft.home().altitudeAmsl() : order.altitude();
        flight.goTo(craft.locate(order.latitude(), order.longitude(), above), left ? -radius : radius);
        return SimulatedCommandResult.ACCEPTED;
    }

    private boolean changesSpeed(MavCommand order) {
        if (flight.mode() != PlaneMode.GUIDED && flight.mode() != PlaneMode.AUTO) {
            return false;
        }
        float speed = order.param2();
        switch ((int) order.param1()) {
            case TYPE_AIRSPEED -> {
                if (speed == DEFAULT_SPEED) {
                    flight.readSpeeds();
                    return true;
                }
                if (speed >= parameters.value("AIRSPEED_MIN") && speed <= parameters.value("AIRSPEED_MAX")) {
                    flight.cruise().setHorizontal(speed);
                    plane.sendText(TextSeverity.INFO, "Set airspeed " + (int) speed + " m/s");
                    return true;
                }
            }
            case TYPE_GROUND_SPEED -> {
                plane.sendText(TextSeverity.INFO, "Set groundspeed " + (int) speed);
                return true;
            }
            default -> {}
        }
        return changesThrottle(order.param3());
    }

    private boolean changesThrottle(float percent) {
        if (percent > 0 && percent <= 100) {
            plane.sendText(TextSeverity.INFO, "Set throttle " + (int) percent);
            return true;
        }
        return false;
    }

    private boolean startsLanding() {
        boolean starts = flight.landingSequence().start(flight.mode() == PlaneMode.AUTO);
        if (starts) {
            plane.change(PlaneMode.AUTO);
        }
        return starts;
    }

    private boolean goesAround(double climbTo) {
        PlaneLanding landing = flight.landing();
        double meters = climbTo > 0 ? climbTo : parameters.value("TKOFF_ALT");
        return flight.mode() == PlaneMode.AUTO && landing != null && landing.goAround(meters);
    }

    /** Of a target for GUIDED it takes the height alone. */
    @Override
    protected void steer(SetPositionTargetGlobalInt target) {
        if (flight.mode() != PlaneMode.GUIDED || (target.typeMask() & OTHER_THAN_HEIGHT) == 0) {
            return;
        }
        boolean amsl = target.coordinateFrame() == 0 || target.coordinateFrame() == 5;
        double home = craft.homePosition().up();
        flight.changeHeight(home + (amsl ? target.alt() - craft.home().altitudeAmsl() : target.alt()));
    }

    @Override
    protected void steer(SetPositionTargetLocalNed target) {
        if (flight.mode() == PlaneMode.GUIDED && target.coordinateFrame() == FRAME_FROM_HERE) {
            flight.changeHeight(craft.body().up() - target.z());
        }
    }
}
