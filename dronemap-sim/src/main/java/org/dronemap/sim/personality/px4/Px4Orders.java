package org.dronemap.sim.personality.px4;

import java.util.function.Consumer;
import org.dronemap.mavlink.Message;
import org.dronemap.sim.flight.Craft;
import org.dronemap.sim.flight.Severity;
import org.dronemap.sim.personality.Cmd;
import org.dronemap.sim.personality.Order;
import org.dronemap.sim.personality.Result;
import org.dronemap.sim.personality.Telemetry;
import org.dronemap.sim.physics.LocalFrame;
import org.dronemap.sim.physics.Position;

/** Executes MAV_CMDs as PX4 does: take-off and go-to by modes of their own, altitudes AMSL. */
final class Px4Orders {
    private final Px4 px4;
    private final Px4Flight flight;
    private final Craft craft;
    private final Consumer<Message> out;

    Px4Orders(Px4 px4, Px4Flight flight, Consumer<Message> out) {
        this.px4 = px4;
        this.flight = flight;
        this.craft = px4.craft();
        this.out = out;
    }

    Result obey(Order order) {
        return switch (order.command()) {
            case Cmd.ARM_DISARM -> armOrDisarm(order);
            case Cmd.SET_MODE -> px4.setMode((int) order.param1(), (int) order.param2(), (int) order.param3());
            case Cmd.TAKEOFF -> takeOff(order);
            case Cmd.LAND -> px4.changed(Px4Mode.LAND);
            case Cmd.RETURN_TO_LAUNCH -> px4.changed(Px4Mode.RETURN);
            case Cmd.LOITER_UNLIMITED -> px4.changed(Px4Mode.HOLD);
            case Cmd.REPOSITION -> reposition(order);
            case Cmd.CHANGE_SPEED -> changeSpeed(order);
            case Cmd.PAUSE_CONTINUE -> pauseOrContinue(order);
            case Cmd.MISSION_START -> startMission(order);
            case Cmd.SET_MISSION_CURRENT -> Result.acceptedIf(px4.setCurrentItem((int) order.param1()));
            case Cmd.SET_HOME -> setHome(order);
            case Cmd.DIGICAM_CONTROL -> picture(order.shoots());
            case Cmd.RUN_PREARM_CHECKS -> Result.ACCEPTED;
            default -> Result.UNSUPPORTED;
        };
    }

    private Result armOrDisarm(Order order) {
        if (order.param1() == 1) {
            return px4.arm(order.param2() == Cmd.FORCE);
        }
        return order.param1() == 0 ? px4.disarm(order.param2() == Cmd.FORCE) : Result.UNSUPPORTED;
    }

    private Result takeOff(Order order) {
        double above = order.altitude() - craft.home().altitudeAmsl();
        if (!Double.isNaN(above) && above <= craft.aboveHome()) {
            px4.say(Severity.CRITICAL, "Already higher than takeoff altitude");
            return Result.DENIED;
        }
        flight.setTakeOffHeight(above);
        return px4.changed(Px4Mode.TAKEOFF);
    }

    private Result reposition(Order order) {
        boolean mayChangeMode = ((int) order.param2() & 1) != 0;
        if (!mayChangeMode && flight.mode() != Px4Mode.HOLD) {
            return Result.UNSUPPORTED;
        }
        if (!order.isOnEarth()) {
            return Result.DENIED;
        }
        if (!px4.change(Px4Mode.HOLD)) {
            return Result.TEMPORARILY_REJECTED;
        }
        if (order.param1() > 0) {
            flight.cruise().setHorizontal(order.param1());
        }
        if (craft.armed() && !craft.landed()) {
            // A COMMAND_LONG has no frame: PX4 takes its altitude as AMSL.
            boolean amsl = order.isAmsl() || !order.withFrame();
            double above = amsl ? order.altitude() - craft.home().altitudeAmsl() : order.altitude();
            double height = Double.isNaN(above) ? craft.aboveHome() : above;
            Position target = craft.locate(order.latitude(), order.longitude(), height);
            flight.goTo(target, order.param4());
        }
        return Result.ACCEPTED;
    }

    private Result changeSpeed(Order order) {
        if (!(order.param2() > 0) || order.param1() > 1) {
            return Result.DENIED;
        }
        flight.cruise().setHorizontal(order.param2());
        return Result.ACCEPTED;
    }

    private Result pauseOrContinue(Order order) {
        return px4.changed(order.param1() == 0 ? Px4Mode.HOLD : Px4Mode.MISSION);
    }

    private Result startMission(Order order) {
        if (px4.plan().size() == 0) {
            px4.say(Severity.CRITICAL, "Mission start denied! No valid mission");
            return Result.DENIED;
        }
        if (order.param1() > 0) {
            px4.setCurrentItem((int) order.param1());
        }
        if (!px4.change(Px4Mode.MISSION)) {
            return Result.TEMPORARILY_REJECTED;
        }
        return px4.arm(false);
    }

    /** Altitudes are AMSL whatever frame is named. */
    private Result setHome(Order order) {
        if (order.param1() > 0.5) {
            if (!craft.navigation().hasEstimate()) {
                return Result.TEMPORARILY_REJECTED;
            }
            craft.setHomeHere();
        } else if (order.isOnEarth() && Float.isFinite(order.altitude())) {
            craft.setHome(new LocalFrame(order.latitude(), order.longitude(), order.altitude()));
        } else {
            return Result.DENIED;
        }
        sendHome();
        return Result.ACCEPTED;
    }

    private Result picture(boolean single) {
        if (!single) {
            return Result.DENIED;
        }
        out.accept(px4.takePicture());
        return Result.ACCEPTED;
    }

    void sendHome() {
        out.accept(Telemetry.home(craft));
    }
}
