package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.time.Duration;
import java.util.List;
import java.util.Objects;
import org.dronemap.core.access.Role;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.ws.control.ControlRequest;
import org.dronemap.ws.dispatch.DispatchRequest;
import org.dronemap.ws.dispatch.DispatchView;
import org.dronemap.ws.drone.ControlView;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.lab.ZoneFixtures;
import org.dronemap.ws.problem.Rejection;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** A drone of the pool is sent to a place, as it is asked for and as it truly flies. */
class DispatchFlightTest {
    private static final long RTL = 6;
    private static final long LOITER = 5;
    private static final double HEIGHT = 20;
    private static final Duration WAY = Duration.ofMinutes(2);

    private final Laboratory lab = new Laboratory(1);
    private final Pilot ann = lab.pilot("ann", Role.OPERATOR);
    private final Pilot chief = lab.pilot("chief", Role.SUPERVISOR);
    private final List<LabDrone> copters = lab.copters(3);
    private final LabDrone near = copters.get(0);
    private final LabDrone second = copters.get(1);
    private final LabDrone far = copters.get(2);

    @AfterEach
    void close() {
        lab.close();
    }

    private void lends(LabDrone... drones) {
        for (LabDrone drone : drones) {
            lab.server().warehouse().put(chief.principal(), drone.id().value());
        }
    }

    /** West of the first one, so that the next ones are farther. */
    private Geodetic place() {
        return near.place(60, -40);
    }

    private DispatchView sends(Pilot user, Geodetic place) {
        return lab.server()
                .dispatches()
                .send(
                        user.principal(),
                        new DispatchRequest(place.latitudeDegrees(), place.longitudeDegrees(), HEIGHT, null));
    }

    private DispatchView view(Pilot user, DispatchView sent) {
        return lab.server().dispatches().one(user.principal(), sent.id());
    }

    private DispatchView awaits(Pilot user, DispatchView sent, String state) {
        lab.untilSeen("it is " + state, WAY, () -> view(user, sent).state().equals(state));
        return view(user, sent);
    }

    private static boolean wasTold(DispatchView seen, String words) {
        return seen.told().stream().anyMatch(one -> one.words().contains(words));
    }

    private static String id(LabDrone drone) {
        return drone.id().value();
    }

    @Test
    void theNearestComesAndTheAskerGetsControl() {
        lends(near, second, far);
        DispatchView sent = sends(ann, place());
        assertThat(sent.state()).isEqualTo("chosen");
        assertThat(sent.drone()).isEqualTo(id(near));
        assertThat(sent.told().get(0).words()).contains("was chosen", "the runner-up");
        assertThat(Objects.requireNonNull(sent.now()).seconds()).isBetween(30, 70);

        awaits(ann, sent, "starting");
        awaits(ann, sent, "enRoute");
        assertThat(near.height()).isGreaterThan(HEIGHT - 4);
        DispatchView here = awaits(ann, sent, "here");
        assertThat(near.distanceTo(place())).isLessThan(6);
        assertThat(Objects.requireNonNull(here.now()).seconds()).isNull();
        ControlView control = ann.control(near);
        assertThat(control.explicit()).isTrue();
        assertThat(control.holder()).isEqualTo("ann");

        // The page takes it up.
        long epoch = ann.takesControl(near).epoch();
        for (int beat = 0; beat < 30; beat++) {
            lab.goOn(Duration.ofSeconds(2));
            ann.controls(near, new ControlRequest.Heartbeat(epoch));
        }
        assertThat(view(ann, sent).state()).isEqualTo("here");
        assertThat(near.distanceTo(place())).isLessThan(6);
        assertThat(near.mode()).isNotEqualTo(RTL);

        // Then nobody is there any more.
        lab.until("it flies home", Duration.ofSeconds(50), () -> near.mode() == RTL);
        assertThat(awaits(ann, sent, "over").end()).contains("control", "ended");
        lab.until("it is down", WAY, near::isDown);
        assertThat(near.away()).isLessThan(3);
        assertThat(second.isDown() && far.isDown()).isTrue();
    }

