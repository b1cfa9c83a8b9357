package org.dronemap.ws.stream.delivery;

import java.util.Optional;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;

/** Takes changes from the source of a stream topic, to be sent to clients. Any thread. */
public interface StreamTopicSink<T> {
    /** Its newest state is told at its next turn; {@code thing} is asked then, empty: nothing is told. */
    void changed(String id, Supplier<Optional<T>> thing);

    /** Its newest state is told now. */
    void changedAtOnce(String id, Supplier<Optional<T>> thing);

    /** Whoever was shown it is told that it is gone, where the topic says something of that. */
    void removed(String id);

    /** Something that must arrive. */
    void publish(T now);

    /**
     * The same, of a thing that had another form before or is none any more: whoever saw that and does not see this is told
     * that it is gone, where the topic says something of that.
     */
    void publish(@Nullable T former, @Nullable T now);
}
