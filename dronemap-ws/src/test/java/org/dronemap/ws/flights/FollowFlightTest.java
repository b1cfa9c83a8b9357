package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.stream.Stream;
import org.dronemap.core.access.Role;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.mavlink.message.CommandInt;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.SetPositionTargetGlobalInt;
import org.dronemap.ws.follow.FollowRequest.PlaceRequest;
import org.dronemap.ws.follow.FollowView;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.LinkTraffic;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.lab.SimulatedPhone;
import org.dronemap.ws.lab.VehicleSpec;
import org.dronemap.ws.problem.Rejection;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** A phone that is followed by a simulated copter, as it is asked for and as it truly is. */
class FollowFlightTest {
    private static final long RTL = 6;
    private static final double DISTANCE = 6;
    private static final double HEIGHT = 10;
    private static final double FACE = 1.5;

    private final Laboratory lab = new Laboratory(1);

    @AfterEach
    void close() {
        lab.close();
    }

    private static PlaceRequest south(double distance, double height) {
        return new PlaceRequest("fixed", 180.0, null, distance, height);
    }

    private static double near(FollowView seen) {
        return Objects.requireNonNullElse(seen.now().distance(), Double.POSITIVE_INFINITY);
    }

    @Test
    void aPhoneIsFollowedInTheOrderOfItsSequence() {
        LabDrone copter = lab.copter();
        SimulatedPhone phone = lab.phone(lab.pilot("ann", Role.OPERATOR), copter, 20, 0);
        phone.asks(copter, south(5, 5), 60);
        assertThat(phone.view().state()).isEqualTo("allocated");
        assertThat(phone.view().drone()).isEqualTo(copter.id().value());
        assertThatThrownBy(phone::stops).isInstanceOf(Rejection.class).hasMessageContaining("has not been started");
        assertThat(phone.starts().view().state()).isEqualTo("starting");

        phone.awaits("tracking", Duration.ofSeconds(40));
        lab.untilSeen("the drone has come", Duration.ofSeconds(40), () -> near(phone.view()) < 15);
        assertThat(copter.distanceTo(phone.place())).isLessThan(16);
        assertThat(phone.pauses().state()).isEqualTo("paused");
        assertThat(phone.goesOn().state()).isEqualTo("starting");
        phone.awaits("tracking", Duration.ofSeconds(10));
        lab.untilSeen("it follows again", Duration.ofSeconds(10), () -> near(phone.view()) < 15);
        assertThat(phone.stops().state()).isEqualTo("returning");
        lab.until("it flies home", Duration.ofSeconds(20), () -> copter.mode() == RTL);

        assertThat(told(copter).limit(3)).containsExactly("arm", "take off", "location");
        phone.awaits("over", Duration.ofMinutes(1));
        assertThat(phone.view().end()).contains("is down");
        assertThat(copter.isDown()).isTrue();
    }

    /** What it was told to do, each once, in the order in which it came first. */
    private static Stream<String> told(LabDrone copter) {
        Map<Integer, String> known = Map.of(400, "arm", 22, "take off", 20, "home");
        return copter.wire().traffic().down(0, CommandLong.ID, CommandInt.ID, SetPositionTargetGlobalInt.ID).stream()
                .map(LinkTraffic.Heard::frame)
                .map(frame -> switch (frame.messageId()) {
                    case CommandLong.ID ->
                        known.getOrDefault(CommandLong.decode(frame).command(), "");
                    case CommandInt.ID ->
                        known.getOrDefault(CommandInt.decode(frame).command(), "");
                    default -> "location";
                })
                .filter(step -> !step.isEmpty())
                .distinct();
    }

    @Test
    void aCopterWalksBesideAPhoneAndComesHome() {
        LabDrone copter = lab.ready(lab.add(VehicleSpec.COPTER.with(Map.of("MNT1_TYPE", 1.0))));
        SimulatedPhone phone = lab.phone(lab.pilot("ann", Role.OPERATOR), copter, 15, 0);
        phone.asks(copter, new PlaceRequest("behind", null, null, DISTANCE, HEIGHT), 60)
                .starts()
                .walks(0, 1.4);
        phone.awaits("tracking", Duration.ofMinutes(1));
        lab.goOn(Duration.ofSeconds(15));
        double sum = 0;
        for (int look = 0; look < 75; look++) {
            lab.goOn(Duration.ofMillis(200));
            Geodetic wanted = phone.beside(0, -DISTANCE);
            sum += Geodesy.distanceMeters(copter.where(), wanted);
            assertThat(copter.height()).isBetween(HEIGHT - 2, HEIGHT + 2);
        }
        assertThat(sum / 75).as("mean metres from where it is wanted").isLessThan(2);
        double face = -Math.toDegrees(Math.atan2(HEIGHT - FACE, DISTANCE));
        assertThat(gaze(copter)).isBetween(face - 8, face + 8);

        phone.pauses();
        phone.awaits("paused", Duration.ofSeconds(5));
        phone.stops();
        phone.awaits("over", Duration.ofMinutes(2));
        assertThat(phone.view().end()).contains("is down");
        assertThat(gaze(copter)).as("the camera was let go").isZero();
        assertThat(copter.isDown()).isTrue();
    }

