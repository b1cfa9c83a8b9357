package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.stream.IntStream;
import org.dronemap.core.access.Role;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.core.process.ActivePeers;
import org.dronemap.core.process.PeerCrashGuard;
import org.dronemap.core.process.ProcessCrash;
import org.dronemap.core.process.ProcessStart;
import org.dronemap.core.process.SafeMode;
import org.dronemap.ws.follow.FollowRequest;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.MissionRunFlight;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.lab.SimulatedPhone;
import org.dronemap.ws.mission.MissionItemRequest;
import org.dronemap.ws.plan.PlanRequest;
import org.dronemap.ws.virtual.VirtualDroneRequest;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** A start after three ends within two minutes: what was conducted is set aside, and whoever is in the air comes home. */
class CarefulStartFlightTest {
    private static final long RTL = 6;
    private static final Duration SOON = Duration.ofSeconds(20);

    private final Laboratory lab = new Laboratory(1);
    private final Pilot chief = lab.pilot("chief", Role.SUPERVISOR);
    private final List<LabDrone> drones = lab.copters(4);

    @AfterEach
    void close() {
        lab.close();
    }

    /** As after three ends within two minutes. */
    private ProcessStart careful() {
        ProcessCrash end = new ProcessCrash(lab.now(), "lane-0", "It ended with ThreadDeath.", List.of());
        SafeMode precautions = new SafeMode(List.of(end, end, end), Set.of());
        return new ProcessStart(end, new PeerCrashGuard(ActivePeers.UNKNOWN, precautions));
    }

    private MissionRunFlight runs(LabDrone one, LabDrone other) {
        List<PlanRequest.WaypointRequest> waypoints = IntStream.range(0, 8)
                .mapToObj(n ->
                        MissionRunFlight.waypoint(one.place((1 + n % 4) * 40, (n / 4) * 40), one.groundAmsl() + 20))
                .toList();
        return MissionRunFlight.begins(lab, chief, List.of(one, other), waypoints, MissionRunFlight.Manner.ON)
                .awaitsAll("flying");
    }

    private SimulatedPhone follows(LabDrone drone) {
        SimulatedPhone phone = lab.phone(lab.pilot("ann", Role.OPERATOR), drone, 40, 0);
        phone.asks(drone, new FollowRequest.PlaceRequest("fixed", 180.0, null, 15.0, 25.0), 600)
                .starts();
        phone.awaits("tracking", Duration.ofMinutes(2));
        return phone;
    }

    private String virtual(LabDrone drone) {
        List<MissionItem> items = IntStream.range(1, 5)
                .<MissionItem>mapToObj(
                        n -> new MissionItem.Waypoint(drone.place(-40 * n, -60), Altitude.aboveHome(30), 0))
                .toList();
        String id = lab.server()
                .virtuals()
                .add(chief.principal(), new VirtualDroneRequest("Survey", null, MissionItemRequest.of(items), null))
                .id();
        lab.server().virtuals().start(chief.principal(), id, null);
        lab.server().warehouse().put(chief.principal(), drone.id().value());
        lab.untilSeen("it flies", Duration.ofMinutes(2), () -> state(id).equals("flying"));
        return id;
    }

    private String state(String virtual) {
        return Objects.requireNonNull(
                        lab.server().virtuals().one(chief.principal(), virtual).run())
                .state();
    }

    @Test
    void allThatWasConductedIsSetAsideAndAllComeHome() {
        MissionRunFlight run = runs(drones.get(0), drones.get(1));
        SimulatedPhone phone = follows(drones.get(2));
        String virtual = virtual(drones.get(3));

        lab.crashServer();
        lab.goOn(Duration.ofSeconds(3));
        lab.startServer(careful());

        assertThat(state(virtual)).isEqualTo("suspended");
        lab.until(
                "all are on their way home",
                SOON,
                () -> drones.stream().allMatch(drone -> drone.mode() == RTL || drone.isDown()));
        lab.until("all are down", Duration.ofMinutes(3), () -> drones.stream().allMatch(LabDrone::isDown));
        assertThat(drones).allMatch(drone -> drone.away() < 3);
        lab.untilSeen("the run is over", SOON, () -> run.view().state().equals("over"));
        assertThat(run.view().end()).contains("set it aside");
        assertThat(phone.view().state()).isEqualTo("over");
        assertThat(phone.view().end()).contains("set it aside");
        assertThat(run.decidesTheSameAgain()).isTrue();
        assertThat(state(virtual)).isEqualTo("suspended");
    }
}
