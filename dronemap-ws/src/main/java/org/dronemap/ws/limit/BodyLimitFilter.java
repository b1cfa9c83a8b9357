package org.dronemap.ws.limit;

import jakarta.servlet.FilterChain;
import jakarta.servlet.ServletException;
import jakarta.servlet.ServletInputStream;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletRequestWrapper;
import jakarta.servlet.http.HttpServletResponse;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.Set;
import org.dronemap.ws.problem.ProblemView;
import org.dronemap.ws.security.ProblemWriter;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.springframework.web.filter.OncePerRequestFilter;

/**
 * Limits size and duration of HTTP request bodies: 1 MB, 4 MB for a file of zones, 512 MB for a
 * recording, 64 kB where no sign-in is needed. What
 * nobody has read is thrown away after the answer, within bounds too.
 */
public final class BodyLimitFilter extends OncePerRequestFilter {
    static final long KILOBYTE = 1024;
    static final long MEGABYTE = 1024 * KILOBYTE;
    private static final Logger LOG = LoggerFactory.getLogger(BodyLimitFilter.class);
    private static final String REPLAYS = "/api/v1/replays";
    private static final Set<String> OPEN_TO_ANYBODY = Set.of("/api/v1/session", "/api/v1/registrations");
    private static final String ZONE_FILES = "/api/v1/zones/import";
    private static final long LARGEST = MEGABYTE;
    /** Airspaces of a country have 1.4 MB. */
    private static final long LARGEST_ZONE_FILE = 4 * MEGABYTE;

    private static final long LARGEST_RECORDING = 512 * MEGABYTE;
    private static final long LARGEST_OF_ANYBODY = 64 * KILOBYTE;
    private static final long MOST_THROWN_AWAY = 16 * MEGABYTE;

    private final ProblemWriter problems;
    private final ClientLimits limits;

    public BodyLimitFilter(ProblemWriter problems, ClientLimits limits) {
        this.problems = problems;
        this.limits = limits;
    }

    @Override
    protected void doFilterInternal(HttpServletRequest request, HttpServletResponse response, FilterChain chain)
            throws ServletException, IOException {
        long most = largest(request.getRequestURI());
        Limited limited = new Limited(request, most, limits);
        if (request.getContentLengthLong() > most) {
            response.setHeader("Connection", "close");
            problems.write(response, ProblemView.of(BoundedBody.tooLarge(most)));
        } else {
            chain.doFilter(limited, response);
        }
        if (!request.isAsyncStarted() && hasBody(request)) {
            response.flushBuffer();
            throwAway(limited);
        }
    }

    private static long largest(String address) {
        if (address.equals(REPLAYS)) {
            return LARGEST_RECORDING;
        }
        if (address.equals(ZONE_FILES)) {
            return LARGEST_ZONE_FILE;
        }
        return OPEN_TO_ANYBODY.contains(address) ? LARGEST_OF_ANYBODY : LARGEST;
    }

    private static boolean hasBody(HttpServletRequest request) {
        return request.getContentLengthLong() > 0 || request.getHeader("Transfer-Encoding") != null;
    }

    private static void throwAway(Limited request) {
        try {
            if (!request.getInputStream().isFinished()
                    && !request.getInputStream().drain(MOST_THROWN_AWAY)) {
                LOG.debug("A client went on sending what nobody wants");
            }
        } catch (IOException gone) {
            LOG.debug("A client left before it had sent all: {}", gone.getMessage());
        }
    }

    /** Also bounds a body whose length was not announced. */
    private static final class Limited extends HttpServletRequestWrapper {
        private final long most;
        private final ClientLimits limits;
        private @Nullable BoundedBody body;
        private @Nullable BufferedReader reader;

        Limited(HttpServletRequest request, long most, ClientLimits limits) {
            super(request);
            this.most = most;
            this.limits = limits;
        }

        @Override
        public BoundedBody getInputStream() throws IOException {
            BoundedBody bounded = body;
            if (bounded == null) {
                ServletInputStream whole = super.getInputStream();
                bounded = new BoundedBody(whole, most, limits);
                body = bounded;
            }
            return bounded;
        }

        @Override
        public BufferedReader getReader() throws IOException {
            BufferedReader bounded = reader;
            if (bounded == null) {
                String encoding = getCharacterEncoding();
                String known = encoding == null ? StandardCharsets.UTF_8.name() : encoding;
                bounded = new BufferedReader(new InputStreamReader(getInputStream(), known));
                reader = bounded;
            }
            return bounded;
        }
    }
}
