package org.dronemap.ws.soap;

import java.util.concurrent.Callable;
import org.dronemap.ws.service.Outages;
import org.dronemap.ws.service.Problem;
import org.dronemap.ws.service.Rejection;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Makes faults of what goes wrong in a call. */
final class Answering {
    private static final Logger LOG = LoggerFactory.getLogger(Answering.class);

    private Answering() {}

    static <T> T answer(Callable<T> work) throws DronemapFault {
        try {
            return work.call();
        } catch (Rejection rejection) {
            throw DronemapFault.of(Problem.of(rejection));
        } catch (Exception e) {
            throw DronemapFault.of(problem(e));
        }
    }

    /** What went wrong without anybody's mistake. */
    static Problem problem(Throwable thrown) {
        Rejection outage = Outages.of(thrown).orElse(null);
        if (outage != null) {
            LOG.warn("A SOAP call came while the store was away: {}", String.valueOf(thrown.getMessage()));
            return Problem.of(outage);
        }
        LOG.error("A SOAP call failed", thrown);
        return Problem.internal();
    }
}
