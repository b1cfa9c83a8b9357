package org.dronemap.core.operation;

import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.stored.Stored;

/** An action that an operation's decision asks for: a command, a hand-over of control, or a computation. */
public sealed interface OperationAction<I> {
    /**
     * A command through the gate, as any other. The operation names it, so that the same one given twice, as after a restart,
     * acts once.
     */
    @Stored(as = "Give", names = "drone id command")
    record SendCommand<I>(DroneId drone, CommandId id, Command command) implements OperationAction<I> {}

    /**
     * Control of a drone goes over to the user whom the operation is conducted for, if the operation has it; whether it did
     * is seen in the next observation.
     */
    @Stored(as = "HandOver", names = "drone")
    record HandOver<I>(DroneId drone) implements OperationAction<I> {}

    /** Work that takes long, outside: its result comes back as an input. */
    @Stored(as = "Compute", names = "what")
    record Compute<I>(Computation<I> what) implements OperationAction<I> {}
}
