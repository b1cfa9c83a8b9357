package org.dronemap.sim.autopilot.arducopter;

import org.dronemap.mavlink.message.SetPositionTargetGlobalInt;
import org.dronemap.mavlink.message.SetPositionTargetLocalNed;
import org.dronemap.sim.autopilot.MavCmd;
import org.dronemap.sim.autopilot.MavCommand;
import org.dronemap.sim.autopilot.SimulatedCommandResult;
import org.dronemap.sim.autopilot.ardupilot.ArduPilotCommands;
import org.dronemap.sim.flight.GoTo;
import org.dronemap.sim.flight.MovingTargetManoeuvre;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.flight.TextSeverity;
import org.dronemap.sim.flight.TurnOnSpot;
import org.dronemap.sim.flight.VelocityManoeuvre;
import org.dronemap.sim.physics.NeuPosition;

/**
 * Executes the MAV_CMDs and position targets that the simulated ArduCopter receives. Each copy of an order is acted on.
 */
final class CopterCommands extends ArduPilotCommands {
    private static final int IGNORE_POSITION = 7;
    private static final int IGNORE_VELOCITY = 7 << 3;
    private static final int IGNORE_YAW = 1 << 10;
    private static final int IGNORE_YAW_RATE = 1 << 11;
    private static final int FRAME_BODY = 8;
    private static final int FRAME_BODY_OFFSET = 9;
    private static final double QUICKEST_TURN = 60;

    private final SimulatedArduCopter copter;
    private final CopterFlight flight;
    private final SimulatedCraft craft;

    CopterCommands(SimulatedArduCopter copter, CopterFlight flight) {
        super(copter);
        this.copter = copter;
        this.flight = flight;
        this.craft = copter.craft();
    }

    @Override
    protected SimulatedCommandResult executeOwn(MavCommand order) {
        return switch (order.command()) {
            case MavCmd.TAKEOFF -> SimulatedCommandResult.acceptedIf(takeOff(order));
            case MavCmd.LAND -> SimulatedCommandResult.acceptedIf(copter.change(CopterMode.LAND));
            case MavCmd.RETURN_TO_LAUNCH -> SimulatedCommandResult.acceptedIf(copter.change(CopterMode.RTL));
            case MavCmd.LOITER_UNLIMITED -> SimulatedCommandResult.acceptedIf(copter.change(CopterMode.LOITER));
            case MavCmd.REPOSITION -> reposition(order);
            case MavCmd.CONDITION_YAW -> turn(order);
            case MavCmd.CHANGE_SPEED -> changeSpeed(order);
            case MavCmd.PAUSE_CONTINUE -> pauseOrContinue(order);
            case MavCmd.MISSION_START -> startMission(order);
            default -> SimulatedCommandResult.UNSUPPORTED;
        };
    }

    private boolean takeOff(MavCommand order) {
        boolean canTakeOff = flight.mode() == CopterMode.GUIDED || flight.mode() == CopterMode.LOITER;
        if (!canTakeOff || !craft.armed() || !craft.landed() || order.altitude() <= craft.aboveHome()) {
            return false;
        }
        flight.takeOff(order.altitude());
        return true;
    }

    private SimulatedCommandResult reposition(MavCommand order) {
        if (!order.withFrame()) {
            return SimulatedCommandResult.UNSUPPORTED;
        }
        boolean mayChangeMode = ((int) order.param2() & 1) != 0;
        if (!order.isOnEarth() || (flight.mode() != CopterMode.GUIDED && !mayChangeMode)) {
            return SimulatedCommandResult.DENIED;
        }
        if (!copter.change(CopterMode.GUIDED)) {
            return SimulatedCommandResult.FAILED;
        }
        if (!goTo(order.latitude(), order.longitude(), order.altitude(), order.isAmsl())) {
            return SimulatedCommandResult.FAILED;
        }
        if (order.param1() > 0) {
            flight.cruise().setHorizontal(order.param1());
        }
        return SimulatedCommandResult.ACCEPTED;
    }

    private boolean goTo(double latitude, double longitude, double altitude, boolean amsl) {
        double above = amsl ? altitude - craft.home().altitudeAmsl() : altitude;
        return goTo(craft.locate(latitude, longitude, above), Double.NaN);
    }

    /** False for a place outside of its fence, which it does not fly to. */
    private boolean goTo(NeuPosition target, double yaw) {
        if (!copter.fence().allows(target)) {
            return false;
        }
        // On the ground only a take-off lifts it; a target is taken and not flown.
        if (craft.armed() && !craft.landed()) {
            flight.goTo(target, yaw);
        }
        return true;
    }

