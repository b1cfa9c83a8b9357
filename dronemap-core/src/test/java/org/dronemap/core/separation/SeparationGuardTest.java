package org.dronemap.core.separation;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.stream.Stream;
import org.dronemap.core.command.Command;
import org.dronemap.core.drone.LinkState;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Drones of different owners that would come too near to each other. */
class SeparationGuardTest extends SeparationTestBase {
    private GiveWay give(FlyingDrone drone) {
        return Objects.requireNonNull(yielding.get(drone.id)).give();
    }

    @Test
    void oneOfTwoThatCrossWaitsAndTheOtherGoesOn() {
        FlyingDrone one = new FlyingDrone("a", -60, 0).to(60, 0, 20);
        FlyingDrone other = new FlyingDrone("b", 0, -60).to(0, 60, 20);
        look(one, other);

        assertThat(orders)
                .singleElement()
                .satisfies(order -> assertThat(order.command()).isEqualTo(new Command.PauseMission()));
        assertThat(yielding.values())
                .singleElement()
                .satisfies(one1 -> assertThat(one1.give().manner()).isEqualTo(GiveWay.Manner.STOP));
    }

    @ParameterizedTest
    @ValueSource(doubles = {6.5, -6.5})
    void thoseOfTwoOwnersPassWithMoreThanTheLeastHeightBetween(double above) {
        FlyingDrone one = new FlyingDrone("a", -60, 0).to(60, 0, 20);
        FlyingDrone other = new FlyingDrone("b", 0, -60).to(0, 60, 20 + above);
        other.height = 20 + above;
        assertThat(look(one, other)).isEmpty();
        other.to(0, 60, 20 + above * 0.8);
        other.height = 20 + above * 0.8;
        assertThat(look(one, other)).isNotEmpty();
    }

    /** 9 m are enough where both count from one ground; the homes of these two lie 3 m apart in height, as they say. */
    @Test
    void heightsDoNotCountAmongThoseThatAreNotLevel() {
        FlyingDrone one = new FlyingDrone("a", -60, 0).to(60, 0, 20);
        FlyingDrone other = new FlyingDrone("b", 0, -60).to(0, 60, 29);
        other.height = 29;
        assertThat(look(one, other)).isEmpty();
        other.homeAmsl = FlyingDrone.GROUND + 3;
        other.height = 26;
        assertThat(look(one, other)).isNotEmpty();
    }

    @Test
    void whoIsFlownByHandIsNeverCommandedAndOthersLeaveItsReach() {
        FlyingDrone own = new FlyingDrone("a", 0, 0).stands("GUIDED");
        FlyingDrone hand = new FlyingDrone("b", 40, 0).byHand();
        hand.northward = 8;
        look(own, hand);

        assertThat(orders).singleElement().satisfies(order -> {
            assertThat(order.to()).isEqualTo(own.id);
            assertThat(order.command()).isInstanceOf(Command.GoTo.class);
        });
        assertThat(orders.get(0).why()).contains("to make room for Copter b");
        assertThat(give(own).words()).doesNotContain("Copter");
        own.height = 30;
        yielding = Map.of();
        assertThat(look(own, hand)).isEmpty();
    }

    @Test
    void onPadsNearEachOtherOneTakesOffAfterTheOther() {
        FlyingDrone first = new FlyingDrone("a", 0, 0).risesTo(0, 100, 20);
        FlyingDrone second = new FlyingDrone("b", 5, 0).risesTo(5, 100, 20);
        look(first, second);
        assertThat(giveWays).containsOnlyKeys(second.id);
        assertThat(give(second).manner()).isEqualTo(GiveWay.Manner.WAIT);

        first.armed = true;
        look(first, second);
        assertThat(giveWays).containsOnlyKeys(second.id);

        first.airborne = true;
        first.mode = "AUTO";
        first.height = 20;
        first.north = 90;
        first.to(0, 300, 20);
        first.step = FlightIntent.Step.FLY;
        look(first, second);
        assertThat(giveWays).isEmpty();
    }

