package org.dronemap.sim.personality.arducopter;

import java.util.function.Consumer;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.SetPositionTargetGlobalInt;
import org.dronemap.mavlink.message.SetPositionTargetLocalNed;
import org.dronemap.sim.flight.Craft;
import org.dronemap.sim.flight.Cruise;
import org.dronemap.sim.flight.Drive;
import org.dronemap.sim.flight.GoTo;
import org.dronemap.sim.flight.Pursuit;
import org.dronemap.sim.flight.Severity;
import org.dronemap.sim.flight.TurnOnSpot;
import org.dronemap.sim.personality.Cmd;
import org.dronemap.sim.personality.Order;
import org.dronemap.sim.personality.Result;
import org.dronemap.sim.personality.Telemetry;
import org.dronemap.sim.physics.LocalFrame;
import org.dronemap.sim.physics.Position;

/** Executes MAV_CMDs and position targets as ArduCopter does. Each copy of an order is acted on. */
final class CopterOrders {
    private static final int IGNORE_POSITION = 7;
    private static final int IGNORE_VELOCITY = 7 << 3;
    private static final int IGNORE_YAW = 1 << 10;
    private static final int IGNORE_YAW_RATE = 1 << 11;
    private static final int FRAME_BODY = 8;
    private static final int FRAME_BODY_OFFSET = 9;
    private static final float FORCE_ARM = 2989;
    private static final double QUICKEST_TURN = 60;

    private final ArduCopter copter;
    private final CopterFlight flight;
    private final Craft craft;
    private final Consumer<Message> out;

    CopterOrders(ArduCopter copter, CopterFlight flight, Consumer<Message> out) {
        this.copter = copter;
        this.flight = flight;
        this.craft = copter.craft();
        this.out = out;
    }

    Result obey(Order order) {
        return switch (order.command()) {
            case Cmd.ARM_DISARM -> armOrDisarm(order);
            case Cmd.SET_MODE -> copter.setMode((int) order.param1(), (long) order.param2());
            case Cmd.TAKEOFF -> Result.acceptedIf(takeOff(order));
            case Cmd.LAND -> Result.acceptedIf(copter.change(CopterMode.LAND));
            case Cmd.RETURN_TO_LAUNCH -> Result.acceptedIf(copter.change(CopterMode.RTL));
            case Cmd.LOITER_UNLIMITED -> Result.acceptedIf(copter.change(CopterMode.LOITER));
            case Cmd.REPOSITION -> reposition(order);
            case Cmd.CONDITION_YAW -> turn(order);
            case Cmd.CHANGE_SPEED -> changeSpeed(order);
            case Cmd.PAUSE_CONTINUE -> pauseOrContinue(order);
            case Cmd.MISSION_START -> startMission(order);
            case Cmd.SET_MISSION_CURRENT -> Result.acceptedIf(copter.setCurrentItem((int) order.param1()));
            case Cmd.SET_HOME -> setHome(order);
            case Cmd.IMAGE_START_CAPTURE -> picture(order.param3() == 1);
            case Cmd.DIGICAM_CONTROL -> picture(order.shoots());
            case Cmd.SET_RELAY -> copter.payload().setRelay((int) order.param1(), (int) order.param2());
            case Cmd.RUN_PREARM_CHECKS -> runChecks();
            default -> Result.UNSUPPORTED;
        };
    }

    private Result armOrDisarm(Order order) {
        if (order.param1() == 1) {
            return copter.arm(order.param2() == FORCE_ARM);
        }
        if (order.param1() == 0) {
            return copter.disarm(order.param2() == Cmd.FORCE);
        }
        return Result.UNSUPPORTED;
    }

    private boolean takeOff(Order order) {
        boolean canTakeOff = flight.mode() == CopterMode.GUIDED || flight.mode() == CopterMode.LOITER;
        if (!canTakeOff || !craft.armed() || !craft.landed() || order.altitude() <= craft.aboveHome()) {
            return false;
        }
        flight.takeOff(order.altitude());
        return true;
    }

    private Result reposition(Order order) {
        if (!order.withFrame()) {
            return Result.UNSUPPORTED;
        }
        boolean mayChangeMode = ((int) order.param2() & 1) != 0;
        if (!order.isOnEarth() || (flight.mode() != CopterMode.GUIDED && !mayChangeMode)) {
            return Result.DENIED;
        }
        if (!copter.change(CopterMode.GUIDED)) {
            return Result.FAILED;
        }
        goTo(order.latitude(), order.longitude(), order.altitude(), order.isAmsl());
        if (order.param1() > 0) {
            flight.cruise().setHorizontal(order.param1());
        }
        return Result.ACCEPTED;
    }

    private void goTo(double latitude, double longitude, double altitude, boolean amsl) {
        double above = amsl ? altitude - craft.home().altitudeAmsl() : altitude;
        goTo(craft.locate(latitude, longitude, above), Double.NaN);
    }

    private void goTo(Position target, double yaw) {
        // On the ground only a take-off lifts it; a target is taken and not flown.
        if (craft.armed() && !craft.landed()) {
            flight.goTo(target, yaw);
        }
    }

