package org.dronemap.proxy.roslink.wire;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class RobotSequenceTrackerTest {
    private final RobotSequenceTracker watch = new RobotSequenceTracker();

    @Test
    void findsGapsInOneRowForAllKinds() {
        heard(0, 1);
        heard(1, 2);
        heard(2, 3);
        heard(0, 4);
        heard(1, 7);
        heard(2, 8);

        assertThat(watch.received()).isEqualTo(6);
        assertThat(watch.lost()).isEqualTo(2);
    }

    /** Two messages by one link and one by another that is faster, and one by none. */
    @Test
    void findsGapsInOneRowWhereOneOfTwoLinksIsAlwaysAhead() {
        heard(0, 1);
        for (int number = 2; number < 120; number += 4) {
            heard(0, number + 3);
            heard(0, number);
            heard(2, number + 1);
        }

        assertThat(watch.lost()).isEqualTo(30);
    }

    @Test
    void findsGapsWhereRowsOfTheirOwnRunSideBySide() {
        for (int number = 1; number <= 10; number++) {
            heard(0, number);
            heard(2, number);
        }
        heard(2, 13);

        assertThat(watch.lost()).isEqualTo(2);
    }

    @Test
    void findsGapsWhereEachKindHasItsOwnRow() {
        for (int number = 1; number <= 10; number++) {
            heard(0, number);
            if (number % 2 == 0) {
                heard(2, 500 + number / 2);
            }
        }
        heard(0, 13);

        assertThat(watch.lost()).isEqualTo(2);
    }

    @Test
    void knowsACopyAndAMessageThatOnlyComesLate() {
        heard(0, 1);
        heard(0, 4);
        assertThat(watch.lost()).isEqualTo(2);

        assertThat(heard(0, 4)).isFalse();
        assertThat(heard(0, 3)).isTrue();
        assertThat(heard(0, 3)).isFalse();

        assertThat(watch.lost()).isEqualTo(1);
        assertThat(watch.doubled()).isEqualTo(2);
        assertThat(watch.received()).isEqualTo(3);
    }

    @Test
    void doesNotTakeTheSameNumberOfAnotherKindForACopy() {
        assertThat(heard(0, 5)).isTrue();
        assertThat(heard(1, 5)).isTrue();
        assertThat(watch.doubled()).isZero();
    }

    @Test
    void seesNoLossWhereTheNumbersGoRound() {
        for (int number = 14_990; number <= 15_000; number++) {
            heard(0, number);
        }
        assertThat(heard(0, 1)).isTrue();
        assertThat(heard(0, 2)).isTrue();
        assertThat(watch.lost()).isZero();
    }

    @Test
    void hearsARobotAgainThatRestartsItsCounting() {
        for (int number = 1; number <= 30; number++) {
            heard(0, number);
        }
        int taken = 0;
        for (int number = 1; number <= 30; number++) {
            taken += heard(0, number) ? 1 : 0;
        }

        assertThat(taken).isEqualTo(27);
        assertThat(watch.lost()).isZero();
    }

    @Test
    void hearsARobotThatNeverCounts() {
        int taken = 0;
        for (int i = 0; i < 20; i++) {
            taken += heard(0, 1) ? 1 : 0;
        }

        assertThat(taken).isEqualTo(17);
    }

    @Test
    void takesMessagesWithoutNumbers() {
        assertThat(watch.isNew(header(0, null))).isTrue();
        assertThat(watch.isNew(header(0, null))).isTrue();
        assertThat(watch.received()).isEqualTo(2);
        assertThat(watch.lost()).isZero();
    }

    @Test
    void staysBoundedForAnyKindsAndNumbers() {
        for (int i = 0; i < 10_000; i++) {
            heard(i, Long.MAX_VALUE - i * 7L);
            heard(i, Long.MIN_VALUE + i);
        }
        assertThat(watch.received()).isPositive();
    }

    private boolean heard(int messageId, long number) {
        return watch.isNew(header(messageId, number));
    }

    private static RoslinkHeader header(int messageId, @org.jspecify.annotations.Nullable Long number) {
        return new RoslinkHeader(PacketLayout.NESTED_HEADER, 1, messageId, number, null, null, 1, 0);
    }
}
