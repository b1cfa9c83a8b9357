package org.dronemap.example;

import java.time.Duration;

/** Waits for what a drone is to do after it has accepted a command. */
final class Waiting {
    private static final long EVERY_MILLIS = 250;

    interface Condition {
        boolean holds() throws FlightException;
    }

    private Waiting() {}

    static void until(String what, Duration patience, Condition condition) throws FlightException {
        long end = System.nanoTime() + patience.toNanos();
        while (!condition.holds()) {
            if (System.nanoTime() - end > 0) {
                throw new FlightException("After " + patience.toSeconds() + " s it is still not so that " + what + ".");
            }
            try {
                Thread.sleep(EVERY_MILLIS);
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
                throw new FlightException("Interrupted while waiting until " + what + ".", e);
            }
        }
    }
}
