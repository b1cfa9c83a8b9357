package org.dronemap.core.cloud;

import java.util.Optional;
import org.dronemap.core.access.Principal;
import org.dronemap.core.cloud.rule.CommandRules;
import org.dronemap.core.cloud.rule.RoleRules;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.command.Refusal;
import org.dronemap.core.command.Setpoint;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.time.Time;
import org.dronemap.core.zone.CommandRoutes;

/**
 * The single entry point for setpoints: checks each one like a command, and passes the newest on to the vehicle. Any
 * thread; nothing here waits.
 */
public final class SetpointGate {
    private static final String GATE = "gate";

    private final DroneRegistry registry;
    private final CommandGate commands;
    private final Time time;

    SetpointGate(DroneRegistry registry, CommandGate commands, Time time) {
        this.time = time;
        this.registry = registry;
        this.commands = commands;
    }

    /**
     * Steers a drone for at most half a second from now on; then it stands still. Empty when the setpoint was taken, else
     * why it was not; that is written down, and whoever steered is at the helm no more.
     *
     * @throws UnknownDroneException when there is no such drone
     */
    public Optional<Refusal> steer(CommandGate.Source source, DroneId drone, Setpoint setpoint) {
        ManagedDrone managed = find(drone);
        Optional<Refusal> why = whyNot(source.principal(), managed.drone().state(), setpoint)
                .or(() -> enter(managed, source, setpoint));
        why.ifPresent(refusal -> managed.setpoints().refused(source, setpoint, new Outcome.Refused(GATE, refusal)));
        return why;
    }

    private Optional<Refusal> enter(ManagedDrone managed, CommandGate.Source source, Setpoint setpoint) {
        ControlClearance passage = managed.control().enter(source);
        if (passage instanceof ControlClearance.Refused closed) {
            return Optional.of(closed.why());
        }
        Optional<String> busy = commands.manoeuvre(managed);
        if (busy.isPresent()) {
            return Optional.of(new Refusal(
                    OutcomeCode.COMMAND_UNDER_WAY, "Steer when what is under way has ended: " + busy.get() + "."));
        }
        return managed.setpoints()
                        .offer(new SetpointForwarder.PendingSetpoint(
                                source, (ControlClearance.Cleared) passage, setpoint, time.nanos()))
                ? Optional.empty()
                : Optional.of(
                        new Refusal(OutcomeCode.SERVER_OVERLOADED, "The server is overloaded; nothing was sent."));
    }

    /** Why this principal cannot steer that drone so now; empty when it can. */
    public Optional<Refusal> whyNot(Principal principal, DroneState drone, Setpoint setpoint) {
        return RoleRules.whyNot(principal, drone, setpoint.needs())
                .or(() -> CommandRules.whyNot(drone, setpoint))
                .or(() -> CommandRoutes.ahead(drone, setpoint)
                        .flatMap(command -> commands.whyNotThere(principal, drone, command)));
    }

    /**
     * Its source takes the hands off the sticks: the drone stands still at once. No-op when it did not steer.
     *
     * @throws UnknownDroneException when there is no such drone
     */
    public void stopSteering(CommandGate.Source source, DroneId drone) {
        find(drone).setpoints().stopSteering(source, new Outcome.Succeeded());
    }

    private ManagedDrone find(DroneId drone) {
        return registry.find(drone).orElseThrow(() -> new UnknownDroneException(drone));
    }
}
