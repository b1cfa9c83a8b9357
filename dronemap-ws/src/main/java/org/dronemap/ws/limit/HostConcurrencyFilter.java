package org.dronemap.ws.limit;

import jakarta.servlet.FilterChain;
import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.net.InetAddress;
import java.time.Duration;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.LongAdder;
import org.dronemap.core.link.ClientHost;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.ProblemView;
import org.dronemap.ws.problem.RateLimitRejection;
import org.dronemap.ws.problem.ServerProblem;
import org.dronemap.ws.security.ProblemWriter;
import org.springframework.web.filter.OncePerRequestFilter;

/** Limits how many HTTP requests of one client host are served at once, so that slow ones cannot hold all threads. */
public final class HostConcurrencyFilter extends OncePerRequestFilter {
    private final ProblemWriter problems;
    private final int most;
    /** Only of hosts that are being answered. */
    private final ConcurrentHashMap<ClientHost, Integer> atWork = new ConcurrentHashMap<>();

    private final LongAdder refused = new LongAdder();

    public HostConcurrencyFilter(ProblemWriter problems, ClientLimits limits) {
        this.problems = problems;
        this.most = limits.requestsPerHost();
    }

    /** Requests of hosts that had too many others. */
    public long refusedCount() {
        return refused.sum();
    }

    @Override
    protected void doFilterInternal(HttpServletRequest request, HttpServletResponse response, FilterChain chain)
            throws ServletException, IOException {
        // A literal: nobody is asked for it.
        ClientHost host =
                ClientHost.of(InetAddress.getByName(request.getRemoteAddr()).getAddress());
        int now = atWork.merge(host, 1, Integer::sum);
        try {
            if (now > most) {
                refused.increment();
                problems.write(
                        response,
                        ProblemView.of(RateLimitRejection.of(
                                ServerProblem.ADDRESS_CROWDED,
                                "More than " + most + " requests of your address are being answered",
                                Duration.ofSeconds(1),
                                ProblemParameter.MOST.is(most))));
                return;
            }
            chain.doFilter(request, response);
        } finally {
            atWork.computeIfPresent(host, (unused, before) -> before == 1 ? null : before - 1);
        }
    }
}
