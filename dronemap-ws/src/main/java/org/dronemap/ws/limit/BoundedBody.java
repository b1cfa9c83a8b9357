package org.dronemap.ws.limit;

import jakarta.servlet.ReadListener;
import jakarta.servlet.ServletInputStream;
import java.io.IOException;
import java.net.SocketTimeoutException;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.RequestProblem;

/**
 * Input stream of an HTTP request body that fails when too many bytes come or they take too long. Owned by the
 * request's thread.
 */
final class BoundedBody extends ServletInputStream {
    private final ServletInputStream body;
    private final long mostBytes;
    private final ClientLimits limits;
    private final long beganNanos = System.nanoTime();
    private long seen;

    BoundedBody(ServletInputStream body, long mostBytes, ClientLimits limits) {
        this.body = body;
        this.mostBytes = mostBytes;
        this.limits = limits;
    }

    @Override
    public int read() throws IOException {
        try {
            int value = body.read();
            count(value < 0 ? 0 : 1);
            return value;
        } catch (SocketTimeoutException e) {
            throw tooSlow();
        }
    }

    @Override
    public int read(byte[] buffer, int offset, int length) throws IOException {
        try {
            int read = body.read(buffer, offset, length);
            count(Math.max(0, read));
            return read;
        } catch (SocketTimeoutException e) {
            throw tooSlow();
        }
    }

    private void count(int read) {
        seen += read;
        if (seen > mostBytes) {
            throw tooLarge(mostBytes);
        }
        if (System.nanoTime() - beganNanos > limits.longestBody(seen).toNanos()) {
            throw tooSlow();
        }
    }

    /**
     * Throws the rest away, so that a client that is still sending finds its answer; false when there is too much of it, or
     * it takes too long.
     */
    boolean drain(long mostRest) throws IOException {
        byte[] rest = new byte[8_192];
        long until = System.nanoTime() + limits.patience().toNanos();
        long thrown = 0;
        while (thrown < mostRest && System.nanoTime() < until) {
            int read = body.read(rest, 0, rest.length);
            if (read < 0) {
                return true;
            }
            thrown += read;
        }
        return false;
    }

    static Rejection tooLarge(long mostBytes) {
        long megabytes = mostBytes / BodyLimitFilter.MEGABYTE;
        String most = megabytes > 0 ? megabytes + " MB" : mostBytes / BodyLimitFilter.KILOBYTE + " kB";
        return Rejection.of(
                RequestProblem.BODY_TOO_LARGE,
                "The body of this request may have at most " + most + ".",
                ProblemParameter.MOST.is(mostBytes),
                ProblemParameter.UNIT.is("bytes"));
    }

    private static Rejection tooSlow() {
        return Rejection.of(RequestProblem.BODY_TOO_SLOW, "The body of this request came too slowly; send it again.");
    }

    @Override
    public boolean isFinished() {
        return body.isFinished();
    }

    @Override
    public boolean isReady() {
        return body.isReady();
    }

    @Override
    public void setReadListener(ReadListener listener) {
        body.setReadListener(listener);
    }
}
