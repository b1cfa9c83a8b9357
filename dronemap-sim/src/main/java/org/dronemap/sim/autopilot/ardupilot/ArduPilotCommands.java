package org.dronemap.sim.autopilot.ardupilot;

import org.dronemap.mavlink.message.SetPositionTargetGlobalInt;
import org.dronemap.mavlink.message.SetPositionTargetLocalNed;
import org.dronemap.sim.autopilot.MavCmd;
import org.dronemap.sim.autopilot.MavCommand;
import org.dronemap.sim.autopilot.SimulatedCommandResult;
import org.dronemap.sim.autopilot.SimulatedTelemetry;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.physics.LocalFrame;

/** Executes the MAV_CMDs that all simulated ArduPilot vehicles take alike; the others are each vehicle's own. */
public abstract class ArduPilotCommands {
    private static final float FORCE_ARM = 2989;

    private final SimulatedArduPilot vehicle;
    private final SimulatedCraft craft;

    protected ArduPilotCommands(SimulatedArduPilot vehicle) {
        this.vehicle = vehicle;
        this.craft = vehicle.craft();
    }

    /** Executes an order of this kind of vehicle; {@link SimulatedCommandResult#UNSUPPORTED} if it knows none such. */
    protected abstract SimulatedCommandResult executeOwn(MavCommand order);

    protected abstract void steer(SetPositionTargetGlobalInt target);

    protected abstract void steer(SetPositionTargetLocalNed target);

    SimulatedCommandResult execute(MavCommand order) {
        return switch (order.command()) {
            case MavCmd.ARM_DISARM -> armOrDisarm(order);
            case MavCmd.SET_MODE -> vehicle.setMode((int) order.param1(), (long) order.param2());
            case MavCmd.SET_MISSION_CURRENT ->
                vehicle.setCurrentItem((int) order.param1())
                        ? SimulatedCommandResult.ACCEPTED
                        : SimulatedCommandResult.DENIED;
            case MavCmd.SET_HOME -> setHome(order);
            case MavCmd.IMAGE_START_CAPTURE -> picture(order.param3() == 1);
            case MavCmd.DIGICAM_CONTROL -> picture(order.shoots());
            case MavCmd.SET_RELAY -> vehicle.payload().setRelay((int) order.param1(), (int) order.param2());
            case MavCmd.RUN_PREARM_CHECKS -> runChecks();
            case MavCmd.FENCE_ENABLE -> switchFence((int) order.param1());
            default -> executeOwn(order);
        };
    }

    private SimulatedCommandResult armOrDisarm(MavCommand order) {
        if (order.param1() == 1) {
            return vehicle.arm(order.param2() == FORCE_ARM);
        }
        if (order.param1() == 0) {
            return vehicle.disarm(order.param2() == MavCmd.FORCE);
        }
        return SimulatedCommandResult.UNSUPPORTED;
    }

    private SimulatedCommandResult picture(boolean single) {
        if (!single) {
            return SimulatedCommandResult.FAILED;
        }
        vehicle.send(vehicle.takePicture());
        return SimulatedCommandResult.ACCEPTED;
    }

    private SimulatedCommandResult setHome(MavCommand order) {
        if (order.param1() == 1) {
            if (!craft.navigation().hasEstimate()) {
                return SimulatedCommandResult.FAILED;
            }
            craft.setHomeHere();
        } else if (!order.isOnEarth()) {
            return SimulatedCommandResult.DENIED;
        } else {
            // A COMMAND_LONG has no frame: ArduPilot takes a home's altitude as AMSL.
            boolean amsl = order.isAmsl() || !order.withFrame();
            double altitude = amsl ? order.altitude() : craft.home().altitudeAmsl() + order.altitude();
            craft.setHome(new LocalFrame(order.latitude(), order.longitude(), altitude));
        }
        sendHome();
        return SimulatedCommandResult.ACCEPTED;
    }

    /** 0 off, 1 on, 2 only its floor off, which this one does not have. */
    private SimulatedCommandResult switchFence(int action) {
        return switch (action) {
            case 0, 1 -> SimulatedCommandResult.acceptedIf(vehicle.fence().enable(action == 1));
            case 2 -> SimulatedCommandResult.ACCEPTED;
            default -> SimulatedCommandResult.FAILED;
        };
    }

    private SimulatedCommandResult runChecks() {
        if (craft.armed()) {
            return SimulatedCommandResult.TEMPORARILY_REJECTED;
        }
        vehicle.reportComplaintsNow();
        return SimulatedCommandResult.ACCEPTED;
    }

    public void sendHome() {
        vehicle.send(SimulatedTelemetry.home(craft));
    }
}
