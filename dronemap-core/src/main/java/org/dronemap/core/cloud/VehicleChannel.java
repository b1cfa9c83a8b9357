package org.dronemap.core.cloud;

import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.Setpoint;

/** Sends commands and setpoints to one vehicle; implemented by each protocol's session, called on the drone's lane. */
public interface VehicleChannel {
    /**
     * Starts to carry a command out; {@code report} hears of it until it ended, exactly once. All that is sent for it
     * passes the mandate's fence.
     */
    void perform(SendAuthority mandate, Command command, Report report);

    /**
     * Says a setpoint at once, where the mandate's fence lets it pass; it is never answered, and what cannot be said is
     * dropped: the next one comes soon.
     */
    void steer(SendAuthority mandate, Setpoint setpoint);

    /** Stops retrying a command; nothing more of it goes out and nothing is reported. No-op when it has ended. */
    void cancel(CommandId id);

    /**
     * A newer session speaks for the same vehicle. True: this channel takes its link over and carries on with everything
     * under way; false: the newer one replaces this one.
     */
    default boolean supersedes(VehicleChannel newer) {
        return false;
    }

    /** That channel spoke with another component of the vehicle, whose state was not the vehicle's. */
    default boolean isOtherComponent(VehicleChannel older) {
        return false;
    }

    /** Asks for any sign of life. */
    void probe();

    /** Callback for the progress and outcome of a command sent to a vehicle. */
    interface Report {
        /** The vehicle took it and is at it. */
        void accepted();

        /** Steps done of steps in all. */
        void progress(int done, int total);

        /** The end; nothing may follow. */
        void ended(Outcome outcome);
    }
}
