package org.dronemap.sim.autopilot.px4;

import java.util.function.Consumer;
import org.dronemap.mavlink.Message;
import org.dronemap.sim.autopilot.MavCmd;
import org.dronemap.sim.autopilot.MavCommand;
import org.dronemap.sim.autopilot.SimulatedCommandResult;
import org.dronemap.sim.autopilot.SimulatedTelemetry;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.flight.TextSeverity;
import org.dronemap.sim.physics.LocalFrame;
import org.dronemap.sim.physics.NeuPosition;

/** Executes the MAV_CMDs that the simulated PX4 receives: take-off and go-to by modes, altitudes AMSL. */
final class Px4Commands {
    private final SimulatedPx4 px4;
    private final Px4Flight flight;
    private final SimulatedCraft craft;
    private final Consumer<Message> out;

    Px4Commands(SimulatedPx4 px4, Px4Flight flight, Consumer<Message> out) {
        this.px4 = px4;
        this.flight = flight;
        this.craft = px4.craft();
        this.out = out;
    }

    SimulatedCommandResult execute(MavCommand order) {
        return switch (order.command()) {
            case MavCmd.ARM_DISARM -> armOrDisarm(order);
            case MavCmd.SET_MODE -> px4.setMode((int) order.param1(), (int) order.param2(), (int) order.param3());
            case MavCmd.TAKEOFF -> takeOff(order);
            case MavCmd.LAND -> px4.changed(Px4Mode.LAND);
            case MavCmd.RETURN_TO_LAUNCH -> px4.changed(Px4Mode.RETURN);
            case MavCmd.LOITER_UNLIMITED -> px4.changed(Px4Mode.HOLD);
            case MavCmd.REPOSITION -> reposition(order);
            case MavCmd.CHANGE_SPEED -> changeSpeed(order);
            case MavCmd.PAUSE_CONTINUE -> pauseOrContinue(order);
            case MavCmd.MISSION_START -> startMission(order);
            case MavCmd.SET_MISSION_CURRENT ->
                SimulatedCommandResult.acceptedIf(px4.setCurrentItem((int) order.param1()));
            case MavCmd.SET_HOME -> setHome(order);
            case MavCmd.DIGICAM_CONTROL -> picture(order.shoots());
            case MavCmd.RUN_PREARM_CHECKS -> SimulatedCommandResult.ACCEPTED;
            default -> SimulatedCommandResult.UNSUPPORTED;
        };
    }

    private SimulatedCommandResult armOrDisarm(MavCommand order) {
        if (order.param1() == 1) {
            return px4.arm(order.param2() == MavCmd.FORCE);
        }
        return order.param1() == 0 ? px4.disarm(order.param2() == MavCmd.FORCE) : SimulatedCommandResult.UNSUPPORTED;
    }

    private SimulatedCommandResult takeOff(MavCommand order) {
        double above = order.altitude() - craft.home().altitudeAmsl();
        if (!Double.isNaN(above) && above <= craft.aboveHome()) {
            px4.sendText(TextSeverity.CRITICAL, "Already higher than takeoff altitude");
            return SimulatedCommandResult.DENIED;
        }
        flight.setTakeOffHeight(above);
        return px4.changed(Px4Mode.TAKEOFF);
    }

    private SimulatedCommandResult reposition(MavCommand order) {
        boolean mayChangeMode = ((int) order.param2() & 1) != 0;
        if (!mayChangeMode && flight.mode() != Px4Mode.HOLD) {
            return SimulatedCommandResult.UNSUPPORTED;
        }
        if (!order.isOnEarth()) {
            return SimulatedCommandResult.DENIED;
        }
        if (!px4.change(Px4Mode.HOLD)) {
            return SimulatedCommandResult.TEMPORARILY_REJECTED;
        }
        if (order.param1() > 0) {
            flight.cruise().setHorizontal(order.param1());
        }
        if (craft.armed() && !craft.landed()) {
            // A COMMAND_LONG has no frame: PX4 takes its altitude as AMSL.
            boolean amsl = order.isAmsl() || !order.withFrame();
            double above = amsl ? order.altitude() - craft.home().altitudeAmsl() : order.altitude();
            double height = Double.isNaN(above) ? craft.aboveHome() : above;
            NeuPosition target = craft.locate(order.latitude(), order.longitude(), height);
            flight.goTo(target, order.param4());
        }
        return SimulatedCommandResult.ACCEPTED;
    }

    private SimulatedCommandResult changeSpeed(MavCommand order) {
        if (!(order.param2() > 0) || order.param1() > 1) {
            return SimulatedCommandResult.DENIED;
        }
        flight.cruise().setHorizontal(order.param2());
        return SimulatedCommandResult.ACCEPTED;
    }

    private SimulatedCommandResult pauseOrContinue(MavCommand order) {
        return px4.changed(order.param1() == 0 ? Px4Mode.HOLD : Px4Mode.MISSION);
    }

    private SimulatedCommandResult startMission(MavCommand order) {
        if (px4.plan().size() == 0) {
            px4.sendText(TextSeverity.CRITICAL, "Mission start denied! No valid mission");
            return SimulatedCommandResult.DENIED;
        }
        if (order.param1() > 0) {
            px4.setCurrentItem((int) order.param1());
        }
        if (!px4.change(Px4Mode.MISSION)) {
            return SimulatedCommandResult.TEMPORARILY_REJECTED;
        }
        return px4.arm(false);
    }

    /** Altitudes are AMSL whatever frame is named. */
    private SimulatedCommandResult setHome(MavCommand order) {
        if (order.param1() > 0.5) {
            if (!craft.navigation().hasEstimate()) {
                return SimulatedCommandResult.TEMPORARILY_REJECTED;
            }
            craft.setHomeHere();
        } else if (order.isOnEarth() && Float.isFinite(order.altitude())) {
            craft.setHome(new LocalFrame(order.latitude(), order.longitude(), order.altitude()));
        } else {
            return SimulatedCommandResult.DENIED;
        }
        sendHome();
        return SimulatedCommandResult.ACCEPTED;
    }

    private SimulatedCommandResult picture(boolean single) {
        if (!single) {
            return SimulatedCommandResult.DENIED;
        }
        out.accept(px4.takePicture());
        return SimulatedCommandResult.ACCEPTED;
    }

    void sendHome() {
        out.accept(SimulatedTelemetry.home(craft));
    }
}
