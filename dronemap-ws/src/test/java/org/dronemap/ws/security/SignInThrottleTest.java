package org.dronemap.ws.security;

import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.time.ZoneOffset;
import org.dronemap.ws.problem.Rejection;
import org.junit.jupiter.api.Test;

class SignInThrottleTest {
    private static final String HOME = "10.0.0.1";

    private Instant now = Instant.parse("2026-03-04T05:06:07Z");
    private final InstantSource hands = () -> now;
    private final Clock clock = hands.withZone(ZoneOffset.UTC);
    private final SignInThrottle throttle = new SignInThrottle(clock);

    @Test
    void makesOneWhoGuessesRestLongerAndLongerUpToAQuarterOfAnHour() {
        guess("ann", HOME, 4);
        assertOpen("ann", HOME);
        guess("ann", HOME, 1);
        assertRest("ann", HOME, 30);
        pass(30);
        assertOpen("ann", HOME);
        guess("ann", HOME, 1);
        assertRest("ann", HOME, 60);
        guess("ann", HOME, 10);
        assertRest("ann", HOME, 900);
    }

    @Test
    void forgetsWhatWasWrongWhenThePasswordIsRight() {
        guess("ann", HOME, 4);
        throttle.right("ann", HOME);
        guess("ann", HOME, 4);
        assertOpen("ann", HOME);
    }

    @Test
    void makesAPlaceRestThatTriesManyNames() {
        for (int i = 0; i < 30; i++) {
            assertOpen("name" + i, HOME);
            guess("name" + i, HOME, 1);
        }
        assertRest("another", HOME, 30);
        assertOpen("another", "10.0.0.2");
    }

    @Test
    void locksANameThatManyPlacesTryButNotForWhereItsUserHasSignedInBefore() {
        throttle.right("ann", HOME);
        for (int i = 0; i < 100; i++) {
            guess("ann", "10.1.0." + i, 1);
        }
        assertRest("ann", "10.2.0.1", 30);
        assertOpen("ann", HOME);
        assertOpen("bob", "10.2.0.1");
    }

    private void guess(String name, String address, int times) {
        for (int i = 0; i < times; i++) {
            throttle.wrong(name, address);
        }
    }

    private void pass(long seconds) {
        now = now.plus(Duration.ofSeconds(seconds));
    }

    private void assertOpen(String name, String address) {
        assertThatCode(() -> throttle.check(name, address)).doesNotThrowAnyException();
    }

    private void assertRest(String name, String address, int seconds) {
        assertThatThrownBy(() -> throttle.check(name, address))
                .isInstanceOf(Rejection.class)
                .hasMessage("Too many wrong passwords; wait " + seconds + " s and try again.");
    }
}
