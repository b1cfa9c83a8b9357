package org.dronemap.ws.environment;

/** Thrown when the server cannot start; its message is one sentence for the person who started it. */
public final class SetupException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    public SetupException(String sentence) {
        super(sentence);
    }

    public SetupException(String sentence, Throwable cause) {
        super(sentence, cause);
    }
}
