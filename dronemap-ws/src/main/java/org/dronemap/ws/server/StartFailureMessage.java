package org.dronemap.ws.server;

import org.dronemap.store.StoreException;
import org.dronemap.ws.environment.SetupException;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.springframework.boot.web.server.PortInUseException;

/** Words in one sentence why the server did not start, from the exception. */
public final class StartFailureMessage {
    private static final Logger LOG = LoggerFactory.getLogger(StartFailureMessage.class);

    private StartFailureMessage() {}

    public static String sentence(Throwable failure) {
        for (Throwable cause = failure; cause != null; cause = cause.getCause()) {
            if (cause instanceof SetupException || cause instanceof StoreException) {
                return String.valueOf(cause.getMessage());
            }
            if (cause instanceof PortInUseException taken) {
                return "Port " + taken.getPort() + " is taken by another program; stop that one, or choose another port"
                        + " with DRONEMAP_HTTP_PORT.";
            }
        }
        LOG.error("The start failed", failure);
        return "The server could not start: " + failure.getMessage() + " (the log has the details).";
    }
}
