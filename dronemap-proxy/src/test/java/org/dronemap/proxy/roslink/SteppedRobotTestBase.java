package org.dronemap.proxy.roslink;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.Future;
import java.util.function.BooleanSupplier;
import java.util.function.Predicate;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.CommandGate;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.command.Refusal;
import org.dronemap.core.command.Setpoint;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.time.SteppedTime;
import org.dronemap.proxy.TestCloud;
import org.dronemap.proxy.endpoint.DtlsKeys;
import org.dronemap.proxy.endpoint.EndpointSecurity;
import org.dronemap.proxy.record.TextMessageTap;
import org.dronemap.proxy.session.Enrolment;
import org.dronemap.proxy.session.FrameTap;
import org.junit.jupiter.api.AfterEach;
import tools.jackson.databind.JsonNode;

/** A cloud with links to robots in stepped time, and what tests ask of it: also that a robot is told nothing for a while. */
abstract class SteppedRobotTestBase {
    static final int TURTLEBOT = 8;
    static final int QUADROTOR = 3;
    static final Duration PATIENCE = Duration.ofSeconds(15);
    /** Longer than until a robot that is told to stand is told so again. */
    static final Duration QUIET = Duration.ofMillis(700);

    static final String STANDS = "\"vx\":0,\"vy\":0,\"vz\":0,\"wz\":0";

    private static final CommandGate.Source PILOT =
            new CommandGate.Source(new Principal("pilot", Role.OPERATOR), "stream");
    private static final Duration AN_ORDER = Duration.ofSeconds(5);
    private static final Duration BETWEEN_REPORTS = Duration.ofMillis(100);
    private static final int PORTS_OF_ONE = 10;

    final SteppedTime time = new SteppedTime(Instant.parse("2026-03-04T05:06:07Z"));
    final TestCloud house = new TestCloud(componentId -> FrameTap.NONE, time);
    final RoslinkConnector proxy = new RoslinkConnector(
            house.cloud(),
            house.lanes(),
            List.of(),
            new RoslinkConnector.Policy(
                    new TestRobotKeys(),
                    () -> TextMessageTap.NONE,
                    EndpointSecurity.of(DtlsKeys.none()),
                    Enrolment.LOOPBACK),
            time);
    private int port = 15_000;

    @AfterEach
    void stop() {
        proxy.close();
        house.close();
        assertThat(time.failures()).isEmpty();
    }

    /** {@code key} as it stands in JSON. */
    SteppedRobot robot(int systemId, String key) {
        port += PORTS_OF_ONE;
        return new SteppedRobot(proxy.handlers(), time, port, systemId, key);
    }

    /** Begins it. */
    Future<CommandRecord> command(DroneState drone, Command command) {
        CommandId id = new CommandId(UUID.randomUUID().toString());
        house.cloud().gate().submit(PILOT, drone.id(), id, command);
        return house.cloud().gate().end(id);
    }

    Optional<String> steer(DroneState drone, Setpoint setpoint) {
        return house.cloud().setpoints().steer(PILOT, drone.id(), setpoint).map(Refusal::sentence);
    }

    /** The next order of that kind, which has to come. */
    static JsonNode asked(SteppedRobot robot, int order) {
        return Objects.requireNonNull(robot.order(order, AN_ORDER));
    }

    /** The next twist that is no stop. */
    static JsonNode moving(SteppedRobot robot) {
        while (true) {
            JsonNode twist = asked(robot, 100);
            if (twist.path("vx").asDouble() != 0) {
                return twist;
            }
        }
    }

    DroneState awaitDrone(int systemId, Predicate<DroneState> wanted) {
        await(
                () -> house.cloud().drones().stream()
                        .filter(drone -> drone.link().key().systemId() == systemId)
                        .anyMatch(wanted),
                () -> {});
        return house.drone(systemId);
    }

    /** Goes on reporting until something holds. */
    void await(BooleanSupplier wanted, Runnable report) {
        TestCloud.await(
                time,
                PATIENCE,
                () -> {
                    report.run();
                    time.advance(BETWEEN_REPORTS);
                    return wanted.getAsBoolean();
                },
                () -> "not there: " + house.cloud().drones() + ", refused " + proxy.refusedCount());
    }

    /** It has called in by datagrams, stands, and is told nothing any more. */
    DroneState still(SteppedRobot robot, int systemId) {
        awaitReport(robot, systemId);
        await(() -> robot.order(100, QUIET) == null, () -> robot.say(2, "\"x\":0,\"y\":0," + STANDS));
        return house.drone(systemId);
    }

    private void awaitReport(SteppedRobot robot, int systemId) {
        await(
                () -> house.cloud().drones().stream()
                        .anyMatch(drone -> drone.link().key().systemId() == systemId && drone.local() != null),
                () -> {
                    robot.say(0, "\"type\":" + TURTLEBOT);
                    robot.say(2, "\"x\":0,\"y\":0," + STANDS);
                });
    }
}
