package org.dronemap.ws.problem;

import java.io.IOException;
import java.util.Locale;
import java.util.Optional;
import org.dronemap.core.time.TransientFailure;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Tells passing outages, such as an unreachable store or a full disk, from server errors, and makes their rejections.
 */
public final class OutageClassifier {
    private static final Logger LOG = LoggerFactory.getLogger(OutageClassifier.class);

    private OutageClassifier() {}

    /** Empty: it is broken. */
    public static Optional<Rejection> of(Throwable thrown) {
        for (Throwable cause = thrown; cause != null; cause = cause.getCause()) {
            if (cause instanceof TransientFailure outage && outage.isTransient()) {
                return Optional.of(Rejection.of(
                        ServerProblem.STORE_UNREACHABLE,
                        "What the server keeps cannot be reached or written at the moment; drones fly on. Try again"
                                + " later."));
            }
            if (cause instanceof IOException file && isFull(file)) {
                return Optional.of(Rejection.of(
                        ServerProblem.DISK_FULL,
                        "There is no room on the server's disk at the moment; drones fly on. Try again later."));
            }
        }
        return Optional.empty();
    }

    /**
     * What is told of one of several things that were asked for at once, so that no failure at one hides what became of the
     * others; what is broken is told to the log.
     */
    public static Rejection rejectionOf(RuntimeException thrown) {
        if (thrown instanceof Rejection refused) {
            return refused;
        }
        return of(thrown).orElseGet(() -> {
            LOG.error("One of several things failed", thrown);
            return Rejection.of(
                    ServerProblem.SERVER_FAILED, "The server failed; those who run it find out why in its log.");
        });
    }

    /** What systems say; there is no type of its own for it. */
    private static boolean isFull(IOException error) {
        String said = String.valueOf(error.getMessage()).toLowerCase(Locale.ROOT);
        return said.contains("no space left")
                || said.contains("disk quota exceeded")
                || said.contains("not enough space on the disk");
    }
}