    /** How far the camera truly looks above the horizon, in degrees. */
    private static double gaze(LabDrone copter) {
        String words = copter.vehicle().autopilot().payload().words();
        return Double.parseDouble(words.substring(words.lastIndexOf("gimbal ") + "gimbal ".length()));
    }

    @Test
    void aFollowGoesOnOverACrashOfTheServerThatIsShort() {
        LabDrone copter = lab.copter();
        SimulatedPhone phone = follows(copter);

        lab.crashServer();
        lab.goOn(Duration.ofSeconds(3));
        lab.startServer();
        lab.goOn(Duration.ofSeconds(5));

        assertThat(copter.mode()).isNotEqualTo(RTL);
        assertThat(phone.view().state()).isEqualTo("tracking");
        phone.walks(0, 1.5);
        lab.goOn(Duration.ofSeconds(20));
        assertThat(copter.distanceTo(phone.place())).isLessThan(15);
    }

    @Test
    void aDroneThatMissedTheCloudFollowsAgain() {
        LabDrone copter = lab.copter();
        SimulatedPhone phone = follows(copter);

        lab.crashServer();
        lab.until("it misses the cloud", Duration.ofSeconds(25), () -> copter.mode() == RTL);
        lab.startServer();
        lab.untilSeen("it is told", Duration.ofSeconds(30), () -> phone.wasTold("it follows again"));
        phone.awaits("tracking", Duration.ofSeconds(60));

        phone.walks(0, 1.5);
        lab.goOn(Duration.ofSeconds(30));
        assertThat(copter.distanceTo(phone.place())).isLessThan(15);
        phone.stops();
        phone.awaits("over", Duration.ofMinutes(3));
        assertThat(copter.isDown()).isTrue();
    }

    private SimulatedPhone follows(LabDrone copter) {
        SimulatedPhone phone = lab.phone(lab.pilot("ann", Role.OPERATOR), copter, 40, 0);
        phone.asks(copter, south(5, 20), 600).starts();
        phone.awaits("tracking", Duration.ofMinutes(1));
        lab.until("it has come", Duration.ofMinutes(1), () -> copter.distanceTo(phone.beside(-5, 0)) < 3);
        return phone;
    }

    @Test
    void aDroneThatRunsLowIsReplacedAndNobodyIsLost() {
        LabDrone first = lab.copter();
        LabDrone second = lab.copter();
        SimulatedPhone phone = lab.phone(lab.pilot("ann", Role.OPERATOR), first, 40, 0);
        phone.asks(first, new PlaceRequest("behind", null, null, 8.0, 15.0), 60).starts();
        phone.awaits("tracking", Duration.ofMinutes(1));
        lab.server()
                .warehouse()
                .put(
                        lab.pilot("chief", Role.SUPERVISOR).principal(),
                        second.id().value());
        first.craft().battery().setRemainingPercent(46);
        phone.walks(0, 1.4);
        long since = lab.time().nanos();

        lab.untilSeen("it has been replaced", Duration.ofSeconds(400), () -> {
            requireNear(phone, first, second);
            return phone.view().drone().equals(second.id().value());
        });
        for (int seconds = 0; seconds < 45; seconds++) {
            lab.goOn(Duration.ofSeconds(1));
            requireNear(phone, first, second);
        }

        assertThat(phone.view().state()).isEqualTo("tracking");
        assertThat(phone.wasTold("comes to replace it")).isTrue();
        assertThat(phone.wasTold("has taken over")).isTrue();
        assertThat(apart(first, second, since))
                .as("both in the air, at the nearest")
                .isTrue();
    }

    /** One of them is with the phone, and it is followed all along. */
    private static void requireNear(SimulatedPhone phone, LabDrone first, LabDrone second) {
        assertThat(phone.view().state()).isEqualTo("tracking");
        assertThat(Math.min(first.distanceTo(phone.place()), second.distanceTo(phone.place())))
                .isLessThan(50);
    }

