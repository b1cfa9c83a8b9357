package org.dronemap.sim.autopilot.ardurover;

import org.dronemap.mavlink.message.SetPositionTargetGlobalInt;
import org.dronemap.mavlink.message.SetPositionTargetLocalNed;
import org.dronemap.sim.autopilot.MavCmd;
import org.dronemap.sim.autopilot.MavCommand;
import org.dronemap.sim.autopilot.SimulatedCommandResult;
import org.dronemap.sim.autopilot.ardupilot.ArduPilotCommands;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.flight.VelocityManoeuvre;

/**
 * Executes the MAV_CMDs and position targets that the simulated ArduRover receives. It knows no take-off, no landing, no
 * turn on the spot and no pause.
 */
final class RoverCommands extends ArduPilotCommands {
    private static final int IGNORE_POSITION = 3;
    private static final int IGNORE_VELOCITY = 3 << 3;
    private static final int IGNORE_YAW = 1 << 10;
    private static final int FRAME_BODY = 8;
    private static final int FRAME_BODY_OFFSET = 9;

    private final SimulatedArduRover rover;
    private final RoverFlight flight;
    private final SimulatedCraft craft;

    RoverCommands(SimulatedArduRover rover, RoverFlight flight) {
        super(rover);
        this.rover = rover;
        this.flight = flight;
        this.craft = rover.craft();
    }

    @Override
    protected SimulatedCommandResult executeOwn(MavCommand order) {
        return switch (order.command()) {
            case MavCmd.RETURN_TO_LAUNCH -> SimulatedCommandResult.acceptedIf(rover.change(RoverMode.RTL));
            case MavCmd.MISSION_START -> SimulatedCommandResult.acceptedIf(rover.change(RoverMode.AUTO));
            case MavCmd.CHANGE_SPEED -> SimulatedCommandResult.acceptedIf(flight.changeSpeed(order.param2()));
            case MavCmd.REPOSITION -> reposition(order);
            case MavCmd.SET_REVERSE -> SimulatedCommandResult.ACCEPTED;
            default -> SimulatedCommandResult.UNSUPPORTED;
        };
    }

    private SimulatedCommandResult reposition(MavCommand order) {
        if (!order.withFrame()) {
            return SimulatedCommandResult.UNSUPPORTED;
        }
        boolean mayChangeMode = ((int) order.param2() & 1) != 0;
        boolean nowhere = order.latitude() == 0 && order.longitude() == 0;
        if (!order.isOnEarth() || nowhere || (flight.mode() != RoverMode.GUIDED && !mayChangeMode)) {
            return SimulatedCommandResult.DENIED;
        }
        if (!rover.change(RoverMode.GUIDED)) {
            return SimulatedCommandResult.FAILED;
        }
        if (order.param1() > 0 && !flight.changeSpeed(order.param1())) {
            return SimulatedCommandResult.FAILED;
        }
        flight.goTo(craft.locate(order.latitude(), order.longitude(), 0));
        return SimulatedCommandResult.ACCEPTED;
    }

    /** The height of a target is nothing to it. */
    @Override
    protected void steer(SetPositionTargetGlobalInt target) {
        if (flight.mode() != RoverMode.GUIDED) {
            return;
        }
        if ((target.typeMask() & IGNORE_POSITION) == 0) {
            flight.goTo(craft.locate(target.latInt() / 1e7, target.lonInt() / 1e7, 0));
        } else if ((target.typeMask() & IGNORE_VELOCITY) == 0) {
            double yaw = (target.typeMask() & IGNORE_YAW) == 0 ? target.yaw() : Double.NaN;
            drive(new VelocityManoeuvre.Wanted(false, target.vx(), target.vy(), 0, yaw, 0));
        }
    }

    @Override
    protected void steer(SetPositionTargetLocalNed target) {
        boolean speeds = (target.typeMask() & IGNORE_POSITION) != 0 && (target.typeMask() & IGNORE_VELOCITY) == 0;
        if (flight.mode() != RoverMode.GUIDED || !speeds) {
            return;
        }
        boolean fromItsNose = target.coordinateFrame() == FRAME_BODY || target.coordinateFrame() == FRAME_BODY_OFFSET;
        drive(new VelocityManoeuvre.Wanted(fromItsNose, target.vx(), target.vy(), 0, Double.NaN, 0));
    }

    private void drive(VelocityManoeuvre.Wanted wanted) {
        flight.follow(new VelocityManoeuvre(wanted, flight.cruise()));
    }
}
