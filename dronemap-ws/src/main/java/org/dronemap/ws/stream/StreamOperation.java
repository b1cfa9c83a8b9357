package org.dronemap.ws.stream;

import java.util.function.Consumer;
import org.dronemap.core.access.Principal;
import org.jspecify.annotations.Nullable;

/**
 * One kind of request on the WebSocket stream that is carried out by a feature, which declares it beside its use case, as
 * a bean. {@link StreamRequestHandler} judges each by the access rule of its type before it is handled.
 *
 * @param notes adds what was asked to the record of the call, before it is judged; {@link StreamAuditNotes} has done so
 *     with its type and its drone
 * @param handler carries it out
 */
public record StreamOperation<R extends StreamRequest.OfUseCase>(
        StreamRequestType<R> type, Consumer<R> notes, Handler<R> handler) {
    /** Carries out a request that its sender may send. Any thread. */
    @FunctionalInterface
    public interface Handler<R> {
        /** The answer; null: none. A rejection is answered as such. */
        @Nullable
        StreamMessage handle(StreamConnection connection, Principal principal, R request);
    }

    /** For requests of which the record of the call says no more than type and drone. */
    public static <R extends StreamRequest.OfUseCase> StreamOperation<R> of(
            StreamRequestType<R> type, Handler<R> handler) {
        return new StreamOperation<>(type, request -> {}, handler);
    }

    void note(StreamRequest request) {
        notes.accept(type.request().cast(request));
    }

    @Nullable
    StreamMessage handle(StreamConnection connection, Principal principal, StreamRequest request) {
        return handler.handle(connection, principal, type.request().cast(request));
    }
}
