package org.dronemap.proxy.mavlink.procedure;

import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.Severity;
import org.dronemap.mavlink.Frame;
import org.jspecify.annotations.Nullable;

/**
 * A request-response procedure with one MAVLink vehicle (a command or a transfer), which ends with an outcome. Fed on
 * the drone's lane until it has an outcome; times are monotonic ns.
 */
public interface Exchange {
    void start(long nowNanos);

    /** Any frame of the vehicle's autopilot. */
    void received(Frame frame, long nowNanos);

    /** A whole sentence of the vehicle. */
    default void textReceived(Severity severity, String text, long nowNanos) {}

    void advance(long nowNanos);

    /** Nobody waits for it any more: tells the vehicle to stop where it can, and sends nothing after that. */
    default void cancel(long nowNanos) {}

    /** Null as long as it is under way. */
    @Nullable
    Outcome outcome();
}