    private Result turn(Order order) {
        if (craft.landed() || flight.mode() != CopterMode.GUIDED) {
            return Result.acceptedIf(craft.landed() || flight.mode() == CopterMode.AUTO);
        }
        double angle = Math.toRadians(order.param1());
        flight.follow(
                order.param4() == 0
                        ? new GoTo(craft.body().stoppingPoint(), flight.cruise(), angle)
                        : new TurnOnSpot(
                                craft, flight.cruise(), order.param3() < 0 ? -angle : angle, rate(order.param2())));
        return Result.ACCEPTED;
    }

    /** Radians a second; 0 asks for as quick as it may. */
    private static double rate(double degreesPerSecond) {
        return Math.toRadians(degreesPerSecond > 0 ? Math.min(degreesPerSecond, QUICKEST_TURN) : QUICKEST_TURN);
    }

    private Result picture(boolean single) {
        if (!single) {
            return Result.FAILED;
        }
        out.accept(copter.takePicture());
        return Result.ACCEPTED;
    }

    private Result changeSpeed(Order order) {
        if (!(order.param2() > 0)) {
            return Result.DENIED;
        }
        Cruise cruise = flight.cruise();
        switch ((int) order.param1()) {
            case 0, 1 -> cruise.setHorizontal(order.param2());
            case 2 -> cruise.setClimb(order.param2());
            case 3 -> cruise.setSink(order.param2());
            default -> {
                return Result.DENIED;
            }
        }
        return Result.ACCEPTED;
    }

    private Result pauseOrContinue(Order order) {
        boolean pause = order.param1() == 0;
        if (pause ? flight.pause() : flight.resume()) {
            return Result.ACCEPTED;
        }
        copter.say(Severity.INFO, pause ? "Failed to pause" : "Failed to resume");
        return Result.FAILED;
    }

    private Result startMission(Order order) {
        if (order.param1() != 0 || order.param2() != 0) {
            return Result.DENIED;
        }
        if (!copter.change(CopterMode.AUTO)) {
            return Result.FAILED;
        }
        flight.letAutoStart();
        return Result.ACCEPTED;
    }

    private Result setHome(Order order) {
        if (order.param1() == 1) {
            if (!craft.navigation().hasEstimate()) {
                return Result.FAILED;
            }
            craft.setHomeHere();
        } else if (!order.isOnEarth()) {
            return Result.DENIED;
        } else {
            // A COMMAND_LONG has no frame: ArduPilot takes a home's altitude as AMSL.
            boolean amsl = order.isAmsl() || !order.withFrame();
            double altitude = amsl ? order.altitude() : craft.home().altitudeAmsl() + order.altitude();
            craft.setHome(new LocalFrame(order.latitude(), order.longitude(), altitude));
        }
        sendHome();
        return Result.ACCEPTED;
    }

    private Result runChecks() {
        if (craft.armed()) {
            return Result.TEMPORARILY_REJECTED;
        }
        copter.tellComplaintsNow();
        return Result.ACCEPTED;
    }

    void sendHome() {
        out.accept(Telemetry.home(craft));
    }

    void steer(SetPositionTargetGlobalInt target) {
        if (flight.mode() != CopterMode.GUIDED || !craft.armed() || craft.landed()) {
            return;
        }
        double yaw = (target.typeMask() & IGNORE_YAW) == 0 ? target.yaw() : Double.NaN;
        if ((target.typeMask() & IGNORE_POSITION) == 0) {
            boolean amsl = target.coordinateFrame() == 0 || target.coordinateFrame() == 5;
            double above = amsl ? target.alt() - craft.home().altitudeAmsl() : target.alt();
            Position place = craft.locate(target.latInt() / 1e7, target.lonInt() / 1e7, above);
            if ((target.typeMask() & IGNORE_VELOCITY) == 0) {
                flight.pursue(new Pursuit.Moving(place, target.vx(), target.vy(), -target.vz()), yaw);
            } else {
                goTo(place, yaw);
            }
        } else if ((target.typeMask() & IGNORE_VELOCITY) == 0) {
            drive(new Drive.Wanted(false, target.vx(), target.vy(), -target.vz(), yaw, 0));
        }
    }

    /** Speeds in the frames 1 and 7 count from north, in 8 and 9 from its nose. */
    void steer(SetPositionTargetLocalNed target) {
        boolean speeds =
                (target.typeMask() & IGNORE_POSITION) == IGNORE_POSITION && (target.typeMask() & IGNORE_VELOCITY) == 0;
        if (flight.mode() != CopterMode.GUIDED || !craft.armed() || craft.landed() || !speeds) {
            return;
        }
        drive(new Drive.Wanted(
                target.coordinateFrame() == FRAME_BODY || target.coordinateFrame() == FRAME_BODY_OFFSET,
                target.vx(),
                target.vy(),
                -target.vz(),
                (target.typeMask() & IGNORE_YAW) == 0 ? target.yaw() : Double.NaN,
                (target.typeMask() & IGNORE_YAW_RATE) == 0 ? target.yawRate() : 0));
    }

    private void drive(Drive.Wanted wanted) {
        flight.follow(new Drive(wanted, flight.cruise()));
    }
}
