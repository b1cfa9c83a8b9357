package org.dronemap.core.cloud;

/** Checked just before each send to a vehicle: drops it once control has passed to somebody else. */
public interface EpochGuard {
    /** Lets everything pass. */
    EpochGuard NONE = send -> {
        send.run();
        return true;
    };

    /**
     * Runs {@code send}, which must return at once, or drops it and says false. Nobody can be given control between the
     * look and the sending. Any thread.
     */
    boolean pass(Runnable send);

    default boolean isOpen() {
        return pass(() -> {});
    }
}
