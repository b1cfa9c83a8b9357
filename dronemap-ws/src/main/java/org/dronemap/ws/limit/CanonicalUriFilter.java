package org.dronemap.ws.limit;

import jakarta.servlet.FilterChain;
import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import org.dronemap.ws.problem.ProblemView;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.RequestProblem;
import org.dronemap.ws.security.ProblemWriter;
import org.springframework.web.filter.OncePerRequestFilter;

/**
 * Rejects HTTP requests whose URI is not in its plainest form (RFC 3986, section 6.2.2). Requests are dispatched by the
 * address as it reads when decoded; whoever judges them by the address as it was sent then sees the same one.
 */
public final class CanonicalUriFilter extends OncePerRequestFilter {
    private static final int HEX = 16;
    private static final int FIRST_PRINTABLE = 0x20;
    private static final int DELETE = 0x7f;

    private final ProblemWriter problems;

    public CanonicalUriFilter(ProblemWriter problems) {
        this.problems = problems;
    }

    @Override
    protected void doFilterInternal(HttpServletRequest request, HttpServletResponse response, FilterChain chain)
            throws ServletException, IOException {
        if (isPlain(request.getRequestURI())) {
            chain.doFilter(request, response);
        } else {
            problems.write(
                    response,
                    ProblemView.of(Rejection.of(
                            RequestProblem.ADDRESS_NOT_PLAIN,
                            "The address must be written plainly: without empty, '.' or '..' parts, without ';', and"
                                    + " with '%' only for what cannot stand in an address otherwise.")));
        }
    }

    static boolean isPlain(String address) {
        if (!address.startsWith("/")) {
            return false;
        }
        String[] parts = address.substring(1).split("/", -1);
        for (int part = 0; part < parts.length; part++) {
            boolean last = part == parts.length - 1;
            if ((parts[part].isEmpty() && !last) || !isPlainPart(parts[part])) {
                return false;
            }
        }
        return true;
    }

    private static boolean isPlainPart(String part) {
        if (part.equals(".") || part.equals("..")) {
            return false;
        }
        for (int at = 0; at < part.length(); at++) {
            char letter = part.charAt(at);
            if (letter == ';' || letter == '\\') {
                return false;
            }
            if (letter == '%') {
                if (!isNeeded(part, at + 1)) {
                    return false;
                }
                at += 2;
            }
        }
        return true;
    }

    /** Whether what two digits stand for cannot be written without them. */
    private static boolean isNeeded(String part, int at) {
        if (at + 2 > part.length()) {
            return false;
        }
        int high = Character.digit(part.charAt(at), HEX);
        int low = Character.digit(part.charAt(at + 1), HEX);
        int value = HEX * high + low;
        boolean plain = value < DELETE && (Character.isLetterOrDigit(value) || "-._~".indexOf(value) >= 0);
        boolean never = value < FIRST_PRINTABLE || value == DELETE || value == '/' || value == '\\' || value == ';';
        return high >= 0 && low >= 0 && !plain && !never;
    }
}