    @Test
    void nobodyTakesOffBelowOneThatHoversThere() {
        FlyingDrone rising = new FlyingDrone("a", 0, 0).risesTo(0, 100, 20);
        FlyingDrone above = new FlyingDrone("b", 3, 3).byHand();
        look(rising, above);
        assertThat(give(rising).to()).isEqualTo(above.id);
    }

    @Test
    void thePlaceOfASilentDroneIsKeptUntilItMustBeDown() {
        FlyingDrone silent = new FlyingDrone("b", 0, 0).stands("GUIDED");
        silent.link = LinkState.LOST;
        silent.silence = Duration.ofSeconds(60);
        FlyingDrone successor = new FlyingDrone("a", 0, -50).to(0, 0, 20);
        assertThat(look(successor, silent)).isNotEmpty();

        yielding = Map.of();
        silent.silence = Duration.ofMinutes(46);
        assertThat(look(successor, silent)).isEmpty();
    }

    /** Its fail-safe brings it home within half a minute; somebody at the vehicle may have stopped it before. */
    @Test
    void oneThatFellSilentOnItsMissionMayStandOnItsWay() {
        FlyingDrone silent = new FlyingDrone("b", 0, 0).to(0, 400, 20);
        silent.homeNorth = -300;
        silent.link = LinkState.LOST;
        silent.silence = Duration.ofSeconds(40);
        FlyingDrone successor = new FlyingDrone("a", 50, 24).to(0, 24, 20);
        assertThat(look(successor, silent)).isNotEmpty();
    }

    @Test
    void twoThatStandAndWaitForEachOtherDoNotWaitForEver() {
        FlyingDrone one = new FlyingDrone("a", 0, 0).stands("GUIDED");
        FlyingDrone other = new FlyingDrone("b", 20, 0).stands("GUIDED");
        one.step = FlightIntent.Step.FLY;
        other.step = FlightIntent.Step.FLY;
        one.to(60, 0, 20);
        other.to(-40, 0, 20);
        one.eastward = 0;
        other.eastward = 0;
        yielding = Map.of(one.id, stood(other), other.id, stood(one));
        look(one, other);
        assertThat(orders).isEmpty();

        now = now.plusSeconds(5);
        look(one, other);
        assertThat(orders)
                .singleElement()
                .satisfies(order -> assertThat(order.why()).contains("to make room for Copter a"));
    }

    @Test
    void whoGaveWayIsShownThatItIsClearAndForgottenOnceItGoesOn() {
        FlyingDrone one = new FlyingDrone("a", 0, 0).stands("GUIDED");
        one.step = FlightIntent.Step.FLY;
        FlyingDrone passed = new FlyingDrone("b", 0, 300).to(0, 600, 20);
        yielding = Map.of(one.id, stood(passed));
        look(one, passed);
        assertThat(give(one).clear()).isTrue();

        one.mode = "AUTO";
        look(one, passed);
        assertThat(giveWays).isEmpty();
    }

    @Test
    void whatHasFallenIsInNobodysWay() {
        FlyingDrone one = new FlyingDrone("a", 0, -40).to(0, 60, 20);
        FlyingDrone fallen = new FlyingDrone("b", 0, 0).stands("AUTO");
        fallen.step = FlightIntent.Step.LIE;
        fallen.handling = Handling.FOREIGN;
        assertThat(look(one, fallen)).isEmpty();
        fallen.northward = -5;
        assertThat(look(one, fallen)).as("it flies after all").isNotEmpty();
        yielding = Map.of();
        fallen.link = LinkState.LOST;
        fallen.silence = Duration.ofSeconds(30);
        assertThat(look(one, fallen)).isEmpty();
    }

