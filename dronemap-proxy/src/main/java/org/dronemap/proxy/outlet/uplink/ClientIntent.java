package org.dronemap.proxy.outlet.uplink;

import org.dronemap.core.command.Command;

/** Intent of a MAVLink command of a ground station at the outlet: a command, a message, control, or nothing allowed. */
sealed interface ClientIntent {
    /** A command of the cloud, through its gate. */
    record Order(Command command) implements ClientIntent {}

    /** The newest message of this kind that the vehicle sent; the vehicle is not asked. */
    record Show(int messageId) implements ClientIntent {}

    /** It is as wanted already. */
    record Granted() implements ClientIntent {}

    /** Wants to have control, also by letting go to whoever asks. */
    record Control(boolean allowTakeover) implements ClientIntent {}

    /** Gives control back. */
    record Release() implements ClientIntent {}

    /** It does not pass, and why. */
    record Denied(String sentence) implements ClientIntent {}

    /** It is of a kind that does not pass. */
    record Unknown() implements ClientIntent {}
}
