package org.dronemap.ws.stream.delivery;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * Bounded queue of messages to one stream client: only the newest state of each thing, all commands and answers. Any
 * thread.
 */
public final class StreamClientOutbox {
    public static final int MOST_DISCRETE = 1_000;

    // all guarded by this
    private final Deque<Message> discrete = new ArrayDeque<>();
    private final Map<StreamMessageSubject, String> newest = new LinkedHashMap<>();
    private @Nullable String beat;
    private long replaced;
    private boolean overflown;

    /** {@code about}: null when no thing alone. */
    private record Message(@Nullable StreamMessageSubject about, String json) {}

    /** A picture that the next one of the same thing replaces. */
    public synchronized void offer(StreamMessageSubject about, String json) {
        if (newest.put(about, json) != null) {
            replaced++;
        }
    }

    /** A sign of life that the next one replaces: who is slow to read is not given more to read for it. */
    public synchronized void beat(String json) {
        beat = json;
    }

    /** No picture of what is gone. */
    public synchronized void forget(StreamMessageSubject about) {
        newest.remove(about);
    }

    /** Nothing at all of what this client may see no longer. */
    public synchronized void withhold(StreamMessageSubject about) {
        newest.remove(about);
        discrete.removeIf(message -> about.equals(message.about()));
    }

    /** Something that must arrive; when there is no room for it the client is to be closed. */
    public void add(String json) {
        add(null, json);
    }

    /** The same, of one thing. */
    public synchronized void add(@Nullable StreamMessageSubject about, String json) {
        if (discrete.size() == MOST_DISCRETE) {
            overflown = true;
        } else {
            discrete.add(new Message(about, json));
        }
    }

    /** All that waits: first what must arrive, then the pictures, at last the sign of life. */
    public synchronized List<String> drain() {
        List<String> all = new ArrayList<>(discrete.size() + newest.size() + 1);
        discrete.forEach(message -> all.add(message.json()));
        all.addAll(newest.values());
        if (beat != null) {
            all.add(beat);
        }
        clear();
        return all;
    }

    public synchronized void clear() {
        discrete.clear();
        newest.clear();
        beat = null;
    }

    public synchronized boolean isEmpty() {
        return discrete.isEmpty() && newest.isEmpty() && beat == null;
    }

    public synchronized boolean isOverflown() {
        return overflown;
    }

    /** Pictures that a newer one replaced before they were sent. */
    synchronized long replacedCount() {
        return replaced;
    }
}
