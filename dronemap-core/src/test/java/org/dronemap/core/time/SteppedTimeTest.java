package org.dronemap.core.time;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.TimeoutException;
import java.util.function.LongSupplier;
import org.junit.jupiter.api.Test;

class SteppedTimeTest {
    private static final Instant BEGAN = Instant.parse("2026-05-01T10:00:00Z");

    private final SteppedTime time = new SteppedTime(BEGAN);
    private final List<String> done = new ArrayList<>();

    private void note(String what) {
        done.add(what + " at " + Duration.between(BEGAN, time.clock().instant()).toMillis());
    }

    @Test
    void standsStillUntilItIsStepped() {
        Worker worker = time.worker("worker", 10);
        worker.execute(() -> note("work"));

        assertThat(done).isEmpty();
        assertThat(time.clock().instant()).isEqualTo(BEGAN);

        time.settle();

        assertThat(done).containsExactly("work at 0");
    }

    @Test
    void doesAllThatFollowsUntilNobodyHasWorkLeft() {
        Worker first = time.worker("first", 10);
        Worker second = time.worker("second", 10);
        first.execute(() -> second.execute(() -> first.execute(() -> note("third hand"))));

        time.settle();

        assertThat(done).containsExactly("third hand at 0");
    }

    @Test
    void goesFromOneThingThatIsDueToTheNextInTheirOrder() {
        Worker one = time.worker("one", 10);
        Worker other = time.worker("other", 10);
        other.after(Duration.ofMillis(20), () -> note("late"));
        one.after(Duration.ofMillis(10), () -> note("first"));
        other.after(Duration.ofMillis(10), () -> note("second"));

        time.advance(Duration.ofMillis(15));

        assertThat(done).containsExactly("first at 10", "second at 10");
        assertThat(time.nanos()).isEqualTo(15_000_000);
    }

    @Test
    void repeatsUntilItIsCalledOff() {
        ScheduledTask rounds =
                time.worker("rounds", 1).every(Duration.ZERO, Duration.ofMillis(10), () -> note("round"));
        time.advance(Duration.ofMillis(25));
        rounds.cancel();
        time.advance(Duration.ofSeconds(1));

        assertThat(done).containsExactly("round at 0", "round at 10", "round at 20");
    }

    @Test
    void goesOnAfterWhatFailsAndTellsOfIt() {
        Worker worker = time.worker("worker", 10);
        worker.execute(() -> {
            throw new IllegalStateException("broken");
        });
        worker.execute(() -> note("next"));

        time.settle();

        assertThat(done).containsExactly("next at 0");
        assertThat(time.failures()).extracting(Throwable::getMessage).containsExactly("broken");
    }

    @Test
    void whoWaitsIsNotGivenTheNextThingMeanwhile() {
        Worker asking = time.worker("asking", 10);
        Worker answering = time.worker("answering", 10);
        asking.execute(() -> {
            int answer = time.join(answering.submit(() -> 42), Duration.ofSeconds(1));
            note("answer " + answer);
        });
        asking.execute(() -> note("next"));

        time.settle();

        assertThat(done).containsExactly("answer 42 at 0", "next at 0");
    }

    @Test
    void waitsInItsOwnTime() {
        CompletableFuture<String> never = new CompletableFuture<>();

        assertThatThrownBy(() -> time.await(never, Duration.ofSeconds(10))).isInstanceOf(TimeoutException.class);
        assertThat(time.clock().instant()).isEqualTo(BEGAN.plusSeconds(10));
    }

    @Test
    void givesUpAfterItsTime() {
        CompletableFuture<String> first = time.within(new CompletableFuture<>(), Duration.ofSeconds(1), "none");
        CompletableFuture<String> second =
                time.within(CompletableFuture.completedFuture("some"), Duration.ofSeconds(1), "none");
        assertThat(first).isNotDone();

        time.advance(Duration.ofSeconds(1));

        assertThat(first).isCompletedWithValue("none");
        assertThat(second).isCompletedWithValue("some");
    }

