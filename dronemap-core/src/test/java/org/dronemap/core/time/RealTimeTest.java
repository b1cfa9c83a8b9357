package org.dronemap.core.time;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;

class RealTimeTest {
    private static final Duration LONG = Duration.ofSeconds(30);

    private final RealTime time = new RealTime();
    private final List<String> done = new CopyOnWriteArrayList<>();

    @Test
    void aWorkerKeepsTheOrderAndGoesOnAfterAFailure() {
        Worker worker = time.worker("worker", 10);
        worker.execute(() -> done.add("one"));
        worker.execute(() -> {
            throw new IllegalStateException("on purpose");
        });
        worker.execute(() -> done.add("two"));

        assertThat(worker.finish(LONG)).isTrue();
        assertThat(done).containsExactly("one", "two");
    }

    @Test
    void aWorkerThatFinishesDoesWhatWaitsAndNothingThatIsDueLater() {
        Worker worker = time.worker("worker", 10);
        CountDownLatch begun = new CountDownLatch(1);
        CountDownLatch mayEnd = new CountDownLatch(1);
        worker.execute(() -> {
            begun.countDown();
            waitFor(mayEnd);
        });
        worker.execute(() -> done.add("waiting"));
        worker.after(Duration.ofHours(1), () -> done.add("later"));
        worker.every(Duration.ofHours(1), Duration.ofHours(1), () -> done.add("round"));
        waitFor(begun);

        assertThat(worker.finish(Duration.ofMillis(1))).isFalse();
        mayEnd.countDown();

        assertThat(worker.finish(LONG)).isTrue();
        assertThat(done).containsExactly("waiting");
    }

    @Test
    void whatEndsAThreadForGoodIsToldToWhoeverEndsTheProcess() {
        List<String> told = new CopyOnWriteArrayList<>();
        Thread.UncaughtExceptionHandler before = Thread.getDefaultUncaughtExceptionHandler();
        Thread.setDefaultUncaughtExceptionHandler(
                (thread, error) -> told.add(thread.getName() + " " + error.getMessage()));
        try {
            Worker worker = time.worker("worker", 10);
            worker.execute(() -> fail("work"));
            worker.after(Duration.ZERO, () -> fail("later"));
            worker.every(Duration.ZERO, Duration.ofHours(1), () -> fail("round"));
            time.loop("loop", () -> fail("turn")).start();
            time.pool("pool", 1, 10).execute(() -> fail("piece"));
            Thread unused = time.blocking("blocking", () -> fail("wait"));

            await().dontCatchUncaughtExceptions()
                    .atMost(LONG)
                    .until(() -> told.containsAll(List.of(
                            "worker work",
                            "worker later",
                            "worker round",
                            "loop turn",
                            "pool-1 piece",
                            "blocking wait")));
        } finally {
            Thread.setDefaultUncaughtExceptionHandler(before);
        }
    }

    /** As when a thread is stopped while it waits in a lock. */
    @Test
    void soIsAnExceptionThatEndsAThread() {
        List<String> told = new CopyOnWriteArrayList<>();
        Thread.UncaughtExceptionHandler before = Thread.getDefaultUncaughtExceptionHandler();
        Thread.setDefaultUncaughtExceptionHandler((thread, error) ->
                told.add(thread.getName() + " " + (error instanceof Error) + " " + error.getMessage()));
        try {
            Thread ended = FatalErrors.onDuty(new Thread(
                    () -> {
                        throw new IllegalMonitorStateException("on purpose");
                    },
                    "duty"));
            ended.start();
            Worker worker = time.worker("worker", 10);
            worker.execute(() -> Thread.currentThread()
                    .getUncaughtExceptionHandler()
                    .uncaughtException(Thread.currentThread(), new IllegalStateException("no lock")));

            await().dontCatchUncaughtExceptions()
                    .atMost(LONG)
                    .until(() -> told.containsAll(List.of(
                            "duty true java.lang.IllegalMonitorStateException: on purpose",
                            "worker true java.lang.IllegalStateException: no lock")));
        } finally {
            Thread.setDefaultUncaughtExceptionHandler(before);
        }
    }

    private static long fail(String what) {
        throw new InternalError(what);
    }

