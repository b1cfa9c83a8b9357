package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import org.dronemap.core.access.Role;
import org.dronemap.core.time.ScheduledTask;
import org.dronemap.sim.robot.BridgeQuirk;
import org.dronemap.ws.command.CommandRequest;
import org.dronemap.ws.control.ControlRequest;
import org.dronemap.ws.control.SteeringRequest;
import org.dronemap.ws.lab.CommandRequests;
import org.dronemap.ws.lab.LabRobot;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.lab.RobotSpec;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Robots over ROSLink that whoever had control leaves alone, or the server. */
class RobotsLeftAloneTest {
    private static final Duration SOON = Duration.ofSeconds(20);
    private static final Duration OFTEN = Duration.ofMillis(100);
    private static final double PATIENCE = 5;

    private final Laboratory lab = new Laboratory(1);
    private final Pilot ann = lab.pilot("ann", Role.OPERATOR);

    @AfterEach
    void close() {
        lab.close();
    }

    @Test
    void robotsThatMissTheServerStopAndLandAndHearTheNextOne() {
        LabRobot rover = lab.robot(RobotSpec.rover(3_601).missing(PATIENCE)).allows(ann, "goToLocal");
        LabRobot flyer = lab.robot(
                        RobotSpec.flyer(3_602).missing(PATIENCE).onWeb("/").with(BridgeQuirk.PAYLOAD_SHAPE))
                .allows(ann, "arm");
        fly(flyer);
        long before = rover.heartbeats();
        lab.throughout(
                "they hear the server, and miss nothing",
                Duration.ofSeconds(20),
                () -> flyer.truth().height() > 2.5);
        assertThat(rover.heartbeats() - before).isBetween(18L, 21L);
        begin(rover, CommandRequests.goToLocal(3.0, -1.0));
        lab.until("it goes", SOON, () -> rover.truth().speed() > 0.3);

        lab.crashServer();
        lab.throughout(
                "it may be back", Duration.ofMillis(3_900), () -> rover.truth().speed() > 0.3);
        lab.until("it stands", Duration.ofSeconds(2), () -> rover.truth().speed() == 0);
        lab.until("it is down", Duration.ofSeconds(5), () -> flyer.truth().height() == 0);
        assertThat(rover.truth().x()).isLessThan(2.9);

        int heard = flyer.heartbeats();
        lab.startServer();
        lab.until("the next one is heard", SOON, () -> flyer.heartbeats() > heard + 1);
    }

    @Test
    void aDroneBehindMavrosOfAHolderWhoFallsSilentStandsAndThenReturns() {
        LabRobot flyer = lab.robot(RobotSpec.flyer(3_603)).allows(ann, "arm");
        fly(flyer);
        takes(flyer);
        ScheduledTask sticks = steering(flyer);
        lab.until("it flies", SOON, () -> flyer.truth().speed() > 0.3);
        sticks.cancel();
        lab.until("it stands", Duration.ofSeconds(2), () -> flyer.truth().speed() == 0);
        lab.until(
                "it has lost its holder",
                SOON,
                () -> ann.control(id(flyer)).state().equals("free"));
        lab.throughout(
                "it may be taken",
                Duration.ofSeconds(25),
                () -> "GUIDED".equals(flyer.view(ann).mode()));
        lab.until("it returns", SOON, () -> "RTL".equals(flyer.view(ann).mode()));
        lab.until("it is down", SOON, () -> flyer.truth().height() == 0);
    }

    @Test
    void aDroneBehindMavrosReturnsWhenControlThatCameWithACommandRunsOut() {
        LabRobot flyer = lab.robot(RobotSpec.flyer(3_604)).allows(ann, "arm");
        fly(flyer);
        lab.throughout(
                "it may be taken",
                Duration.ofSeconds(50),
                () -> "GUIDED".equals(flyer.view(ann).mode()));
        lab.until("it returns", SOON, () -> "RTL".equals(flyer.view(ann).mode()));
        lab.until("it is down", SOON, () -> flyer.truth().height() == 0);
    }

    @Test
    void aRoverThatIsSteeredStandsWhenItsHolderFallsSilent() {
        LabRobot rover = lab.robot(RobotSpec.rover(3_605).with(BridgeQuirk.REPEATS_TWIST))
                .allows(ann, "velocity");
        takes(rover);
        ScheduledTask sticks = steering(rover);
        lab.until("it drives", SOON, () -> rover.truth().speed() > 0.3);
        sticks.cancel();
        lab.until("it stands", Duration.ofSeconds(1), () -> rover.truth().speed() == 0);
    }

    private void fly(LabRobot flyer) {
        flyer.does(ann, CommandRequests.arm());
        flyer.does(ann, CommandRequests.takeOff(3.0));
        assertThat(flyer.truth().height()).isGreaterThan(2.5);
    }

    private static String id(LabRobot robot) {
        return robot.state().id().value();
    }

    private void takes(LabRobot robot) {
        ann.controls(id(robot), new ControlRequest.TakeControl());
    }

    private void begin(LabRobot robot, CommandRequest what) {
        var unused = lab.server().commands().submit(ann.principal(), "laboratory", id(robot), what);
    }

    private ScheduledTask steering(LabRobot robot) {
        SteeringRequest.Velocity ahead = new SteeringRequest.Velocity(null, 0.4, null, null, null, null);
        return lab.time()
                .worker("sticks", 1)
                .every(
                        OFTEN,
                        OFTEN,
                        () -> lab.server()
                                .steering()
                                .steer(
                                        ann.principal(),
                                        "laboratory",
                                        id(robot),
                                        new SteeringRequest(ahead, null, null)));
    }
}
