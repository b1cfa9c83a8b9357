package org.dronemap.ws.stream;

import java.util.Optional;
import org.dronemap.ws.reading.WireNames;
import org.jspecify.annotations.Nullable;

/** Kinds of requests on the WebSocket stream; {@link StreamAccessRules} has the access rule of each. */
public enum StreamRequestKind {
    AUTHENTICATE(StreamMessage.Hello.class),
    COMMAND(StreamMessage.CommandAccepted.class),
    CONTROL(StreamMessage.ControlAnswer.class),
    STEER(null),
    LET_GO(null),
    POSITIONS(StreamMessage.PositionsReceived.class),
    SUBSCRIBE(null),
    PING(StreamMessage.Pong.class);

    private final @Nullable Class<? extends StreamMessage> answer;

    /** {@code answer}: null when only a refusal is answered. */
    StreamRequestKind(@Nullable Class<? extends StreamMessage> answer) {
        this.answer = answer;
    }

    /** How it is answered when it is carried out. */
    public Optional<Class<? extends StreamMessage>> answer() {
        return Optional.ofNullable(answer);
    }

    /** As clients call it. */
    public String word() {
        return WireNames.camel(this);
    }
}
