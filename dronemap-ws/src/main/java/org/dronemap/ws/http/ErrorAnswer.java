package org.dronemap.ws.http;

import io.swagger.v3.oas.annotations.Hidden;
import jakarta.servlet.RequestDispatcher;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.util.Optional;
import org.dronemap.ws.access.About;
import org.dronemap.ws.access.Access;
import org.dronemap.ws.access.From;
import org.dronemap.ws.problem.Outages;
import org.dronemap.ws.problem.Problem;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.RejectionKind;
import org.jspecify.annotations.Nullable;
import org.springframework.boot.webmvc.error.ErrorController;
import org.springframework.http.MediaType;
import org.springframework.http.ResponseEntity;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RestController;

/** The last resort: what went wrong before any controller was reached. */
@Hidden
@RestController
public class ErrorAnswer implements ErrorController {
    /** Null when an answer is on its way already, of which nothing can be taken back. */
    @RequestMapping("/error")
    @Access(from = From.ANYBODY, about = About.NONE)
    public @Nullable ResponseEntity<Problem> error(HttpServletRequest request, HttpServletResponse response) {
        if (response.isCommitted()) {
            return null;
        }
        Object code = request.getAttribute(RequestDispatcher.ERROR_STATUS_CODE);
        int status = code instanceof Integer number ? number : RejectionKind.UNKNOWN.status();
        Object thrown = request.getAttribute(RequestDispatcher.ERROR_EXCEPTION);
        Problem problem = (thrown instanceof Throwable cause ? Outages.of(cause) : Optional.<Rejection>empty())
                .map(Problem::of)
                .orElseGet(() -> Problem.ofStatus(status));
        return ResponseEntity.status(problem.status())
                .contentType(MediaType.APPLICATION_PROBLEM_JSON)
                .body(problem);
    }
}