    @Test
    void whoAsksHearsAtOnceWhatBrokeForGood() {
        Worker worker = time.worker("worker", 10);
        StackOverflowError broken = new StackOverflowError("on purpose");

        assertThatThrownBy(() -> time.join(
                        worker.submit(() -> {
                            throw broken;
                        }),
                        LONG))
                .hasCause(broken);
        assertThat(time.join(worker.submit(() -> "next"), LONG)).isEqualTo("next");
        worker.close();
    }

    @Test
    void aWorkerRefusesMoreThanMayWait() {
        Worker worker = time.worker("worker", 1);
        CountDownLatch begun = new CountDownLatch(1);
        CountDownLatch mayEnd = new CountDownLatch(1);
        worker.execute(() -> {
            begun.countDown();
            waitFor(mayEnd);
        });
        waitFor(begun);
        worker.execute(() -> done.add("one"));

        assertThat(worker.waiting()).isEqualTo(1);
        assertThatThrownBy(() -> worker.execute(() -> done.add("two"))).isInstanceOf(RejectedExecutionException.class);
        mayEnd.countDown();
        assertThat(worker.finish(LONG)).isTrue();
        assertThat(done).containsExactly("one");
    }

    @Test
    void aClosedWorkerRefusesAndForgets() {
        Worker worker = time.worker("worker", 10);
        worker.close();

        assertThatThrownBy(() -> worker.execute(() -> done.add("late"))).isInstanceOf(RejectedExecutionException.class);
        worker.after(Duration.ZERO, () -> done.add("later"));
        assertThat(worker.finish(LONG)).isTrue();
        assertThat(done).isEmpty();
    }

    @Test
    void aRepetitionGoesOnUntilItIsCalledOff() {
        Worker worker = time.worker("worker", 1);
        AtomicInteger rounds = new AtomicInteger();
        ScheduledTask repetition = worker.every(Duration.ZERO, Duration.ofMillis(1), () -> {
            rounds.incrementAndGet();
            throw new IllegalStateException("on purpose");
        });
        await().until(() -> rounds.get() > 3);
        repetition.cancel();

        int count = time.join(worker.submit(rounds::get), LONG);
        assertThat(time.join(worker.submit(rounds::get), LONG)).isEqualTo(count);
        worker.close();
    }

    @Test
    void aLoopThatIsWokenTakesATurnThoughItWouldRestForLong() throws InterruptedException {
        Semaphore turns = new Semaphore(0);
        Loop loop = time.loop("loop", () -> {
            turns.release();
            return Duration.ofHours(1).toNanos();
        });
        loop.start();
        turns.acquire();
        for (int count = 0; count < 1_000; count++) {
            loop.wake();
            turns.acquire();
        }
        loop.close();
    }

    @Test
    void aLoopTakesALastTurnWhenItFinishes() {
        AtomicInteger turns = new AtomicInteger();
        Loop loop = time.loop("loop", () -> {
            turns.incrementAndGet();
            return Duration.ofHours(1).toNanos();
        });
        loop.start();
        await().until(() -> turns.get() == 1);

        assertThat(loop.finish(LONG)).isTrue();
        assertThat(turns).hasValue(2);
    }

    @Test
    void aLoopGoesOnAfterATurnThatFailed() {
        AtomicInteger turns = new AtomicInteger();
        Loop loop = time.loop("loop", () -> {
            if (turns.incrementAndGet() == 1) {
                throw new IllegalStateException("on purpose");
            }
            return 0;
        });
        loop.start();
        await().until(() -> turns.get() > 2);
        loop.close();
    }

    @Test
    void aPoolRefusesWhenItsThreadsAndItsQueueAreFull() {
        Pool pool = time.pool("pool", 1, 1);
        CountDownLatch mayEnd = new CountDownLatch(1);
        pool.execute(() -> waitFor(mayEnd));
        pool.execute(() -> done.add("one"));

        assertThatThrownBy(() -> pool.execute(() -> done.add("two"))).isInstanceOf(RejectedExecutionException.class);
        mayEnd.countDown();
        await().until(() -> done.contains("one"));
        pool.close();
        assertThat(pool.isClosed()).isTrue();
    }

    @Test
    void waitsNoLongerThanItSays() {
        CompletableFuture<String> never = new CompletableFuture<>();

        assertThatThrownBy(() -> time.await(never, Duration.ofMillis(1))).isInstanceOf(TimeoutException.class);
        assertThat(time.within(never, Duration.ofMillis(1), "none").join()).isEqualTo("none");
        assertThat(never).isNotDone();
    }

    private static void waitFor(CountDownLatch latch) {
        try {
            latch.await();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
