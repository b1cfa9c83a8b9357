package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Objects;
import org.dronemap.core.access.Role;
import org.dronemap.core.time.ScheduledTask;
import org.dronemap.sim.robot.BridgeQuirk;
import org.dronemap.ws.command.CommandView;
import org.dronemap.ws.control.SteeringRequest;
import org.dronemap.ws.drone.DroneView;
import org.dronemap.ws.lab.CommandRequests;
import org.dronemap.ws.lab.LabRobot;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.lab.RobotSpec;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Robots over ROSLink as drones of the cloud: listed, driven, stopped and flown, and each for itself. */
class RobotsTest {
    private static final Duration SOON = Duration.ofSeconds(20);
    private static final Duration OFTEN = Duration.ofMillis(100);

    private final Laboratory lab = new Laboratory(1);
    private final Pilot ann = lab.pilot("ann", Role.OPERATOR);

    @AfterEach
    void close() {
        lab.close();
    }

    @Test
    void aRoverIsShownOnItsOwnMapAndStopsWhenToldTo() {
        LabRobot rover = lab.robot(RobotSpec.rover(3_012)
                .showing("12")
                .onWeb("/websockets/roslink/user/12/robot/12/robot")
                .with(BridgeQuirk.NUMBER_KEY, BridgeQuirk.BEATS_ON_BOTH, BridgeQuirk.REPEATS_TWIST));
        LabRobot flyer = lab.robot(RobotSpec.flyer(3_026).showing("1243-0000-0000-FGFG"));
        rover.allows(ann, "hold");
        lab.until(
                "both of its links are known as one robot's",
                SOON,
                () -> !rover.view(ann).link().others().isEmpty());
        lab.until("it says where it is", SOON, () -> rover.view(ann).local() != null);
        DroneView shown = rover.view(ann);
        assertThat(List.of(shown.kind(), shown.link().transport())).containsExactly("rover", "websocket");
        assertThat(Objects.requireNonNull(shown.local()).y())
                .isEqualTo(rover.truth().y());
        assertThat(shown.position()).isNull();
        assertThat(shown.battery()).isNull();
        assertThat(shown.gps()).isNull();
        assertThat(shown.armed()).isNull();
        assertThat(shown.actions().get("takeOff").allowed()).isFalse();
        flyer.allows(ann, "arm");

        // Whoever calls in is told to stand still first, until it reports that it does.
        lab.until("it was told to stand", SOON, () -> rover.orders().size() >= 6);
        double before = rover.truth().x();
        ScheduledTask push = lab.time().worker("somebody beside it", 1).every(OFTEN, OFTEN, () -> rover.isPushed(0.4));
        lab.until("it is seen to move", SOON, () -> groundSpeed(rover) > 0.3);
        push.cancel();
        assertThat(rover.truth().x()).isGreaterThan(before);
        assertThat(rover.truth().speed()).isEqualTo(0.4);
        rover.does(ann, CommandRequests.hold());

        assertThat(rover.truth().speed()).isZero();
        assertThat(rover.orders()).containsOnly(LabRobot.TWIST);
        assertThat(flyer.orders()).isEmpty();
        assertThat(rover.wrong() + flyer.wrong()).isZero();
    }

    private double groundSpeed(LabRobot robot) {
        DroneView.MotionView motion = robot.view(ann).motion();
        Double speed = motion == null ? null : motion.groundSpeed();
        return speed == null ? 0 : speed;
    }

    @Test
    void aDroneBehindMavrosIsFlown() {
        LabRobot flyer = lab.robot(RobotSpec.flyer(3_026)).allows(ann, "arm");
        flyer.does(ann, CommandRequests.arm());
        assertThat(flyer.truth().armed()).isTrue();
        flyer.does(ann, CommandRequests.takeOff(3.0));
        assertThat(flyer.truth().height()).isGreaterThan(2.5);
        assertThat(flyer.view(ann).mode()).isEqualTo("GUIDED");
        flyer.does(ann, CommandRequests.land());
        assertThat(flyer.truth().height()).isZero();
        flyer.does(ann, CommandRequests.disarm());
        assertThat(flyer.truth().armed()).isFalse();
        assertThat(flyer.wrong()).isZero();
    }

    @Test
    void aRobotThatIgnoresAnOrderIsNeverSaidToHaveFollowedIt() {
        LabRobot stubborn = lab.robot(RobotSpec.flyer(3_099).with(BridgeQuirk.IGNORES_ORDERS))
                .allows(ann, "arm");
        CommandView.OutcomeView ended = stubborn.outcome(ann, CommandRequests.arm());
        assertThat(ended.result()).isEqualTo("failed");
        assertThat(ended.reason()).contains("still disarmed");
        assertThat(stubborn.truth().armed()).isFalse();
        assertThat(stubborn.orders().stream().filter(order -> order == LabRobot.ARM))
                .hasSizeGreaterThan(3);
    }

    @Test
    void aServerThatDiesInMidTwistLeavesNoRobotDriving() {
        // Bridges in the field drive on with what they heard last, for ever; ours stops half a second after it.
        LabRobot foreign = lab.robot(RobotSpec.rover(3_501).with(BridgeQuirk.REPEATS_TWIST));
        LabRobot ours = lab.robot(RobotSpec.rover(3_502).onWeb("/").with(BridgeQuirk.BEATS_ON_BOTH));
        List<LabRobot> both = List.of(foreign, ours);
        both.forEach(robot -> robot.allows(ann, "velocity"));
        lab.until("ours has both links", SOON, () -> hasBothLinks(ours));
        ScheduledTask sticks = lab.time().worker("sticks", 1).every(OFTEN, OFTEN, () -> both.forEach(this::steer));
        lab.until(
                "both drive",
                SOON,
                () -> both.stream().allMatch(robot -> robot.truth().speed() > 0.3));
        lab.crashServer();
        sticks.cancel();
        lab.until(
                "ours stands by itself",
                Duration.ofSeconds(1),
                () -> ours.truth().speed() == 0);
        lab.goOn(Duration.ofSeconds(2));
        assertThat(foreign.truth().speed()).as("it repeats what it heard last").isGreaterThan(0.3);

        int heard = foreign.orders().size();
        lab.startServer();
        // Robots call in once a second, and the server takes them in as soon as it listens.
        lab.until(
                "the other one stands, too",
                Duration.ofSeconds(3),
                () -> foreign.truth().speed() == 0);
        assertThat(foreign.orders().get(heard)).as("first of all").isEqualTo(LabRobot.TWIST);
        lab.until("ours has both links again", Duration.ofSeconds(30), () -> hasBothLinks(ours));
        assertThat(ours.truth().speed()).isZero();
    }

    private boolean hasBothLinks(LabRobot robot) {
        DroneView.LinkView link = robot.view(ann).link();
        return link.transport().equals("websocket") && link.others().size() == 1;
    }

    private void steer(LabRobot robot) {
        SteeringRequest.Velocity ahead = new SteeringRequest.Velocity(null, 0.4, null, null, null, null);
        lab.server()
                .steering()
                .steer(
                        ann.principal(),
                        "laboratory",
                        robot.state().id().value(),
                        new SteeringRequest(ahead, null, null));
    }
}