    @Test
    void whoNeverTakesTheControlUpHasNoDroneLeftInTheAir() {
        lends(near);
        DispatchView sent = sends(ann, place());
        awaits(ann, sent, "here");
        lab.until("it flies home", Duration.ofSeconds(60), () -> near.mode() == RTL);
        lab.until("it is down", WAY, near::isDown);
        assertThat(view(ann, sent).state()).isEqualTo("over");
    }

    @Test
    void oneThatRefusesToArmIsReplacedByAnother() {
        lends(near, second);
        DispatchView sent = sends(ann, place());
        near.craft().failMotor();

        DispatchView here = awaits(ann, sent, "here");
        assertThat(here.drone()).isEqualTo(id(second));
        assertThat(wasTold(here, "cannot be armed")).isTrue();
        assertThat(second.distanceTo(place())).isLessThan(6);
        assertThat(ann.control(second).holder()).isEqualTo("ann");
        assertThat(ann.control(near).state()).isEqualTo("free");
        assertThat(near.isDown()).isTrue();
    }

    @Test
    void oneThatAPilotTakesIsReplacedAndLeftToThePilot() {
        lends(near, second);
        // The way of the second one leads past the pilot's reach.
        DispatchView sent = sends(ann, near.place(120, 25));
        awaits(ann, sent, "enRoute");
        near.switchedTo(LOITER);

        DispatchView here = awaits(ann, sent, "here");
        assertThat(here.drone()).isEqualTo(id(second));
        assertThat(wasTold(here, "was taken")).isTrue();
        assertThat(near.mode()).isEqualTo(LOITER);
    }

    @Test
    void oneWhoseLinkIsLostIsReplacedAndComesHomeWhenItIsHeard() {
        lends(near, second);
        DispatchView sent = sends(ann, place());
        awaits(ann, sent, "enRoute");
        near.wire().cut();

        DispatchView here = awaits(ann, sent, "here");
        assertThat(here.drone()).isEqualTo(id(second));
        assertThat(here.others()).extracting(DispatchView.OtherView::drone).containsExactly(id(near));
        near.wire().mend();
        lab.until("the first one is down at home", WAY, () -> near.isDown() && near.away() < 3);
    }

    @Test
    void oneWithTooLittleInItsBatteryFliesHomeAndAnotherComes() {
        lends(near, second);
        DispatchView sent = sends(ann, place());
        awaits(ann, sent, "enRoute");
        near.craft().battery().setRemainingPercent(20);

        DispatchView here = awaits(ann, sent, "here");
        assertThat(here.drone()).isEqualTo(id(second));
        assertThat(wasTold(here, "its battery has")).isTrue();
        lab.until("the first one is down at home", WAY, () -> near.isDown() && near.away() < 3);
    }

    @Test
    void whenNoneCanComeTheAskerReadsWhy() {
        lends(near);
        Rejection none = catchThrowableOfType(Rejection.class, () -> sends(ann, near.place(9_000, 0)));
        assertThat(none.sentence()).startsWith("No drone can come now. ").contains("battery");

        DispatchView sent = sends(ann, place());
        near.craft().failMotor();
        DispatchView over = awaits(ann, sent, "over");
        assertThat(over.end()).contains("No other drone can come");
        assertThat(over.drone()).isNull();
    }

    @Test
    void calledOffItComesHomeFromWhereverItIs() {
        lends(near);
        DispatchView first = sends(ann, place());
        awaits(ann, first, "enRoute");
        lab.goOn(Duration.ofSeconds(3));
        assertThat(cancels(ann, first).state()).isEqualTo("returning");
        lab.until("it flies home", Duration.ofSeconds(5), () -> near.mode() == RTL);
        assertThat(awaits(ann, first, "over").end()).contains("called it off");
        assertThat(near.isDown() && near.away() < 3).isTrue();

        DispatchView again = sends(ann, place());
        awaits(ann, again, "here");
        ann.takesControl(near);
        assertThat(cancels(ann, again).state()).isEqualTo("returning");
        lab.until("it flies home", Duration.ofSeconds(5), () -> near.mode() == RTL);
        awaits(ann, again, "over");
        assertThat(near.isDown() && near.away() < 3).isTrue();
    }

