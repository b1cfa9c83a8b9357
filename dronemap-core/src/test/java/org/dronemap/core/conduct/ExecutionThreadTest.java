package org.dronemap.core.conduct;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.time.Duration;
import java.util.concurrent.atomic.AtomicInteger;
import org.dronemap.core.operation.Objection;
import org.dronemap.core.operation.OperationObjection;
import org.dronemap.core.time.RealTime;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class ExecutionThreadTest {
    private final ExecutionThread thread = new ExecutionThread(new RealTime(), "conductor");

    @AfterEach
    void stop() {
        thread.close();
    }

    @Test
    void goesOnAfterATurnThatFailed() {
        AtomicInteger turns = new AtomicInteger();
        thread.every(Duration.ofMillis(1), () -> {
            turns.incrementAndGet();
            throw new IllegalStateException("the database is away");
        });
        await().until(() -> turns.get() > 3);
        assertThat(thread.<String>ask(() -> "answered")).isEqualTo("answered");
    }

    @Test
    void tellsWhoAsksWhatWentWrong() {
        assertThatThrownBy(() -> thread.ask(() -> {
                    throw new Operations.Refused(Objection.of(OperationObjection.OVER, "It is over."));
                }))
                .isInstanceOf(Operations.Refused.class)
                .hasMessage("It is over.");
    }

    @Test
    void doesNothingMoreOnceClosed() {
        AtomicInteger done = new AtomicInteger();
        thread.close();
        thread.soon(done::incrementAndGet);
        assertThatThrownBy(() -> thread.ask(done::incrementAndGet)).isInstanceOf(RuntimeException.class);
        assertThat(done).hasValue(0);
    }
}
