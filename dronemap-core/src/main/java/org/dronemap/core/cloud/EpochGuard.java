package org.dronemap.core.cloud;

/** Stands before the wire: lets what belongs to a command pass only as long as the command may still act. */
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
