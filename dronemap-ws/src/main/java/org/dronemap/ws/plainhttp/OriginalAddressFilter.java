package org.dronemap.ws.plainhttp;

import jakarta.servlet.FilterChain;
import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletRequestWrapper;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.dronemap.ws.problem.ProblemView;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.RequestProblem;
import org.dronemap.ws.security.ProblemWriter;
import org.springframework.web.filter.OncePerRequestFilter;

/**
 * Serves the SOAP services also at the ports and paths of the original Dronemap Planner, for programs written for it.
 * What they call is judged as anywhere else: by the key or the password of a user.
 */
public final class OriginalAddressFilter extends OncePerRequestFilter {
    /** Its REST had paths that nobody wrote down: at its port are those of this server. */
    private static final int REST_PORT = 6060;

    private static final String SERVICES_PATH = "/services";

    private record Address(String path, String service) {}

    private static final Map<Integer, Address> ADDRESSES = Map.of(
            3030, new Address("/MAVLinkControllerService", "/MAVLinkControllerService"),
            10500, new Address("/ApplicationsService", "/ApplicationWS"),
            // As it was spelt there.
            7070, new Address("/RSOLinkCloudManagementService", "/FleetService"));

    private final ProblemWriter problems;

    public OriginalAddressFilter(ProblemWriter problems) {
        this.problems = problems;
    }

    /** Those that are opened for it, beside the server's own. */
    public static Set<Integer> ports() {
        return Set.of(3030, 10500, 7070, REST_PORT);
    }

    /** The paths, whatever the port. */
    public static List<String> paths() {
        return ADDRESSES.values().stream().map(Address::path).toList();
    }

    /** A call that waited for its outcome comes by once more. */
    @Override
    protected boolean shouldNotFilterAsyncDispatch() {
        return false;
    }

    @Override
    protected void doFilterInternal(HttpServletRequest request, HttpServletResponse response, FilterChain chain)
            throws ServletException, IOException {
        Address address = ADDRESSES.get(request.getLocalPort());
        if (address == null) {
            chain.doFilter(request, response);
        } else if (address.path().equals(request.getRequestURI())) {
            chain.doFilter(new RewrittenRequest(request, address.service()), response);
        } else {
            problems.write(
                    response,
                    ProblemView.of(Rejection.of(
                            RequestProblem.ADDRESS_UNKNOWN,
                            "There is nothing at " + request.getRequestURI() + " on this port; it has " + address.path()
                                    + ".")));
        }
    }

    /** The request at the address of this server that is meant. Its URL stays as the caller has it. */
    private static final class RewrittenRequest extends HttpServletRequestWrapper {
        private final String service;

        RewrittenRequest(HttpServletRequest request, String service) {
            super(request);
            this.service = service;
        }

        @Override
        public String getRequestURI() {
            return SERVICES_PATH + service;
        }

        @Override
        public String getServletPath() {
            return SERVICES_PATH;
        }

        @Override
        public String getPathInfo() {
            return service;
        }
    }
}
