package org.dronemap.core.separation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import org.dronemap.core.drone.DroneId;
import org.junit.jupiter.api.Test;

/** Whoever is about to set off counts as if it flew: its way is proved, and nobody sees yet that it takes it. */
class LetGoTest extends SeparationTestBase {
    /** They would meet a minute after both have set off. */
    private final FlyingDrone first = new FlyingDrone("a", 0, -400).risesTo(0, 400, 20);

    private final FlyingDrone second = new FlyingDrone("b", -400, 0).risesTo(400, 0, 20);

    @Test
    void countsBeforeItIsArmed() {
        look(first);
        assertThat(giveWays).isEmpty();

        now = now.plusMillis(250);
        look(second, first);
        assertThat(giveWays).containsOnlyKeys(second.id);
    }

    @Test
    void countsWhileItIsArmedAndDoesNotSayYetThatItFlies() {
        first.step = FlightIntent.Step.FLY;
        first.armed = true;
        first.mode = "AUTO";

        look(second, first);
        assertThat(giveWays).containsOnlyKeys(second.id);
    }

    @Test
    void countsWhileItIsToldToGoOn() {
        first.north = -505;
        first.height = 20;
        first.airborne = true;
        first.armed = true;
        first.step = FlightIntent.Step.GO_ON;
        first.commanded = true;

        look(second, first);
        assertThat(giveWays).containsOnlyKeys(second.id);
    }

    @Test
    void isNotKeptFromArmingByOneThatComesLater() {
        look(first);
        now = now.plusMillis(250);
        first.commanded = true;
        look(first, second);
        now = now.plusMillis(250);
        first.commanded = false;
        look(first, second);
        assertThat(giveWays).containsOnlyKeys(second.id);
    }

    /** One that is started by a plan is commanded from the first moment on, also while it waits. */
    @Test
    void doesNotCountWhileItWaitsItselfWhateverItIsCommanded() {
        first.commanded = true;
        FlyingDrone above = new FlyingDrone("c", 0, -400).stands("GUIDED");
        look(first, above);
        assertThat(giveWays).containsOnlyKeys(first.id);

        now = now.plusMillis(250);
        look(second, first, above);
        assertThat(giveWays).containsOnlyKeys(first.id);
    }

    @Test
    void isForgottenOnceItHasRisen() {
        look(first);
        assertThat(yielding).containsOnlyKeys(first.id);
        first.armed = true;
        first.airborne = true;
        first.height = 5;
        look(first);
        assertThat(yielding).isEmpty();
    }

    /** Plans keep their drones apart by time as well: by theirs, not by that of one that had to wait. */
    @Test
    void isComparedWithItsOwnPlanOnceItHadToWait() {
        second.operation = first.operation;
        look(first);
        look(first, second);
        assertThat(giveWays).as("planned together").isEmpty();

        GiveWay waits = new GiveWay(new DroneId("c"), "Copter c", GiveWay.Manner.WAIT, now, false, null);
        yielding = Map.of(second.id, Yielding.began(waits, now, null));
        look(first);
        Map<DroneId, Yielding> letGo = yielding;
        yielding = Map.of(first.id, letGo.get(first.id), second.id, Yielding.began(waits, now, null));
        now = now.plusSeconds(5);
        look(second, first);
        assertThat(giveWays).containsOnlyKeys(second.id);
    }
}
