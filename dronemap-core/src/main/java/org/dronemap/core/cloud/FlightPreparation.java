package org.dronemap.core.cloud;

import org.dronemap.core.cloud.lane.Lane;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.CloudLossState;

/**
 * Prepares a vehicle before its first flight commanded by this cloud, and reverts that after the last one. On its lane.
 */
interface FlightPreparation extends Lane.TimedTask {
    /** Nothing. */
    FlightPreparation NONE = new FlightPreparation() {
        @Override
        public boolean delays(PendingCommand entry, Runnable goOn) {
            return false;
        }

        @Override
        public void ended(PendingCommand entry, Outcome outcome) {}

        @Override
        public void returnsAt(double meters) {}

        @Override
        public CloudLossState state() {
            return CloudLossState.UNKNOWN;
        }

        @Override
        public void advance() {}
    };

    /** True: that command has to wait until it is gone on with, which is soon. */
    boolean delays(PendingCommand entry, Runnable goOn);

    /** Any command of this drone has ended. */
    void ended(PendingCommand entry, Outcome outcome);

    /** It was set to fly home at another height, in m above home. */
    void returnsAt(double meters);

    /** Any thread. */
    CloudLossState state();
}