    /** Where it goes is known: it is not told to go less far meanwhile, as one that would stop here. */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void whoIsOnItsWayAsideIsNotSentElsewhere(boolean heeds) {
        FlyingDrone one = new FlyingDrone("a", 0, 0).stands("GUIDED");
        FlyingDrone other = new FlyingDrone("b", -70, 0).to(70, 0, 20);
        other.handling = Handling.STEERED;
        look(one, other);
        Command.GoTo first = (Command.GoTo) orders.get(0).command();
        assertThat(first.altitude().meters()).isGreaterThan(FlyingDrone.GROUND + 25);

        for (int step = 1; step <= 10; step++) {
            now = now.plusMillis(250);
            other.east += 2;
            if (heeds) {
                one.climbing = 2;
                one.height = Math.min(20 + 0.5 * step, first.altitude().meters() - FlyingDrone.GROUND);
            }
            look(one, other);
            if (heeds) {
                assertThat(orders).as("after %d steps", step).isEmpty();
            }
        }
        if (!heeds) {
            assertThat(give(one).since()).as("it is told again").isAfter(FlyingDrone.NOW);
        }
    }

    /** Each of them is clear of the other only as long as that one stands. */
    @Test
    void ofTwoThatWaitAndWouldMeetOneGoesOnFirst() {
        FlyingDrone one = new FlyingDrone("a", -40, 0).to(60, 0, 20);
        FlyingDrone other = new FlyingDrone("b", 0, -40).to(0, 60, 20);
        FlyingDrone passed = new FlyingDrone("c", 0, 400).to(0, 600, 20);
        List.of(one, other).forEach(drone -> {
            drone.mode = "GUIDED";
            drone.eastward = 0;
            drone.northward = 0;
        });
        yielding = Map.of(one.id, stood(passed), other.id, stood(passed));
        look(one, other, passed);
        assertThat(Stream.of(one, other).filter(drone -> give(drone).clear())).hasSize(1);
        FlyingDrone first = give(one).clear() ? one : other;

        now = now.plusMillis(250);
        look(one, other, passed);
        assertThat(give(first).clear()).as("it stays the first").isTrue();
        assertThat(Stream.of(one, other).filter(drone -> give(drone).clear())).hasSize(1);

        now = now.plusSeconds(20);
        look(one, other, passed);
        assertThat(give(first == one ? other : one).clear())
                .as("one that may go and does not keeps nobody for ever")
                .isTrue();
    }

    /** Seconds before they meet, a server that is not there any more could not stop them. */
    @ParameterizedTest
    @ValueSource(strings = {"another's", "of its own plan", "later", "later and alone", "much later and alone"})
    void doesNotSetOffForWhereItWouldMeetAMissionLongAfterwards(String whose) {
        FlyingDrone one = new FlyingDrone("a", 0, -400).risesTo(0, 400, 20);
        FlyingDrone other = new FlyingDrone("b", -550, 0).to(500, 0, 20);
        if (whose.equals("of its own plan")) {
            other.operation = one.operation;
        }
        one.goesOnAlone = whose.endsWith("alone");
        now = now.plusSeconds(whose.startsWith("later") ? 60 : whose.startsWith("much") ? 600 : 0);
        look(one, other);
        if (whose.equals("another's") || whose.equals("later and alone")) {
            assertThat(give(one).manner()).isEqualTo(GiveWay.Manner.WAIT);
            other.east = -100;
            look(one, other);
        }
        assertThat(giveWays).isEmpty();
    }

    /** It stands longer than the one that it gave way to needs, if it would meet another one later. */
    @ParameterizedTest
    @ValueSource(strings = {"another's", "of its own plan"})
    void doesNotGoOnForWhereItWouldMeetAMissionLongAfterwards(String whose) {
        FlyingDrone one = new FlyingDrone("a", 0, -400).to(0, 400, 20);
        one.mode = "GUIDED";
        one.northward = 0;
        FlyingDrone passed = new FlyingDrone("c", 0, -900).to(0, -1_500, 20);
        FlyingDrone other = new FlyingDrone("b", -420, 0).to(500, 0, 20);
        if (whose.equals("of its own plan")) {
            other.operation = one.operation;
        }
        yielding = Map.of(one.id, stood(passed));
        look(one, passed, other);
        assertThat(give(one).clear()).isFalse();

        now = now.plusSeconds(41);
        look(one, passed, other);
        assertThat(give(one).clear()).as("not for ever").isTrue();

        now = FlyingDrone.NOW;
        yielding = Map.of(one.id, stood(passed));
        other.east = -200;
        look(one, passed, other);
        assertThat(give(one).clear()).isTrue();
    }
}
