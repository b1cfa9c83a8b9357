package org.dronemap.core.lease;

import org.jspecify.annotations.Nullable;

/** What somebody does about the control of a drone, or what befalls it. */
public sealed interface LeaseEvent {
    /** A command of this user is to be sent; {@code epoch} is what the client believes to hold, null: says nothing. */
    record Command(String user, @Nullable Long epoch) implements LeaseEvent {}

    /** Wants control, if it is free. */
    record Take(String user) implements LeaseEvent {}

    /** Wants control, and asks its holder for it. */
    record Request(String user, @Nullable String reason) implements LeaseEvent {}

    /** The holder gives it to somebody who asked. */
    record Grant(String user, String to) implements LeaseEvent {}

    /** The holder keeps it. */
    record Refuse(String user, String to, @Nullable String reason) implements LeaseEvent {}

    /** The holder gives it to somebody, asked or not. */
    record HandOver(String user, String to) implements LeaseEvent {}

    /** Somebody who may takes it from whoever has it. */
    record TakeOver(String user, String reason) implements LeaseEvent {}

    /** The holder is there. */
    record Heartbeat(String user, long epoch) implements LeaseEvent {}

    record Release(String user) implements LeaseEvent {}

    /** An operation wants control, if it is free; what it has already it keeps. */
    record Engage(Holder.Operation by) implements LeaseEvent {}

    /** An operation is over. */
    record Disengage(String operation) implements LeaseEvent {}

    /** Somebody who goes first commands the drone: an operation that has it loses it; {@code why} is a sentence. */
    record Interrupt(String why) implements LeaseEvent {}

    /** This user may command no more. */
    record Expel(String user) implements LeaseEvent {}

    /** Somebody at the vehicle changed its mode. */
    record PilotActed(String what) implements LeaseEvent {}

    /** The flight of the pilot at the vehicle is over. */
    record PilotLeft() implements LeaseEvent {}

    /**
     * Time goes by.
     *
     * @param busy a command of this epoch is under way, or its holder looks at the drone in the air
     * @param heard the drone has said what it does since the server began, and it does not fly by itself: before that a call
     *     back would be spent on nothing
     */
    record Tick(boolean busy, boolean heard) implements LeaseEvent {}
}