    /** Never nearer than 10 m over the ground and 5 m in height while both are in the air. */
    private static boolean apart(LabDrone one, LabDrone other, long since) {
        var tracks = List.of(one.track().since(since), other.track().since(since));
        for (int look = 0; look < tracks.get(0).size(); look++) {
            var a = tracks.get(0).get(look);
            var b = tracks.get(1).get(look);
            boolean aloft = a.height() > 1 && b.height() > 1;
            if (aloft && Geodesy.distanceMeters(a.place(), b.place()) < 10 && Math.abs(a.amsl() - b.amsl()) < 5) {
                return false;
            }
        }
        return true;
    }

    private Pilot hoversAbove(LabDrone above, LabDrone other) {
        Pilot bob = lab.pilot("bob", Role.OPERATOR);
        bob.takesOff(above, 15).fliesTo(above, other.place(0, 0), 15);
        lab.until("it hovers above the other", Duration.ofMinutes(1), () -> above.distanceTo(other.where()) < 2);
        return bob;
    }

    @Test
    void aTakeOffThatAnotherDroneBlocksWaitsAndThenGoes() {
        List<LabDrone> copters = lab.copters(2);
        LabDrone follows = copters.get(0);
        LabDrone above = copters.get(1);
        Pilot bob = hoversAbove(above, follows);
        lab.goOn(Duration.ofSeconds(10));

        SimulatedPhone phone = lab.phone(lab.pilot("ann", Role.OPERATOR), follows, -40, -40);
        phone.asks(follows, south(5, 10), 60).starts();
        lab.throughout("it stays on the ground", Duration.ofSeconds(15), follows::isDown);
        assertThat(phone.view().note()).contains("waits on the ground until another drone has passed.");

        bob.fliesTo(above, follows.place(0, 300), 15);
        phone.awaits("tracking", Duration.ofMinutes(1));
        assertThat(above.distanceTo(follows.where())).isGreaterThan(10);
    }

    @Test
    void aTakeOffThatStaysBlockedIsGivenUpWithTheReason() {
        List<LabDrone> copters = lab.copters(2);
        LabDrone follows = copters.get(0);
        LabDrone above = copters.get(1);
        Pilot bob = hoversAbove(above, follows);

        SimulatedPhone phone = lab.phone(lab.pilot("ann", Role.OPERATOR), follows, -40, -40);
        phone.asks(follows, south(5, 10), 60).starts();
        lab.untilSeen(
                "it says for whom it waits",
                Duration.ofSeconds(5),
                () -> String.valueOf(phone.view().note()).contains("waits on the ground until another drone has"));
        for (int i = 0; i < 5; i++) {
            lab.throughout("it stays on the ground", Duration.ofSeconds(20), follows::isDown);
            bob.fliesTo(above, follows.place(0, 0), 15);
        }
        phone.awaits("over", Duration.ofSeconds(35));
        assertThat(phone.view().end()).endsWith(" cannot take off: another drone has not left its way up for 2 min.");
        assertThat(follows.isDown()).isTrue();
    }

    @Test
    void itsWayHomeWaitsForOneThatIsInIt() {
        List<LabDrone> copters = lab.copters(2);
        LabDrone follows = copters.get(0);
        LabDrone other = copters.get(1);
        SimulatedPhone phone = lab.phone(lab.pilot("ann", Role.OPERATOR), follows, 120, 0);
        phone.asks(follows, south(5, 15), 60).starts();
        phone.awaits("tracking", Duration.ofMinutes(1));
        lab.until("it has come", Duration.ofMinutes(1), () -> follows.distanceTo(phone.place()) < 15);
        Pilot bob = lab.pilot("bob", Role.OPERATOR);
        bob.takesOff(other, 15).fliesTo(other, follows.place(50, 0), 15);
        lab.until("one hovers in its way", Duration.ofMinutes(1), () -> other.distanceTo(follows.place(50, 0)) < 2);
        lab.goOn(Duration.ofSeconds(8));

        phone.stops();
        lab.throughout(
                "they stay apart",
                Duration.ofSeconds(40),
                () -> follows.distanceTo(other.where()) > 10 || Math.abs(follows.height() - other.height()) > 5);
        bob.fliesTo(other, follows.place(0, 300), 15);
        phone.awaits("over", Duration.ofMinutes(3));
        assertThat(follows.away()).isLessThan(3);
    }
}
