package org.dronemap.ws.soap;

import java.util.Map;
import java.util.Optional;
import org.dronemap.ws.problem.Rejection;

/**
 * A request that SOAP makes to the REST API within the server. Immutable, but for the bytes of a body, which nobody
 * changes.
 */
final class RestRequest {
    private final String method;
    private final String uri;
    private final Map<String, String> query;
    private final Optional<Body> body;
    private final Optional<Rejection> refusal;

    /** {@code uri}: encoded; the values of {@code query} are not. */
    RestRequest(String method, String uri, Map<String, String> query) {
        this(method, uri, query, Optional.empty(), Optional.empty());
    }

    private RestRequest(
            String method, String uri, Map<String, String> query, Optional<Body> body, Optional<Rejection> refusal) {
        this.method = method;
        this.uri = uri;
        this.query = query;
        this.body = body;
        this.refusal = refusal;
    }

    RestRequest with(String mediaType, byte[] bytes) {
        return new RestRequest(method, uri, query, Optional.of(new Body(mediaType, bytes)), refusal);
    }

    /** The same, which is refused once it is known that its caller may make it. */
    RestRequest refused(Rejection why) {
        return new RestRequest(method, uri, query, body, Optional.of(why));
    }

    Optional<Rejection> refusal() {
        return refusal;
    }

    String method() {
        return method;
    }

    String uri() {
        return uri;
    }

    Map<String, String> query() {
        return query;
    }

    Optional<Body> body() {
        return body;
    }

    static final class Body {
        private final String mediaType;
        private final byte[] bytes;

        private Body(String mediaType, byte[] bytes) {
            this.mediaType = mediaType;
            this.bytes = bytes;
        }

        String mediaType() {
            return mediaType;
        }

        byte[] bytes() {
            return bytes;
        }
    }
}
