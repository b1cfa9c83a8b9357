package org.dronemap.ws.stream.delivery;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** When pictures go out: at once in a small fleet, shared fairly in a big one, never more often than asked. */
class PublishScheduleTest {
    private static final long MILLI = 1_000_000L;

    private final List<String> sent = new ArrayList<>();

    @Test
    void sendsAtOnceWhatComesSlowly() {
        PublishSchedule<String> turns = new PublishSchedule<>(50);
        for (int number = 0; number < 5; number++) {
            turns.changed(new StreamMessageSubject("drone", "a"), "" + number);
            turns.publishDue(number * 41 * MILLI, sent::add);
        }
        assertThat(sent).containsExactly("0", "1", "2", "3", "4");
    }

    @Test
    void sendsTheNewestAtItsTurnOfWhatComesFast() {
        PublishSchedule<String> turns = new PublishSchedule<>(50);
        turns.changed(new StreamMessageSubject("drone", "a"), "" + 1);
        turns.publishDue(0, sent::add);
        turns.changed(new StreamMessageSubject("drone", "a"), "" + 2);
        assertThat(turns.publishDue(5 * MILLI, sent::add)).isEqualTo(15 * MILLI);
        turns.changed(new StreamMessageSubject("drone", "a"), "" + 3);
        turns.publishDue(19 * MILLI, sent::add);
        assertThat(sent).containsExactly("1");
        turns.publishDue(20 * MILLI, sent::add);
        assertThat(sent).containsExactly("1", "3");
    }

    @Test
    void givesBigFleetsFiveASecondAndNotLess() {
        PublishSchedule<String> turns = new PublishSchedule<>(50);
        for (int number = 0; number < 2_000; number++) {
            turns.changed(new StreamMessageSubject("drone", "d" + number), "x");
        }
        turns.publishDue(0, sent::add);
        assertThat(sent).hasSize(2_000);
        assertThat(turns.gapNanos()).isEqualTo(200 * MILLI);
    }

    @Test
    void keepsToWhatAClientAskedFor() {
        assertThat(new PublishSchedule<>(5).gapNanos()).isEqualTo(200 * MILLI);
        assertThat(new PublishSchedule<>(1).gapNanos()).isEqualTo(1_000 * MILLI);
        assertThat(new PublishSchedule<>(50).gapNanos()).isEqualTo(20 * MILLI);
    }

    @Test
    void sendsNothingOfARemovedDrone() {
        PublishSchedule<String> turns = new PublishSchedule<>(50);
        turns.changed(new StreamMessageSubject("drone", "a"), "" + 1);
        turns.removed(new StreamMessageSubject("drone", "a"));
        turns.publishDue(0, sent::add);
        assertThat(sent).isEmpty();
    }

    @Test
    void givesTheShareOfSilentDronesToTheOthers() {
        PublishSchedule<String> turns = new PublishSchedule<>(50);
        for (int number = 0; number < 100; number++) {
            turns.changed(new StreamMessageSubject("drone", "d" + number), "x");
        }
        turns.publishDue(0, sent::add);
        assertThat(turns.gapNanos()).isEqualTo(80 * MILLI);
        turns.forget(61_000 * MILLI);
        assertThat(turns.gapNanos()).isEqualTo(20 * MILLI);
    }
}