    private DispatchView cancels(Pilot user, DispatchView sent) {
        return lab.server().dispatches().cancel(user.principal(), sent.id());
    }

    @Test
    void aRestartOnTheWayIsNoEndOfIt() {
        lends(near);
        DispatchView sent = sends(ann, place());
        awaits(ann, sent, "enRoute");
        lab.goOn(Duration.ofSeconds(2));
        lab.crashServer();
        lab.goOn(Duration.ofSeconds(3));
        lab.startServer();

        DispatchView here = awaits(ann, sent, "here");
        assertThat(near.distanceTo(place())).isLessThan(6);
        assertThat(here.drone()).isEqualTo(id(near));
        assertThat(ann.control(near).holder()).isEqualTo("ann");
    }

    @Test
    void aRestartAtAnyMomentLeavesNoDroneInTheAir() {
        lends(near, second);
        DispatchView sent = sends(ann, place());
        for (int crash = 0; crash < 8; crash++) {
            lab.goOn(Duration.ofMillis(4_700));
            lab.crashServer();
            lab.goOn(Duration.ofSeconds(1));
            lab.startServer();
        }
        lab.untilSeen(
                "it was here, or is over",
                WAY,
                () -> List.of("here", "over").contains(view(ann, sent).state()));
        lab.until("all are down", Duration.ofMinutes(4), () -> copters.stream().allMatch(LabDrone::isDown));
    }

    @Test
    void twoWhoAskInTheSameMomentGetTwoDronesAndTheThirdASentence() {
        lends(near, second);
        Pilot bob = lab.pilot("bob", Role.OPERATOR);
        DispatchView first = sends(ann, place());
        DispatchView other = sends(bob, near.place(40, 120));
        assertThat(first.drone()).isEqualTo(id(near));
        assertThat(other.drone()).isEqualTo(id(second));
        Rejection none = catchThrowableOfType(Rejection.class, () -> sends(lab.pilot("cy", Role.OPERATOR), place()));
        assertThat(none.sentence()).contains("has had control of it since");
        awaits(ann, first, "here");
        awaits(bob, other, "here");
        assertThat(ann.control(near).holder()).isEqualTo("ann");
        assertThat(bob.control(second).holder()).isEqualTo("bob");
    }

    @Test
    void anAskerWhoMayNoLongerCommandGetsNoDrone() {
        lends(near);
        DispatchView sent = sends(ann, place());
        awaits(ann, sent, "enRoute");
        lab.administrator().disables(ann);

        lab.until("it flies home", Duration.ofSeconds(10), () -> near.mode() == RTL);
        DispatchView over = awaits(chief, sent, "over");
        assertThat(over.end()).contains("may not command it any more");
        assertThat(near.isDown() && near.away() < 3).isTrue();
    }

    @Test
    void aDroneWhoseWayAZoneBarsDoesNotCome() {
        lends(near, second);
        lab.server().zones().add(chief.principal(), ZoneFixtures.circle("Pond", near.place(40, 0), 15, near, null));
        assertThat(sends(ann, near.place(80, 0)).drone()).isEqualTo(id(second));
        lab.server().zones().add(chief.principal(), ZoneFixtures.circle("School", place(), 15, null, null));
        Rejection none = catchThrowableOfType(Rejection.class, () -> sends(ann, place()));
        assertThat(none.sentence()).contains("School");
    }

    @Test
    void onlyWhoAskedCallsADroneOffThatTheyHaveInHand() {
        lends(near);
        Pilot bob = lab.pilot("bob", Role.OPERATOR);
        DispatchView sent = sends(ann, place());
        awaits(ann, sent, "here");
        Rejection refused = catchThrowableOfType(Rejection.class, () -> cancels(bob, sent));
        assertThat(refused.sentence()).isEqualTo("Only ann calls that drone off now.");
    }
}
