package org.dronemap.store.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.recording.Recording;
import org.dronemap.core.recording.RecordingStore;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** What every {@link RecordingStore} keeps to. */
public abstract class RecordingStoreContract {
    private static final Instant START = Instant.parse("2026-03-04T05:06:07.123456Z");

    private RecordingStore store;

    /** An empty store. */
    protected abstract RecordingStore emptyStore();

    @BeforeEach
    void open() {
        store = emptyStore();
    }

    @Test
    void isEmptyAtFirst() {
        assertThat(store.recordings()).isEmpty();
        assertThat(store.recording("r1")).isEmpty();
    }

    @Test
    void givesBackOneThatGoesOn() {
        Recording recording = recording("r1", START, null, Recording.State.RUNNING, null);
        store.save(recording);
        assertThat(store.recording("r1")).contains(recording);
        assertThat(store.recordings()).containsExactly(recording);
    }

    @Test
    void replacesItWhenItHasEnded() {
        store.save(recording("r1", START, null, Recording.State.RUNNING, null));
        Recording ended =
                recording("r1", START, START.plusSeconds(61), Recording.State.INCOMPLETE, "Contact was lost.");
        store.save(ended);
        assertThat(store.recordings()).containsExactly(ended);
    }

    @Test
    void keepsSizesBeyondFourGigabytes() {
        Recording large = new Recording(
                "r1",
                new DroneId("d1"),
                "Copter 1",
                START,
                START,
                9_000_000_000L,
                5_000_000_000L,
                3_000_000_000L,
                Recording.State.COMPLETE,
                null);
        store.save(large);
        assertThat(store.recording("r1")).contains(large);
    }

    @Test
    void listsTheNewestFirst() {
        store.save(recording("b", START, START, Recording.State.COMPLETE, null));
        store.save(recording("c", START.plusSeconds(1), null, Recording.State.RUNNING, null));
        store.save(recording("a", START, START, Recording.State.COMPLETE, null));
        assertThat(store.recordings()).extracting(Recording::id).containsExactly("c", "b", "a");
    }

    @Test
    void cutsTimesToMicrosecondsInEveryAdapterAlike() {
        store.save(recording("r1", START.plusNanos(999), START.plusNanos(1_999), Recording.State.COMPLETE, null));
        Recording kept = store.recording("r1").orElseThrow();
        assertThat(kept.start()).isEqualTo(START);
        assertThat(kept.end()).isEqualTo(START.plusNanos(1_000));
    }

    @Test
    void deletesAndSaysWhetherThereWasOne() {
        store.save(recording("r1", START, START, Recording.State.COMPLETE, null));
        assertThat(store.delete("r1")).isTrue();
        assertThat(store.delete("r1")).isFalse();
        assertThat(store.recordings()).isEmpty();
    }

    private static Recording recording(
            String id, Instant start, @Nullable Instant end, Recording.State state, @Nullable String notice) {
        return new Recording(id, new DroneId("d1"), "Copter 1", start, end, 4_711, 42, 0, state, notice);
    }
}
