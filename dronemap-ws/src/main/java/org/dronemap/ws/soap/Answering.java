package org.dronemap.ws.soap;

import java.util.concurrent.Callable;
import java.util.concurrent.CompletionException;
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
        } catch (CompletionException e) {
            LOG.error("A SOAP call failed while it waited", e);
            throw DronemapFault.of(Problem.internal());
        } catch (Exception e) {
            LOG.error("A SOAP call failed", e);
            throw DronemapFault.of(Problem.internal());
        }
    }
}
