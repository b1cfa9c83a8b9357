package org.dronemap.ws.testserver;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.dronemap.ws.recording.ReplayGateway;
import org.dronemap.ws.recording.ReplayView;

/** Plays nothing: counts the bytes of a recording and calls it finished. */
public final class CountingReplayGateway implements ReplayGateway {
    private static final int MOST = 100;

    private final ConcurrentHashMap<String, ReplayView> all = new ConcurrentHashMap<>();

    @Override
    public ReplayView start(String name, InputStream recording, long lengthBytes, double speed) {
        if (all.size() >= MOST) {
            throw new IllegalStateException(MOST + " recordings play already; wait for one to end, or cancel one.");
        }
        try (recording) {
            long bytes = recording.readAllBytes().length;
            String id = "r" + (all.size() + 1);
            ReplayView view = new ReplayView(id, name, speed, List.of(), "finished", bytes, bytes, 0, 0, 1, null);
            all.put(id, view);
            return view;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @Override
    public List<ReplayView> all() {
        return List.copyOf(all.values());
    }

    @Override
    public Optional<ReplayView> find(String id) {
        return Optional.ofNullable(all.get(id));
    }

    @Override
    public boolean remove(String id) {
        return all.remove(id) != null;
    }
}
