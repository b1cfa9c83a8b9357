package org.dronemap.proxy.outlet.uplink;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.RejectedExecutionException;
import java.util.function.Consumer;
import org.dronemap.core.access.Principal;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.cloud.CommandGate;
import org.dronemap.core.cloud.listener.CloudListener;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.CommandPhase;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.command.Refusal;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.lease.LeaseEvent;
import org.dronemap.core.lease.LeaseStep;
import org.dronemap.core.time.Time;
import org.dronemap.core.time.Worker;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Executes the commands of ground stations at the outlet through the command gate, as their users, in order. Any
 * thread.
 */
final class ClientCommandExecutor implements CloudListener, AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(ClientCommandExecutor.class);
    static final String FACE = "outlet";
    private static final int MOST_WAITING = 256;

    private final CloudManager cloud;
    private final OutletLeaseAuthority control;
    private final Consumer<Runnable> answering;
    private final Map<CommandId, Callback> open = new ConcurrentHashMap<>();
    private final Worker thread;
    private final Time time;

    /** Hears what becomes of a command, where clients are answered. */
    interface Callback {
        /** The vehicle took it and is at it. */
        void accepted();

        /** The end; nothing follows. */
        void ended(Outcome outcome);
    }

    /** {@code answering} runs what is to be answered. */
    ClientCommandExecutor(CloudManager cloud, OutletLeaseAuthority control, Consumer<Runnable> answering, Time time) {
        this.cloud = cloud;
        this.control = control;
        this.answering = answering;
        this.time = time;
        thread = time.worker("outlet-orders", MOST_WAITING);
        cloud.addListener(this);
    }

    /** Gives a command; whatever becomes of it is answered. */
    void submit(Principal principal, DroneId drone, Command command, Callback answer) {
        CommandId id = new CommandId("outlet-" + time.newId());
        open.put(id, answer);
        try {
            thread.execute(() -> submitToGate(principal, drone, id, command));
        } catch (RejectedExecutionException e) {
            LOG.warn("The outlet had no room for a command of {}", principal.name());
            end(
                    id,
                    new Outcome.Refused(
                            "gate",
                            new Refusal(OutcomeCode.SERVER_OVERLOADED, "The server is overloaded; nothing was sent.")));
        }
    }

    private void submitToGate(Principal principal, DroneId drone, CommandId id, Command command) {
        try {
            commandChanged(cloud.gate().submit(new CommandGate.Source(principal, FACE), drone, id, command));
        } catch (RuntimeException e) {
            LOG.error("A command of {} at the outlet could not be given", principal.name(), e);
            end(id, new Outcome.Failed("The server could not take the command down; nothing was sent."));
        }
    }

    /** Does something about the control of a drone, in order with commands; {@code answer} hears null when it could not be done. */
    void act(Principal principal, DroneId drone, LeaseEvent event, Consumer<@Nullable LeaseStep> answer) {
        try {
            thread.execute(() -> {
                LeaseStep step = decided(principal, drone, event);
                answering.accept(() -> answer.accept(step));
            });
        } catch (RejectedExecutionException e) {
            LOG.warn("The outlet had no room for what {} wanted with the control of a drone", principal.name());
            answering.accept(() -> answer.accept(null));
        }
    }

    private @Nullable LeaseStep decided(Principal principal, DroneId drone, LeaseEvent event) {
        try {
            return control.act(principal, drone, event);
        } catch (RuntimeException e) {
            LOG.error("What {} wanted with the control of {} could not be done", principal.name(), drone, e);
            return null;
        }
    }

    @Override
    public void commandChanged(CommandRecord command) {
        Callback answer = open.get(command.id());
        if (answer == null) {
            return;
        }
        Outcome outcome = command.outcome();
        if (outcome != null) {
            end(command.id(), outcome);
        } else if (command.phase() == CommandPhase.ACCEPTED) {
            answering.accept(answer::accepted);
        }
    }

    private void end(CommandId id, Outcome outcome) {
        Callback answer = open.remove(id);
        if (answer != null) {
            answering.accept(() -> answer.ended(outcome));
        }
    }

    @Override
    public void close() {
        cloud.removeListener(this);
        thread.close();
    }
}
