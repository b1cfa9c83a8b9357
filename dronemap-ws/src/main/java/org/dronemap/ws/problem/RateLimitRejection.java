package org.dronemap.ws.problem;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;

/** Rejection of a request that exceeds a rate limit, with the time to wait. */
public final class RateLimitRejection extends Rejection {
    private static final long serialVersionUID = 1L;

    private final long retryAfterSeconds;

    private RateLimitRejection(
            ServerProblem code, String sentence, long retryAfterSeconds, List<ProblemParameter.Given> parameters) {
        super(code, sentence, parameters);
        this.retryAfterSeconds = retryAfterSeconds;
    }

    /** {@code what} was too much, such as {@code Too many commands}; the wait is told in whole seconds, at least one. */
    public static RateLimitRejection of(
            ServerProblem code, String what, Duration wait, ProblemParameter.Given... parameters) {
        long seconds = Math.max(1, (wait.toMillis() + 999) / 1000);
        List<ProblemParameter.Given> all = new ArrayList<>(List.of(parameters));
        all.add(ProblemParameter.RETRY_AFTER_SECONDS.is(seconds));
        return new RateLimitRejection(code, what + "; wait " + seconds + " s and try again.", seconds, all);
    }

    public long retryAfterSeconds() {
        return retryAfterSeconds;
    }
}