    @Test
    void aLoopRestsUntilItIsWoken() {
        Loop loop = time.loop("loop", () -> {
            note("turn");
            return Duration.ofMillis(20).toNanos();
        });
        loop.start();
        time.advance(Duration.ofMillis(30));
        loop.wake();
        loop.wake();
        time.advance(Duration.ofMillis(15));
        loop.close();
        time.advance(Duration.ofSeconds(1));

        assertThat(done).containsExactly("turn at 0", "turn at 20", "turn at 30");
    }

    @Test
    void aWakeDuringATurnIsNotLost() {
        Loop[] loop = new Loop[1];
        loop[0] = time.loop("loop", () -> {
            note("turn");
            if (done.size() == 1) {
                loop[0].wake();
            }
            return Duration.ofSeconds(1).toNanos();
        });
        loop[0].start();
        time.settle();

        assertThat(done).containsExactly("turn at 0", "turn at 0");
    }

    @Test
    void refusesMoreThanMayWait() {
        Worker worker = time.worker("worker", 1);
        worker.execute(() -> note("one"));

        assertThatThrownBy(() -> worker.execute(() -> note("two"))).isInstanceOf(RejectedExecutionException.class);
    }

    @Test
    void whatIsClosedDoesNothingMore() {
        Worker worker = time.worker("worker", 10);
        worker.execute(() -> note("work"));
        worker.after(Duration.ofMillis(1), () -> note("later"));
        worker.close();
        time.advance(Duration.ofSeconds(1));

        assertThat(done).isEmpty();
        assertThatThrownBy(() -> worker.execute(() -> note("more"))).isInstanceOf(RejectedExecutionException.class);
    }

    @Test
    void whatFinishesDoesWhatWaitsAndNothingThatIsDueLater() {
        Worker worker = time.worker("worker", 10);
        worker.after(Duration.ofMillis(1), () -> note("later"));
        worker.execute(() -> note("work"));

        assertThat(worker.finish(Duration.ofSeconds(1))).isTrue();
        time.advance(Duration.ofSeconds(1));
        assertThat(done).containsExactly("work at 0");
    }

    @Test
    void effortIsCountedInLooksAndNotInTime() {
        LongSupplier effort = time.effort();
        long began = effort.getAsLong();
        int looks = 1;
        while (effort.getAsLong() - began < Duration.ofSeconds(1).toNanos()) {
            looks++;
        }

        assertThat(looks).isEqualTo(250);
        assertThat(time.nanos()).isZero();
    }

    @Test
    void workWithoutEndIsTold() {
        Worker worker = time.worker("worker", 10);
        Runnable[] again = new Runnable[1];
        again[0] = () -> worker.execute(again[0]);
        worker.execute(again[0]);

        assertThatThrownBy(time::settle).isInstanceOf(IllegalStateException.class);
    }

    @Test
    void belongsToOneThread() throws InterruptedException {
        Worker worker = time.worker("worker", 10);
        List<Throwable> thrown = new ArrayList<>();
        Thread other = new Thread(() -> worker.execute(() -> {}));
        other.setUncaughtExceptionHandler((thread, failure) -> thrown.add(failure));
        other.start();
        other.join();

        assertThat(thrown).hasSize(1);
    }

    @Test
    void whatIsKilledDoesNothingMoreAndOthersGoOn() {
        SteppedTime.Killable process = time.killable();
        Worker killed = process.worker("killed", 10);
        killed.execute(() -> note("killed"));
        killed.every(Duration.ofMillis(1), Duration.ofMillis(1), () -> note("killed round"));
        process.loop("killed loop", () -> {
                    note("killed turn");
                    return 1;
                })
                .start();
        time.worker("other", 10).after(Duration.ofMillis(5), () -> note("other"));
        process.kill();
        time.advance(Duration.ofSeconds(1));

        assertThat(done).containsExactly("other at 5");
    }

    @Test
    void nobodyStepsWhatWaitsForBytes() {
        assertThatThrownBy(() -> time.blocking("socket", () -> {})).isInstanceOf(UnsupportedOperationException.class);
    }
}