    private SimulatedCommandResult turn(MavCommand order) {
        if (craft.landed() || flight.mode() != CopterMode.GUIDED) {
            return SimulatedCommandResult.acceptedIf(craft.landed() || flight.mode() == CopterMode.AUTO);
        }
        double angle = Math.toRadians(order.param1());
        flight.follow(
                order.param4() == 0
                        ? new GoTo(craft.body().stoppingPoint(), flight.cruise(), angle)
                        : new TurnOnSpot(
                                craft, flight.cruise(), order.param3() < 0 ? -angle : angle, rate(order.param2())));
        return SimulatedCommandResult.ACCEPTED;
    }

    /** Radians a second; 0 asks for as quick as it may. */
    private static double rate(double degreesPerSecond) {
        return Math.toRadians(degreesPerSecond > 0 ? Math.min(degreesPerSecond, QUICKEST_TURN) : QUICKEST_TURN);
    }

    /** Of the kinds 2 is up, all beyond down, all others over ground. */
    private SimulatedCommandResult changeSpeed(MavCommand order) {
        if (!(order.param2() > 0)) {
            return SimulatedCommandResult.FAILED;
        }
        int kind = (int) order.param1();
        if (kind > 2) {
            flight.cruise().setSink(order.param2());
        } else if (kind == 2) {
            flight.cruise().setClimb(order.param2());
        } else {
            flight.cruise().setHorizontal(order.param2());
        }
        return SimulatedCommandResult.ACCEPTED;
    }

    private SimulatedCommandResult pauseOrContinue(MavCommand order) {
        boolean pause = order.param1() == 0;
        if (pause ? flight.pause() : flight.resume()) {
            return SimulatedCommandResult.ACCEPTED;
        }
        copter.sendText(TextSeverity.INFO, pause ? "Failed to pause" : "Failed to resume");
        return SimulatedCommandResult.FAILED;
    }

    private SimulatedCommandResult startMission(MavCommand order) {
        if (order.param1() != 0 || order.param2() != 0) {
            return SimulatedCommandResult.DENIED;
        }
        if (!copter.change(CopterMode.AUTO)) {
            return SimulatedCommandResult.FAILED;
        }
        flight.letAutoStart();
        return SimulatedCommandResult.ACCEPTED;
    }

    @Override
    protected void steer(SetPositionTargetGlobalInt target) {
        if (flight.mode() != CopterMode.GUIDED || !craft.armed() || craft.landed()) {
            return;
        }
        double yaw = (target.typeMask() & IGNORE_YAW) == 0 ? target.yaw() : Double.NaN;
        if ((target.typeMask() & IGNORE_POSITION) == 0) {
            boolean amsl = target.coordinateFrame() == 0 || target.coordinateFrame() == 5;
            double above = amsl ? target.alt() - craft.home().altitudeAmsl() : target.alt();
            NeuPosition place = craft.locate(target.latInt() / 1e7, target.lonInt() / 1e7, above);
            if ((target.typeMask() & IGNORE_VELOCITY) == 0) {
                if (!copter.fence().allows(place)) {
                    return;
                }
                flight.pursue(new MovingTargetManoeuvre.Moving(place, target.vx(), target.vy(), -target.vz()), yaw);
            } else {
                goTo(place, yaw);
            }
        } else if ((target.typeMask() & IGNORE_VELOCITY) == 0) {
            drive(new VelocityManoeuvre.Wanted(false, target.vx(), target.vy(), -target.vz(), yaw, 0));
        }
    }

    /** Speeds in the frames 1 and 7 count from north, in 8 and 9 from its nose. */
    @Override
    protected void steer(SetPositionTargetLocalNed target) {
        boolean speeds =
                (target.typeMask() & IGNORE_POSITION) == IGNORE_POSITION && (target.typeMask() & IGNORE_VELOCITY) == 0;
        if (flight.mode() != CopterMode.GUIDED || !craft.armed() || craft.landed() || !speeds) {
            return;
        }
        drive(new VelocityManoeuvre.Wanted(
                target.coordinateFrame() == FRAME_BODY || target.coordinateFrame() == FRAME_BODY_OFFSET,
                target.vx(),
                target.vy(),
                -target.vz(),
                (target.typeMask() & IGNORE_YAW) == 0 ? target.yaw() : Double.NaN,
                (target.typeMask() & IGNORE_YAW_RATE) == 0 ? target.yawRate() : 0));
    }

    private void drive(VelocityManoeuvre.Wanted wanted) {
        flight.follow(new VelocityManoeuvre(wanted, flight.cruise()));
    }
}
