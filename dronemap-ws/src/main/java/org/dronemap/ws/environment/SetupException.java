package org.dronemap.ws.environment;

/** The server cannot start; the message is the one sentence that the person at the terminal sees. */
public final class SetupException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    public SetupException(String sentence) {
        super(sentence);
    }

    public SetupException(String sentence, Throwable cause) {
        super(sentence, cause);
    }
}
