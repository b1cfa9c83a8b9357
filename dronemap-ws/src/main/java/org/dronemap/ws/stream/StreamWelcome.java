package org.dronemap.ws.stream;

import java.util.Map;
import java.util.function.Function;
import org.dronemap.core.access.Principal;
import org.dronemap.ws.stream.delivery.StreamMessageSubject;

/**
 * Message that a client of the WebSocket stream gets once after hello, before topics tell of anything; a feature declares
 * its own, as a bean.
 *
 * @param message its type
 * @param greeting what somebody is told
 */
public record StreamWelcome(Class<? extends StreamMessage> message, Function<Principal, Greeting> greeting) {
    /**
     * The message for one user.
     *
     * @param sights what it shows, each as {@link StreamTopic.Sight} says: the topic of such things counts them as shown
     */
    public record Greeting(StreamMessage message, Map<StreamMessageSubject, Object> sights) {}
}
