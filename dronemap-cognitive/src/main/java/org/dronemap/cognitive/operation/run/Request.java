package org.dronemap.cognitive.operation.run;

import java.time.Instant;
import java.util.List;

/**
 * A plan that was asked for.
 *
 * @param number of all that were asked for, from 1
 * @param better whether a better one than the present one is looked for, else one at once
 * @param at when: zero of the plan's clock
 */
public record Request(int number, boolean better, Instant at, List<Cause> causes) {
    public Request {
        causes = List.copyOf(causes);
    }
}
