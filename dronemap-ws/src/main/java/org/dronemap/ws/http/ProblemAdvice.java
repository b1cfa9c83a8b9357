package org.dronemap.ws.http;

import jakarta.servlet.http.HttpServletRequest;
import java.util.Set;
import java.util.concurrent.CompletionException;
import java.util.stream.Collectors;
import org.apache.tomcat.util.http.InvalidParameterException;
import org.dronemap.core.time.FatalErrors;
import org.dronemap.ws.access.AuditNotes;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.OutageClassifier;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.ProblemView;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.RejectionKind;
import org.dronemap.ws.problem.RequestProblem;
import org.dronemap.ws.problem.ValueProblem;
import org.dronemap.ws.reading.JsonCodec;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.springframework.http.HttpHeaders;
import org.springframework.http.HttpMethod;
import org.springframework.http.MediaType;
import org.springframework.http.ResponseEntity;
import org.springframework.http.converter.HttpMessageNotReadableException;
import org.springframework.validation.FieldError;
import org.springframework.web.HttpMediaTypeNotAcceptableException;
import org.springframework.web.HttpMediaTypeNotSupportedException;
import org.springframework.web.HttpRequestMethodNotSupportedException;
import org.springframework.web.bind.MethodArgumentNotValidException;
import org.springframework.web.bind.MissingServletRequestParameterException;
import org.springframework.web.bind.annotation.ExceptionHandler;
import org.springframework.web.bind.annotation.RestControllerAdvice;
import org.springframework.web.context.request.async.AsyncRequestNotUsableException;
import org.springframework.web.method.annotation.MethodArgumentTypeMismatchException;
import org.springframework.web.servlet.resource.NoResourceFoundException;
import tools.jackson.core.JacksonException;

/** Turns every exception of a REST handler into a problem response with a code and a sentence, never a stack trace. */
@RestControllerAdvice
public class ProblemAdvice {
    private static final Logger LOG = LoggerFactory.getLogger(ProblemAdvice.class);

    @ExceptionHandler(Rejection.class)
    public ResponseEntity<ProblemView> rejected(Rejection rejection) {
        return answer(rejection);
    }

    @ExceptionHandler(HttpMessageNotReadableException.class)
    public ResponseEntity<ProblemView> unreadable(HttpMessageNotReadableException e) {
        // The reader of JSON wraps what the body itself said of its length or its slowness.
        Rejection ofBody = causeOf(e, Rejection.class);
        if (ofBody != null) {
            return answer(ofBody);
        }
        JacksonException json = causeOf(e, JacksonException.class);
        return answer(
                json == null
                        ? Rejection.of(
                                RequestProblem.BODY_NOT_AN_OBJECT,
                                "A JSON object is needed as the body of this request.")
                        : JsonCodec.rejection(json));
    }

    private static <T extends Throwable> @Nullable T causeOf(Throwable thrown, Class<T> kind) {
        for (Throwable cause = thrown.getCause(); cause != null; cause = cause.getCause()) {
            if (kind.isInstance(cause)) {
                return kind.cast(cause);
            }
        }
        return null;
    }

    @ExceptionHandler(MethodArgumentTypeMismatchException.class)
    public ResponseEntity<ProblemView> wrongParameter(MethodArgumentTypeMismatchException e) {
        return answer(malformed(e.getName(), e.getRequiredType(), e.getValue()));
    }

    /** A parameter that is a member of a record. */
    @ExceptionHandler(MethodArgumentNotValidException.class)
    public ResponseEntity<ProblemView> wrongParameter(MethodArgumentNotValidException e) {
        FieldError wrong = e.getBindingResult().getFieldErrors().get(0);
        Class<?> type = e.getBindingResult().getFieldType(wrong.getField());
        return answer(malformed(wrong.getField(), type, wrong.getRejectedValue()));
    }

    private static Rejection malformed(String name, @Nullable Class<?> type, @Nullable Object value) {
        boolean number = type != null && (Number.class.isAssignableFrom(type) || type.isPrimitive());
        return InvalidInput.outside(
                ValueProblem.VALUE_MALFORMED, name, number ? "a number" : "another value", "\"" + value + "\"");
    }

    @ExceptionHandler(MissingServletRequestParameterException.class)
    public ResponseEntity<ProblemView> missingParameter(MissingServletRequestParameterException e) {
        return answer(InvalidInput.missing(e.getParameterName(), "given in the address"));
    }

