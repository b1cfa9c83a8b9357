package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import org.dronemap.core.access.Role;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.ws.dispatch.DispatchRequest;
import org.dronemap.ws.dispatch.DispatchView;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.LaboratorySetup;
import org.dronemap.ws.lab.Pilot;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Drones that are sent to a place stay apart from others: at the take-off, on the way, and on the way home. */
class DispatchSeparationTest {
    private static final double HEIGHT = 20;
    private static final Duration WAY = Duration.ofMinutes(3);
    private static final double LEAST_METERS = 10;
    private static final double LEAST_HEIGHT = 5;

    private static void lends(Laboratory lab, Pilot chief, LabDrone drone) {
        lab.server().warehouse().put(chief.principal(), drone.id().value());
    }

    private static DispatchView sends(Laboratory lab, Pilot user, Geodetic place) {
        return lab.server()
                .dispatches()
                .send(
                        user.principal(),
                        new DispatchRequest(place.latitudeDegrees(), place.longitudeDegrees(), HEIGHT, null));
    }

    private static DispatchView view(Laboratory lab, Pilot user, DispatchView sent) {
        return lab.server().dispatches().one(user.principal(), sent.id());
    }

    private static boolean areApart(LabDrone one, LabDrone other) {
        return one.isDown()
                || other.isDown()
                || one.distanceTo(other.where()) >= LEAST_METERS
                || Math.abs(one.height() - other.height()) >= LEAST_HEIGHT;
    }

    /** Bob's drone, at the height to which the other one, that may be sent, rises. */
    private static Pilot hoversAbove(Laboratory lab, LabDrone above, LabDrone sent) {
        lends(lab, lab.pilot("chief", Role.SUPERVISOR), sent);
        Pilot bob = lab.pilot("bob", Role.OPERATOR);
        bob.takesOff(above, HEIGHT).fliesTo(above, sent.place(0, 0), HEIGHT);
        lab.until("it hovers above the other", WAY, () -> above.distanceTo(sent.where()) < 2);
        return bob;
    }

    @Test
    void aTakeOffThatAnotherDroneBlocksWaitsAndThenGoes() {
        try (Laboratory lab = new Laboratory(1)) {
            List<LabDrone> copters = lab.copters(2);
            LabDrone sent = copters.get(0);
            LabDrone above = copters.get(1);
            Pilot bob = hoversAbove(lab, above, sent);
            lab.goOn(Duration.ofSeconds(10));

            Pilot ann = lab.pilot("ann", Role.OPERATOR);
            DispatchView dispatch = sends(lab, ann, sent.place(60, -40));
            lab.throughout("it stays on the ground", Duration.ofSeconds(15), sent::isDown);
            assertThat(view(lab, ann, dispatch).note())
                    .isEqualTo(dispatch.droneName() + " waits on the ground until another drone has passed.");

            bob.fliesTo(above, sent.place(0, 300), HEIGHT);
            lab.throughout("they are apart", Duration.ofSeconds(40), () -> areApart(sent, above));
            lab.untilSeen(
                    "it is there", WAY, () -> view(lab, ann, dispatch).state().equals("here"));
            assertThat(view(lab, ann, dispatch).note()).isNull();
        }
    }

    @Test
    void aTakeOffThatStaysBlockedIsGivenUpWithTheReason() {
        try (Laboratory lab = new Laboratory(1)) {
            List<LabDrone> copters = lab.copters(2);
            LabDrone sent = copters.get(0);
            LabDrone above = copters.get(1);
            Pilot bob = hoversAbove(lab, above, sent);
            var unused = bob.takesControl(above);

            Pilot ann = lab.pilot("ann", Role.OPERATOR);
            DispatchView dispatch = sends(lab, ann, sent.place(60, -40));
            lab.untilSeen(
                    "it says for whom it waits",
                    Duration.ofSeconds(5),
                    () -> (dispatch.droneName() + " waits on the ground until another drone has passed.")
                            .equals(view(lab, ann, dispatch).note()));
            for (int i = 0; i < 5; i++) {
                lab.throughout("it stays on the ground", Duration.ofSeconds(20), sent::isDown);
                bob.fliesTo(above, sent.place(0, 0), HEIGHT);
            }
            lab.untilSeen(
                    "it is over",
                    Duration.ofSeconds(35),
                    () -> view(lab, ann, dispatch).state().equals("over"));
            assertThat(view(lab, ann, dispatch).told().toString())
                    .contains(dispatch.droneName()
                            + " cannot take off: another drone has not left its way up for 2 min.");
            assertThat(sent.isDown()).isTrue();
        }
    }

    /** Their ways cross in the middle, at one height, and they begin at moments from which they would meet. */
    private static boolean crossApart(Laboratory lab, int secondsLater) {
        List<LabDrone> copters = lab.copters(4);
        LabDrone one = copters.get(0);
        LabDrone other = copters.get(3);
        Pilot ann = lab.pilot("ann", Role.OPERATOR);
        Pilot bob = lab.pilot("bob", Role.OPERATOR);
        Geodetic mine = other.place(120, 0);
        Geodetic yours = one.place(120, 0);
        Pilot chief = lab.pilot("chief", Role.SUPERVISOR);
        lends(lab, chief, one);
        DispatchView first = sends(lab, ann, mine);
        lab.goOn(Duration.ofSeconds(secondsLater));
        lends(lab, chief, other);
        DispatchView second = sends(lab, bob, yours);
        boolean[] near = {false};
        lab.untilSeen("both are there", WAY, () -> {
            near[0] |= !areApart(one, other);
            return view(lab, ann, first).state().equals("here")
                    && view(lab, bob, second).state().equals("here");
        });
        assertThat(one.distanceTo(mine)).isLessThan(6);
        assertThat(other.distanceTo(yours)).isLessThan(6);
        return !near[0];
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2})
    void twoWhoseWaysCrossStayApart(int secondsLater) {
        try (Laboratory lab = new Laboratory(1)) {
            assertThat(crossApart(lab, secondsLater)).isTrue();
        }
    }

    @Test
    void withNothingThatKeepsThemApartTheyWouldMeet() {
        try (Laboratory lab = LaboratorySetup.seeded(1).separation(false).build()) {
            assertThat(crossApart(lab, 0)).isFalse();
        }
    }
}
