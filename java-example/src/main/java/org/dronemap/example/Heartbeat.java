package org.dronemap.example;

import java.time.Duration;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;

/**
 * Tells the server every two seconds that whoever took control is still there, in a thread of its own. After three that
 * it misses, the server has the drone hold, and half a minute later calls it home.
 */
final class Heartbeat implements AutoCloseable {
    /** One that hangs in a dead connection must not keep the next one from being sent. */
    static final Duration LONGEST = Duration.ofMillis(2500);

    private static final long SECONDS = 2;

    /** Sends one, and returns the epoch of the control, which may be another one after a restart of the server. */
    interface Beat {
        long send(long epoch) throws FlightException;
    }

    private final ScheduledExecutorService timer = Executors.newSingleThreadScheduledExecutor();
    private final Beat beat;
    private volatile long epoch; // written by the timer's thread alone
    private volatile FlightException lost;

    Heartbeat(long epoch, Beat beat) {
        this.epoch = epoch;
        this.beat = beat;
        timer.scheduleAtFixedRate(this::send, SECONDS, SECONDS, TimeUnit.SECONDS);
    }

    private void send() {
        try {
            epoch = beat.send(epoch);
        } catch (FlightException e) {
            // Who gets no answer has control still, if the connection is back in time.
            if (e.isFinal()) {
                lost = e;
                timer.shutdown();
            }
        }
    }

    boolean holds() {
        return lost == null;
    }

    void check() throws FlightException {
        if (lost != null) {
            throw new FlightException("Control has ended: " + lost.getMessage(), lost);
        }
    }

    /** Of the control that is held: a command with it is refused once somebody else has control. */
    long epoch() throws FlightException {
        check();
        return epoch;
    }

    /** Returns when the last one is over, so that none comes after control was given back. */
    @Override
    public void close() {
        timer.shutdown();
        try {
            timer.awaitTermination(LONGEST.toMillis(), TimeUnit.MILLISECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