    @ExceptionHandler(HttpRequestMethodNotSupportedException.class)
    public ResponseEntity<ProblemView> wrongMethod(HttpRequestMethodNotSupportedException e) {
        Set<HttpMethod> supported = e.getSupportedHttpMethods();
        String allowed = supported == null
                ? "another method"
                : supported.stream().map(HttpMethod::name).sorted().collect(Collectors.joining(", "));
        Rejection rejection = Rejection.of(
                RequestProblem.METHOD_NOT_TAKEN,
                "This address does not take " + e.getMethod() + "; it takes " + allowed + ".",
                ProblemParameter.METHOD.is(e.getMethod()),
                ProblemParameter.ALLOWED.is(allowed));
        return ResponseEntity.status(RejectionKind.METHOD.status())
                .header("Allow", allowed)
                .contentType(MediaType.APPLICATION_PROBLEM_JSON)
                .body(ProblemView.of(rejection));
    }

    @ExceptionHandler(HttpMediaTypeNotSupportedException.class)
    public ResponseEntity<ProblemView> wrongContent(HttpMediaTypeNotSupportedException e) {
        String allowed = e.getSupportedMediaTypes().stream()
                .map(MediaType::toString)
                .filter(type -> !type.contains("+") && !type.contains("*") && !type.contains("yaml"))
                .distinct()
                .collect(Collectors.joining(" or "));
        return answer(Rejection.of(
                RequestProblem.CONTENT_TYPE_NOT_TAKEN,
                "The body must be " + allowed + "; say so in Content-Type.",
                ProblemParameter.ALLOWED.is(allowed)));
    }

    /** The web server's own reader, of the query and of forms, which no address takes. */
    @ExceptionHandler(InvalidParameterException.class)
    public ResponseEntity<ProblemView> unreadableParameters(InvalidParameterException e, HttpServletRequest request) {
        String content = request.getContentType();
        if (content == null || !content.contains("form")) {
            return answer(Rejection.of(
                    RequestProblem.REQUEST_UNREADABLE,
                    "What stands behind the '?' of the address cannot be read; it must be NAME=VALUE, more of them after a"
                            + " '&' each."));
        }
        return answer(Rejection.of(
                RequestProblem.CONTENT_TYPE_NOT_TAKEN,
                "No address here takes forms; send JSON.",
                ProblemParameter.ALLOWED.is(MediaType.APPLICATION_JSON_VALUE)));
    }

    @ExceptionHandler(HttpMediaTypeNotAcceptableException.class)
    public ResponseEntity<ProblemView> wrongAccept(HttpMediaTypeNotAcceptableException e) {
        return answer(Rejection.of(
                RequestProblem.ANSWER_TYPE_NOT_SERVED, "The answer is JSON; the Accept header rules that out."));
    }

    @ExceptionHandler(NoResourceFoundException.class)
    public ResponseEntity<ProblemView> noSuchAddress(HttpServletRequest request) {
        return answer(Rejection.of(
                RequestProblem.ADDRESS_UNKNOWN,
                "There is nothing at " + request.getRequestURI() + "; /api/docs lists the addresses.",
                ProblemParameter.ADDRESS.is(request.getRequestURI())));
    }

    /** The client went away while the answer was on its way: nobody to answer. */
    @ExceptionHandler(AsyncRequestNotUsableException.class)
    public void gone(AsyncRequestNotUsableException e) {
        LOG.debug("A client went away: {}", e.getMessage());
    }

    @ExceptionHandler(Exception.class)
    public ResponseEntity<ProblemView> broken(Exception e, HttpServletRequest request) {
        FatalErrors.reportCause(e);
        Throwable cause = e instanceof CompletionException ? e.getCause() : e;
        if (cause instanceof Rejection rejection) {
            return answer(rejection);
        }
        Rejection outage = OutageClassifier.of(e).orElse(null);
        if (outage != null) {
            LOG.warn(
                    "{} {} came while the store was away: {}",
                    request.getMethod(),
                    request.getRequestURI(),
                    String.valueOf(e.getMessage()));
            return answer(outage);
        }
        LOG.error("{} {} failed", request.getMethod(), request.getRequestURI(), e);
        return body(ProblemView.internal());
    }

    private static ResponseEntity<ProblemView> answer(@Nullable Rejection rejection) {
        return body(rejection == null ? ProblemView.internal() : ProblemView.of(rejection));
    }

    private static ResponseEntity<ProblemView> body(ProblemView problem) {
        AuditNotes.turnedAway(problem);
        ResponseEntity.BodyBuilder answer =
                ResponseEntity.status(problem.status()).contentType(MediaType.APPLICATION_PROBLEM_JSON);
        Long wait = problem.retryAfterSeconds();
        if (wait != null) {
            answer.header(HttpHeaders.RETRY_AFTER, wait.toString());
        }
        return answer.body(problem);
    }
}
