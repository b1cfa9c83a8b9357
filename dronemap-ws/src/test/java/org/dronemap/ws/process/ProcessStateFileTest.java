package org.dronemap.ws.process;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Clock;
import java.time.Instant;
import java.time.ZoneOffset;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicInteger;
import org.dronemap.core.process.PeerPattern;
import org.dronemap.core.process.ProcessCrash;
import org.dronemap.core.time.RealTime;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What one process leaves to the next; the file is the same, as it is after a kill. */
class ProcessStateFileTest {
    private static final Instant BEGUN = Instant.parse("2026-05-04T10:00:00Z");
    private static final Instant LATER = BEGUN.plusSeconds(30);
    private static final PeerPattern SEEN = new PeerPattern("10.0.0.7", 14550, 3);
    private static final PeerPattern OTHER = PeerPattern.at("10.0.0.8", 14550);

    @TempDir
    private Path data;

    private ProcessStateFile begin(Instant at) {
        return ProcessStateFile.begin(data.resolve("run-state"), at, "3");
    }

    @Test
    void whatWasStoppedLeavesNothing() {
        ProcessStateFile run = begin(BEGUN);
        assertThat(run.before()).isEmpty();
        run.stopped();

        assertThat(begin(LATER).before()).isEmpty();
    }

    @Test
    void whatRanOutOfMemoryLeavesItsLastSignAndAllWhoseBytesItWorkedOn() {
        ProcessStateFile run = begin(BEGUN);
        run.begin(SEEN.text());
        CompletableFuture.runAsync(() -> run.begin(OTHER.text()), Runnable::run).join();
        CompletableFuture.runAsync(() -> run.begin(OTHER.text())).join();
        run.begin(SEEN.text());
        run.sign(LATER);

        ProcessCrash end = begin(LATER.plusSeconds(9)).before().orElseThrow();

        assertThat(end.at()).isEqualTo(LATER);
        assertThat(end.part()).isEqualTo("memory");
        assertThat(end.peers()).containsExactlyInAnyOrder(SEEN, OTHER);
    }

    @Test
    void whatWasKilledFromOutsideNamesNobody() {
        begin(BEGUN).begin(SEEN.text());

        ProcessCrash end = ProcessStateFile.begin(data.resolve("run-state"), LATER, "137")
                .before()
                .orElseThrow();

        assertThat(end.part()).isEqualTo("process");
        assertThat(end.why()).startsWith("It was killed");
        assertThat(end.peers()).isEmpty();
    }

    @Test
    void whoseBytesWereDoneWithIsNotNamed() {
        ProcessStateFile run = begin(BEGUN);
        run.at(SEEN.text(), () -> {});

        assertThat(begin(LATER).before().orElseThrow().peers()).isEmpty();
    }

    @Test
    void aThreadThatEndsWithAnErrorEndsTheProcessAndNamesThePeerOfThatThreadAlone() {
        ProcessStateFile run = begin(BEGUN);
        AtomicInteger halted = new AtomicInteger();
        ProcessTerminator end = new ProcessTerminator(run, Clock.fixed(LATER, ZoneOffset.UTC), halted::set);
        CompletableFuture.runAsync(() -> run.begin(OTHER.text())).join();
        Thread lane = new Thread(
                () -> run.at(SEEN.text(), () -> {
                    throw new InternalError("on purpose");
                }),
                "lane-1");
        lane.setUncaughtExceptionHandler(end);
        lane.start();
        join(lane);

        assertThat(halted).hasValue(ProcessTerminator.EXIT_CODE);
        ProcessCrash left = begin(LATER).before().orElseThrow();
        assertThat(left.part()).isEqualTo("lane-1");
        assertThat(left.why()).contains("InternalError: on purpose");
        assertThat(left.peers()).containsExactly(SEEN);
    }

    @Test
    void anExceptionOfALibrarysThreadEndsNothing() {
        AtomicInteger halted = new AtomicInteger();
        new ProcessTerminator(begin(BEGUN), Clock.systemUTC(), halted::set)
                .uncaughtException(Thread.currentThread(), new IllegalStateException("on purpose"));

        assertThat(halted).hasValue(0);
        assertThat(begin(LATER).before().orElseThrow().part()).isEqualTo("memory");
    }

    @Test
    void endsAreKeptForTheNextOnesWhichStartCarefullyAfterThree() {
        RealTime time = new RealTime();
        for (int start = 0; start < 3; start++) {
            ProcessLifecycle process = ProcessLifecycle.begin(data, "3", time);
            assertThat(process.beginning().precautions().isActive()).isFalse();
            process.beginning().watch().atWork().begin(SEEN.text());
        }
        ProcessLifecycle careful = ProcessLifecycle.begin(data, "3", time);
        assertThat(careful.beginning().precautions().ends()).hasSize(3);
        assertThat(careful.beginning().precautions().refused())
                .containsExactly(PeerPattern.at(SEEN.host(), SEEN.port()));
        careful.close();
        Thread.setDefaultUncaughtExceptionHandler(null);
    }

    @Test
    void aLineThatSaysNothingOfAnEndIsPassedOver() throws Exception {
        Path file = data.resolve("past-ends");
        Files.writeString(
                file, "nonsense\n" + new ProcessCrash(BEGUN, "lane-0", "It ended.", List.of(SEEN)).text() + "\n");

        assertThat(new ProcessEndLog(file).all()).extracting(ProcessCrash::part).containsExactly("lane-0");
    }

    private static void join(Thread thread) {
        try {
            thread.join();
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }
}
