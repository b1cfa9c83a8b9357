package org.dronemap.ws.http;

import io.swagger.v3.oas.annotations.Hidden;
import jakarta.servlet.RequestDispatcher;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.util.Optional;
import org.dronemap.ws.access.Access;
import org.dronemap.ws.access.AccessLevel;
import org.dronemap.ws.access.ResourceScope;
import org.dronemap.ws.problem.OutageClassifier;
import org.dronemap.ws.problem.ProblemView;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.RejectionKind;
import org.jspecify.annotations.Nullable;
import org.springframework.boot.webmvc.error.ErrorController;
import org.springframework.http.MediaType;
import org.springframework.http.ResponseEntity;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RestController;

/** Answers errors that occurred before any REST handler was reached, in the problem format of the API. */
@Hidden
@RestController
public class FallbackErrorController implements ErrorController {
    /** Null when an answer is on its way already, of which nothing can be taken back. */
    @RequestMapping("/error")
    @Access(from = AccessLevel.ANYBODY, about = ResourceScope.NONE)
    public @Nullable ResponseEntity<ProblemView> error(HttpServletRequest request, HttpServletResponse response) {
        if (response.isCommitted()) {
            return null;
        }
        Object code = request.getAttribute(RequestDispatcher.ERROR_STATUS_CODE);
        int status = code instanceof Integer number ? number : RejectionKind.UNKNOWN.status();
        Object thrown = request.getAttribute(RequestDispatcher.ERROR_EXCEPTION);
        ProblemView problem = (thrown instanceof Throwable cause
                        ? OutageClassifier.of(cause)
                        : Optional.<Rejection>empty())
                .map(ProblemView::of)
                .orElseGet(() -> ProblemView.ofStatus(status));
        return ResponseEntity.status(problem.status())
                .contentType(MediaType.APPLICATION_PROBLEM_JSON)
                .body(problem);
    }
}
