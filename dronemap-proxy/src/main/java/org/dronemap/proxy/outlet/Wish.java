package org.dronemap.proxy.outlet;

import org.dronemap.core.command.Command;

/** The intent of a client's MAVLink command. */
sealed interface Wish {
    /** A command of the cloud, through its gate. */
    record Order(Command command) implements Wish {}

    /** The newest message of this kind that the vehicle sent; the vehicle is not asked. */
    record Show(int messageId) implements Wish {}

    /** It is as wanted already. */
    record Granted() implements Wish {}

    /** Wants to have control, also by letting go to whoever asks. */
    record Control(boolean allowTakeover) implements Wish {}

    /** Gives control back. */
    record Release() implements Wish {}

    /** It does not pass, and why. */
    record Denied(String sentence) implements Wish {}

    /** It is of a kind that does not pass. */
    record Unknown() implements Wish {}
}
