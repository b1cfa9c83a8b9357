package org.dronemap.proxy.roslink;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.CommandGate;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.Refusal;
import org.dronemap.core.command.Setpoint;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.time.RealTime;
import org.dronemap.proxy.TestCloud;
import org.dronemap.proxy.endpoint.DtlsKeys;
import org.dronemap.proxy.endpoint.EndpointSecurity;
import org.dronemap.proxy.endpoint.EndpointUrl;
import org.dronemap.proxy.record.TextMessageTap;
import org.dronemap.proxy.session.Enrolment;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import tools.jackson.databind.JsonNode;

/** A cloud with the links to robots on real sockets, and what tests ask of it. */
abstract class RobotTestBase {
    static final Duration PATIENCE = Duration.ofSeconds(15);
    static final int TURTLEBOT = 8;
    static final int QUADROTOR = 3;
    static final String SECRET_OF_7 = TestRobotKeys.OF_7;
    static final String SECRET_OF_8 = TestRobotKeys.OF_8;

    private static final CommandGate.Source PILOT =
            new CommandGate.Source(new Principal("pilot", Role.OPERATOR), "stream");

    final TestRobotKeys keys = new TestRobotKeys();
    final TestCloud house = new TestCloud(0);
    RoslinkConnector proxy = open(Enrolment.LOOPBACK);

    @BeforeEach
    void start() throws IOException {
        proxy.start();
    }

    @AfterEach
    void stop() {
        proxy.close();
        house.close();
    }

    RoslinkConnector open(Enrolment enrolment) {
        return new RoslinkConnector(
                house.cloud(),
                house.lanes(),
                List.of(EndpointUrl.parse("udpserver://127.0.0.1:0"), EndpointUrl.parse("wsserver://127.0.0.1:0")),
                new RoslinkConnector.Policy(keys, this::tap, EndpointSecurity.of(DtlsKeys.none()), enrolment),
                new RealTime());
    }

    /** What hears the next session. */
    TextMessageTap tap() {
        return TextMessageTap.NONE;
    }

    int udp() {
        return proxy.endpoints().get(0).url().port();
    }

    int web() {
        return proxy.endpoints().get(1).url().port();
    }

    CompletableFuture<Outcome> command(DroneState drone, Command command) {
        return CompletableFuture.supplyAsync(() -> house.command(drone.id(), command))
                .orTimeout(30, TimeUnit.SECONDS);
    }

    /** As whoever commands, too. */
    Optional<String> steer(DroneState drone, Setpoint setpoint) {
        return house.cloud().setpoints().steer(PILOT, drone.id(), setpoint).map(Refusal::sentence);
    }

    /** The next twist that is no stop. */
    static JsonNode moving(TestRobot robot) throws InterruptedException {
        while (true) {
            JsonNode twist = Objects.requireNonNull(robot.order(100, 5_000));
            if (twist.path("vx").asDouble() != 0) {
                return twist;
            }
        }
    }

    static void beat(TestRobot robot) throws IOException {
        robot.beat(TURTLEBOT);
    }

    DroneState awaitDrone(int systemId, Predicate<DroneState> wanted) {
        return TestCloud.await(
                PATIENCE,
                () -> house.cloud().drones().stream()
                        .filter(drone -> drone.link().key().systemId() == systemId)
                        .filter(wanted)
                        .findFirst(),
                () -> "no drone as wanted among " + house.cloud().drones());
    }

    /** Something that may be tried again and again. */
    interface Check {
        boolean isThere() throws IOException, InterruptedException;
    }

    void await(Check look) {
        TestCloud.await(
                PATIENCE,
                () -> {
                    try {
                        return look.isThere();
                    } catch (InterruptedException e) {
                        Thread.currentThread().interrupt();
                        throw new AssertionError(e);
                    } catch (IOException e) {
                        throw new AssertionError(e);
                    }
                },
                () -> "not there: " + house.cloud().drones() + ", refused " + proxy.refusedCount() + ", broken "
                        + proxy.brokenCount());
    }
}
