package org.dronemap.core.cloud.rule;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import org.dronemap.core.drone.Attitude;
import org.dronemap.core.drone.Battery;
import org.dronemap.core.drone.OutdatedPart;
import org.dronemap.core.drone.Position;
import org.dronemap.core.drone.StatePart;
import org.dronemap.core.event.DroneEvent;
import org.junit.jupiter.api.Test;

class StatePartAgesTest {
    private static final Instant START = Instant.parse("2026-05-06T07:08:09Z");

    private final StatePartAges ages = new StatePartAges();

    private static Instant at(long seconds) {
        return START.plusSeconds(seconds);
    }

    private void position(long seconds) {
        ages.apply(new DroneEvent.PositionReported(new Position(null, null, null)), at(seconds));
    }

    @Test
    void whatStopsIsOutdatedUntilItIsToldAgain() {
        position(0);
        position(1);
        ages.apply(new DroneEvent.BatteryReported(new Battery(50, null, null)), at(9));
        assertThat(ages.judge(at(11), false)).isFalse();
        assertThat(ages.judge(at(12), false)).isTrue();
        assertThat(ages.outdated()).containsExactly(new OutdatedPart(StatePart.POSITION, at(1)));
        assertThat(ages.judge(at(13), false)).isFalse();
        position(14);
        assertThat(ages.outdated()).isEmpty();
    }

    @Test
    void whatIsToldRarelyHasLonger() {
        position(0);
        position(20);
        ages.judge(at(80), false);
        assertThat(ages.outdated()).isEmpty();
        ages.judge(at(81), false);
        assertThat(ages.outdated()).hasSize(1);
    }

    @Test
    void whatIsUnknownDoesNotAge() {
        ages.apply(new DroneEvent.AttitudeReported(new Attitude(1, 2, 3)), at(0));
        ages.apply(new DroneEvent.AttitudeReported(null), at(1));
        ages.judge(at(60), false);
        assertThat(ages.outdated()).isEmpty();
    }

    @Test
    void whetherItIsArmedMayBeOlderThanItsMode() {
        ages.apply(new DroneEvent.ModeReported("AUTO", true), at(0));
        ages.apply(new DroneEvent.ModeReported("RTL", null), at(15));
        ages.judge(at(16), false);
        assertThat(ages.outdated()).containsExactly(new OutdatedPart(StatePart.ARMED, at(0)));
    }

    @Test
    void whereAllIsSilentNothingIsOlderThanTheRest() {
        position(0);
        ages.judge(at(30), true);
        assertThat(ages.outdated()).isEmpty();
    }
}
