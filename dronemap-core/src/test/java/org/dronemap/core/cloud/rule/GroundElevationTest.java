package org.dronemap.core.cloud.rule;

import static org.assertj.core.api.Assertions.assertThat;

import org.dronemap.core.drone.Home;
import org.dronemap.core.drone.Position;
import org.dronemap.core.geo.Geodetic;
import org.junit.jupiter.api.Test;

class GroundElevationTest {
    private static final Geodetic FIELD = new Geodetic(47.4, 8.5);

    private static Home home(double amsl) {
        return new Home(FIELD, amsl);
    }

    private static Position at(double amsl) {
        return new Position(FIELD, amsl, 0.0);
    }

    @Test
    void isTheHomeThatItStandsBeside() {
        GroundElevation ground = new GroundElevation(null);
        ground.at(at(501.2), home(500), true);
        assertThat(ground.amslMeters()).isEqualTo(500);
        ground.at(home(501), true);
        assertThat(ground.amslMeters()).isEqualTo(501);
    }

    @Test
    void isWhereItStandsWhenHomeIsElsewhere() {
        GroundElevation ground = new GroundElevation(null);
        ground.at(at(500), home(600), true);
        ground.at(home(600), true);
        assertThat(ground.amslMeters()).isEqualTo(500);
    }

    @Test
    void staysInTheAir() {
        GroundElevation ground = new GroundElevation(null);
        ground.at(at(500), home(500), true);
        ground.at(home(600), false);
        ground.at(at(640), home(600), false);
        assertThat(ground.amslMeters()).isEqualTo(500);
    }

    @Test
    void isTheFirstHomeOfWhatWasNeverSeenOnTheGround() {
        GroundElevation ground = new GroundElevation(null);
        ground.at(at(540), null, false);
        assertThat(ground.amslMeters()).isNull();
        ground.at(home(500), false);
        ground.at(home(600), false);
        assertThat(ground.amslMeters()).isEqualTo(500);
    }

    @Test
    void isTheLowerOneOfWhatIsRememberedAndTheHomeOfNow() {
        GroundElevation raised = new GroundElevation(500.0);
        raised.at(home(600), false);
        assertThat(raised.amslMeters()).isEqualTo(500);
        GroundElevation moved = new GroundElevation(500.0);
        moved.at(home(300), false);
        moved.at(home(200), false);
        assertThat(moved.amslMeters()).isEqualTo(300);
    }

    @Test
    void isKeptOnceWhenItLeaves() {
        GroundElevation ground = new GroundElevation(null);
        ground.at(at(500), home(500), true);
        assertThat(ground.isToBeKept(true)).isFalse();
        assertThat(ground.isToBeKept(false)).isTrue();
        assertThat(ground.isToBeKept(false)).isFalse();
    }
}
