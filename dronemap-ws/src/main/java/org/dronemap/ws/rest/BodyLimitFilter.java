package org.dronemap.ws.rest;

import jakarta.servlet.FilterChain;
import jakarta.servlet.ReadListener;
import jakarta.servlet.ServletException;
import jakarta.servlet.ServletInputStream;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletRequestWrapper;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import org.dronemap.ws.security.ProblemWriter;
import org.dronemap.ws.service.Problem;
import org.dronemap.ws.service.Rejection;
import org.dronemap.ws.service.RejectionKind;
import org.springframework.web.filter.OncePerRequestFilter;

/** Bounds what a client may send: 1 MB, and 512 MB for a recording. */
public final class BodyLimitFilter extends OncePerRequestFilter {
    private static final long MEGABYTE = 1024L * 1024;
    private static final String REPLAYS = "/api/v1/replays";
    private static final long RECORDING_MEGABYTES = 512;

    private final ProblemWriter problems;

    public BodyLimitFilter(ProblemWriter problems) {
        this.problems = problems;
    }

    @Override
    protected void doFilterInternal(HttpServletRequest request, HttpServletResponse response, FilterChain chain)
            throws ServletException, IOException {
        long megabytes = request.getRequestURI().equals(REPLAYS) ? RECORDING_MEGABYTES : 1;
        if (request.getContentLengthLong() > megabytes * MEGABYTE) {
            problems.write(response, Problem.of(tooLarge(megabytes)));
            return;
        }
        chain.doFilter(new Limited(request, megabytes), response);
    }

    private static Rejection tooLarge(long megabytes) {
        return new Rejection(
                RejectionKind.TOO_LARGE, "The body of this request may have at most " + megabytes + " MB.");
    }

    /** Also bounds a body whose length was not announced. */
    private static final class Limited extends HttpServletRequestWrapper {
        private final long megabytes;

        Limited(HttpServletRequest request, long megabytes) {
            super(request);
            this.megabytes = megabytes;
        }

        @Override
        public ServletInputStream getInputStream() throws IOException {
            return new Counted(super.getInputStream(), megabytes);
        }
    }

    private static final class Counted extends ServletInputStream {
        private final ServletInputStream body;
        private final long megabytes;
        private long seen;

        Counted(ServletInputStream body, long megabytes) {
            this.body = body;
            this.megabytes = megabytes;
        }

        @Override
        public int read() throws IOException {
            int value = body.read();
            count(value < 0 ? 0 : 1);
            return value;
        }

        @Override
        public int read(byte[] buffer, int offset, int length) throws IOException {
            int read = body.read(buffer, offset, length);
            count(Math.max(0, read));
            return read;
        }

        private void count(int read) {
            seen += read;
            if (seen > megabytes * MEGABYTE) {
                throw tooLarge(megabytes);
            }
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
}
