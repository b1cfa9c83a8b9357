package org.dronemap.proxy.endpoint;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class TokenBucketTest {
    private static final long SECOND = 1_000_000_000L;
    private static final long TENTH = SECOND / 10;

    @Test
    void givesWhatWasSpentBackWithTime() {
        TokenBucket allowance = new TokenBucket(1_000, 0);
        assertThat(allowance.isOpen(0)).isTrue();
        allowance.spend(1_100);
        assertThat(allowance.isOpen(0)).isFalse();
        assertThat(allowance.isOpen(TENTH)).isFalse();
        assertThat(allowance.isOpen(2 * TENTH)).isTrue();
    }

    @Test
    void whoHasJustComeMayCostLittleAndTwiceAsMuchEachSecond() {
        TokenBucket allowance = TokenBucket.growing(1_000, 6_000, 0);
        assertThat(spentIn(allowance, 0)).isEqualTo(1_900);
        assertThat(spentIn(allowance, 1)).isEqualTo(2_000);
        assertThat(spentIn(allowance, 2)).isEqualTo(4_000);
        assertThat(spentIn(allowance, 3)).isEqualTo(6_000);
        assertThat(spentIn(allowance, 4)).isEqualTo(6_000);
    }

    /** By somebody who wants all that there is, in ten bites. */
    private static int spentIn(TokenBucket allowance, int second) {
        int spent = 0;
        for (int tenth = 0; tenth < 10; tenth++) {
            while (allowance.isOpen(second * SECOND + tenth * TENTH)) {
                allowance.spend(100);
                spent += 100;
            }
        }
        return spent;
    }
}
