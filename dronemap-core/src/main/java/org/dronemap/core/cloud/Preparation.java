package org.dronemap.core.cloud;

import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.CloudLossState;

/**
 * Prepares a vehicle before the first flight commanded here, and reverts that after the last; on its lane. On its lane.
 */
interface Preparation extends Lane.Ticker {
    /** Nothing. */
    Preparation NONE = new Preparation() {
        @Override
        public boolean holdsBack(Underway entry, Runnable goOn) {
            return false;
        }

        @Override
        public void ended(Underway entry, Outcome outcome) {}

        @Override
        public CloudLossState state() {
            return CloudLossState.UNKNOWN;
        }

        @Override
        public void tick() {}
    };

    /** True: that command has to wait until it is gone on with, which is soon. */
    boolean holdsBack(Underway entry, Runnable goOn);

    /** Any command of this drone has ended. */
    void ended(Underway entry, Outcome outcome);

    /** Any thread. */
    CloudLossState state();
}
