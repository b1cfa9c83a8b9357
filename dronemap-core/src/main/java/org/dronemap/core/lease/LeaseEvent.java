package org.dronemap.core.lease;

import org.jspecify.annotations.Nullable;

/** An event that may change the control of a drone: a user's request, a command, a pilot, time. */
public sealed interface LeaseEvent {
    /** Something that this user does. */
    sealed interface ByUser extends LeaseEvent {
        String user();
    }

    /** A command of this user is to be sent; {@code epoch} is what the client believes to hold, null: says nothing. */
    record Command(String user, @Nullable Long epoch) implements ByUser {}

    /** Wants control, if it is free. */
    record TakeControl(String user) implements ByUser {}

    /** Wants control, and asks its holder for it. */
    record Request(String user, @Nullable String reason) implements ByUser {}

    /** The holder gives it to somebody who asked. */
    record Grant(String user, String to) implements ByUser {}

    /** The holder keeps it. */
    record Refuse(String user, String to, @Nullable String reason) implements ByUser {}

    /** The holder gives it to somebody, asked or not. */
    record HandOver(String user, String to) implements ByUser {}

    /** Somebody who may takes it from whoever has it. */
    record TakeOver(String user, String reason) implements ByUser {}

    /** The holder is there. */
    record Heartbeat(String user, long epoch) implements ByUser {}

    record Release(String user) implements ByUser {}

    /** An operation wants control, if it is free; what it has already it keeps. */
    record Engage(LeaseHolder.Operation by) implements LeaseEvent {}

    /**
     * An operation gives control up, as when it is over.
     *
     * @param to the user who gets it, to be kept by heartbeats from soon on; null: nobody
     */
    record Disengage(String operation, @Nullable String to) implements LeaseEvent {
        public Disengage(String operation) {
            this(operation, null);
        }
    }

    /** Somebody who goes first commands the drone: an operation that has it loses it; {@code why} is a sentence. */
    record Interrupt(String why) implements LeaseEvent {}

    /** This user may command no more. */
    record Expel(String user) implements LeaseEvent {}

    /** Somebody at the vehicle, or at another ground station, changed its mode. */
    record PilotActed(String what) implements LeaseEvent {}

    /** It is on the ground with its motors off: nobody is waited for. */
    record Landed() implements LeaseEvent {}

    /** The flight of the pilot at the vehicle is over. */
    record PilotLeft() implements LeaseEvent {}

    /**
     * Time goes by.
     *
     * @param busy a command of this epoch is under way, or its holder looks at the drone in the air
     * @param linkLive the drone has said what it does since the server began, and it does not fly a mission by itself: before that
     *     a call back would be spent on nothing
     * @param returnNow its battery lasts only just for the way home
     */
    record TimeAdvanced(boolean busy, boolean linkLive, boolean returnNow) implements LeaseEvent {
        public TimeAdvanced(boolean busy, boolean heard) {
            this(busy, heard, false);
        }
    }
}
