package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import org.dronemap.core.access.Role;
import org.dronemap.core.time.Worker;
import org.dronemap.ws.control.SteeringRequest;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.MemoryLinkRobot;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.organisation.GrantService;
import org.dronemap.ws.problem.Rejection;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** When who steered has gone, or may no more, a robot that repeats its last speeds stands within a second. */
class SteeringStopsTest {
    private static final int TIMES = 5;
    private static final Duration MOST = Duration.ofSeconds(1);
    private static final Duration RHYTHM = Duration.ofMillis(100);
    private static final double TENTH_LOST = 0.1;
    private static final SteeringRequest FORWARD =
            new SteeringRequest(new SteeringRequest.Velocity(null, 0.4, null, null, null, null), null, null);

    enum End {
        PAGE_KILLED,
        NETWORK_CUT,
        LEASE_TAKEN,
        GRANT_REVOKED
    }

    /** Steers as the page does, ten times a second, until its hands are taken off. */
    private static final class SteeringClient {
        private final Laboratory lab;
        private final Pilot pilot;
        private final String drone;
        private boolean on;

        SteeringClient(Laboratory lab, Pilot pilot, String drone) {
            this.lab = lab;
            this.pilot = pilot;
            this.drone = drone;
            Worker hands = lab.time().worker("hands", 1);
            var unused = hands.every(RHYTHM, RHYTHM, this::steer);
        }

        private void steer() {
            if (!on) {
                return;
            }
            try {
                lab.server().steering().steer(pilot.principal(), "stream", drone, FORWARD);
            } catch (Rejection mayNoMore) {
                letGo();
            }
        }

        void grasp() {
            on = true;
        }

        /** As the stream does for a connection that has broken. */
        void letGo() {
            on = false;
            lab.server().steering().letGo(pilot.principal(), "stream", drone);
        }

        void cut() {
            on = false;
        }
    }

    @ParameterizedTest
    @EnumSource(End.class)
    void itStandsWithinASecond(End end) {
        try (Laboratory lab = new Laboratory(1)) {
            MemoryLinkRobot robot = lab.robot();
            robot.loses(TENTH_LOST);
            Pilot root = lab.pilot("root", Role.ADMINISTRATOR);
            Pilot chief = lab.pilot("chief", Role.SUPERVISOR);
            Pilot pilot = lab.pilot("ann", Role.OPERATOR);
            lab.until(
                    "the robot is listed",
                    Duration.ofSeconds(10),
                    () -> robot.known()
                            .filter(state -> state.capabilities().known())
                            .isPresent());
            lab.server()
                    .accounts()
                    .grants()
                    .setUserOnlyGranted(root.principal(), "ann", new GrantService.OnlyGrantedRequest(true));
            grant(lab, root, robot);
            SteeringClient helm = new SteeringClient(lab, pilot, robot.id());
            for (int time = 0; time < TIMES; time++) {
                helm.grasp();
                lab.until("it moves", Duration.ofSeconds(10), () -> robot.speed() > 0.3);
                comes(end, lab, helm, chief, root);
                lab.until("it stands", MOST, () -> robot.speed() == 0);
                lab.throughout("it stands", Duration.ofSeconds(3), () -> robot.speed() == 0);
                helm.cut();
                recovers(end, lab, robot, chief, root);
            }
        }
    }

    private static void comes(End end, Laboratory lab, SteeringClient helm, Pilot chief, Pilot root) {
        switch (end) {
            case PAGE_KILLED -> helm.letGo();
            case NETWORK_CUT -> helm.cut();
            case LEASE_TAKEN -> chief.takesOver(helm.drone, "a child on the floor");
            case GRANT_REVOKED ->
                lab.server()
                        .accounts()
                        .grants()
                        .grants(root.principal())
                        .forEach(grant -> lab.server().accounts().grants().revoke(root.principal(), grant.id()));
        }
    }

    private static void recovers(End end, Laboratory lab, MemoryLinkRobot robot, Pilot chief, Pilot root) {
        if (end == End.LEASE_TAKEN) {
            chief.releases(robot.id());
        } else if (end == End.GRANT_REVOKED) {
            grant(lab, root, robot);
        }
        assertThat(chief.control(robot.id()).holder()).isIn("ann", null);
    }

    private static void grant(Laboratory lab, Pilot root, MemoryLinkRobot robot) {
        GrantService.GrantRequest wanted = new GrantService.GrantRequest(
                "ann", null, null, null, List.of(robot.id()), null, List.of("view", "command"), null, null);
        assertThat(lab.server()
                        .accounts()
                        .grants()
                        .add(root.principal(), wanted)
                        .state())
                .isEqualTo("inForce");
    }
}
