package org.dronemap.example;

/** End of a flight before its time: a sentence for people, behind it in brackets the server's code for programs. */
final class FlightException extends Exception {
    private static final long serialVersionUID = 1;

    /** As of HTTP; 0: no answer of the server. */
    private final int status;

    FlightException(String sentence) {
        this(sentence, null);
    }

    FlightException(String sentence, Throwable cause) {
        super(sentence, cause);
        status = 0;
    }

    private FlightException(String sentence, int status, Throwable cause) {
        super(sentence, cause);
        this.status = status;
    }

    static FlightException ofNoAnswer(Throwable cause) {
        Throwable innermost = cause;
        while (innermost.getCause() != null) {
            innermost = innermost.getCause();
        }
        return new FlightException("The server (DRONEMAP_URL) gives no answer that can be read: " + innermost, cause);
    }

    /** A request that the server did not carry out. */
    static FlightException ofProblem(int status, String detail, String code, Throwable cause) {
        return new FlightException(detail + " [" + code + "]", status, cause);
    }

    /** A command that ended otherwise than it should: refused, failed, timedOut, superseded or unknown. */
    static FlightException ofOutcome(String result, String reason, String code) {
        return new FlightException(result + ": " + reason + " [" + code + "]");
    }

    /** Whether the server has judged, so that the same request once more would end the same. */
    boolean isFinal() {
        return status >= 400 && status < 500 && status != 408 && status != 429;
    }
}
