package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.dronemap.core.access.Role;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.mission.MissionItemRequest;
import org.dronemap.ws.virtual.VirtualDroneRequest;
import org.dronemap.ws.virtual.VirtualDroneView;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Missions of virtual drones on fewer drones, over a crash of the server and one of a drone. */
class VirtualDroneFlightTest {
    private static final int MISSIONS = 5;
    private static final long AUTO = 3;
    private static final long LOITER = 5;
    private static final long RTL = 6;
    private static final double WATCH_SECONDS = 600;
    private static final Set<String> BOUND = Set.of("uploading", "arming", "starting", "flying", "returning");

    private final Laboratory lab = new Laboratory(1);
    private final List<LabDrone> drones = lab.copters(2);
    private final Pilot chief = lab.pilot("chief", Role.SUPERVISOR);

    @AfterEach
    void close() {
        lab.close();
    }

    /** Each mission has a height and a size of its own, by which its waypoints are told from those of the others. */
    private List<Geodetic> places(int number) {
        double side = 25 + number * 8;
        LabDrone first = drones.get(0);
        return List.of(first.place(-side, 0), first.place(-side, -side), first.place(0, -side));
    }

    private static double height(int number) {
        return 18 + 5 * number;
    }

    private String planned(int number) {
        List<MissionItem> items = new ArrayList<>();
        places(number)
                .forEach(place -> items.add(new MissionItem.Waypoint(place, Altitude.aboveHome(height(number)), 0)));
        return lab.server()
                .virtuals()
                .add(
                        chief.principal(),
                        new VirtualDroneRequest("Survey " + number, null, MissionItemRequest.of(items), null))
                .id();
    }

    private VirtualDroneView.RunView run(String virtual) {
        return Objects.requireNonNull(
                lab.server().virtuals().one(chief.principal(), virtual).run());
    }

    /** The drones that came within 3 m of a place, at its height, by their numbers. */
    private List<Integer> passed(Geodetic place, double height) {
        return IntStream.range(0, drones.size())
                .filter(n -> drones.get(n).track().since(0).stream()
                        .anyMatch(fix -> Math.abs(fix.height() - height) < 2.5
                                && Geodesy.distanceMeters(fix.place(), place) < 3))
                .boxed()
                .toList();
    }

    @Test
    void fiveMissionsOnTwoDronesAreFlownOverCrashesOfServerAndDrone() {
        List<String> virtuals =
                IntStream.range(0, MISSIONS).mapToObj(this::planned).toList();
        virtuals.forEach(one -> lab.server().virtuals().start(chief.principal(), one, null));
        assertThat(virtuals).allMatch(one -> run(one).state().equals("queued"));
        assertThat(run(virtuals.get(MISSIONS - 1)).queue())
                .isEqualTo(new VirtualDroneView.PlaceView(MISSIONS, MISSIONS));
        drones.forEach(drone ->
                lab.server().warehouse().put(chief.principal(), drone.id().value()));

        // Who asked first flies first, and is told why by this drone.
        lab.untilSeen(
                "the first two fly",
                Duration.ofMinutes(2),
                () -> virtuals.subList(0, 2).stream()
                        .allMatch(one -> run(one).state().equals("flying")));
        assertThat(run(virtuals.get(0)).why()).contains("was chosen", "the runner-up");
        assertThat(run(virtuals.get(2)).state()).isEqualTo("queued");
        assertThat(run(virtuals.get(2)).queue()).isEqualTo(new VirtualDroneView.PlaceView(1, MISSIONS - 2));
        assertThat(virtuals.subList(0, 2)).allMatch(one -> BOUND.contains(run(one).state()));

        lab.crashServer();
        lab.goOn(Duration.ofSeconds(3));
        lab.startServer();
        LabDrone fallen = comesDownInFlight(virtuals);

        lab.untilSeen(
                "all are done",
                Duration.ofMinutes(20),
                () -> virtuals.stream().allMatch(one -> run(one).state().equals("done")));
        for (int number = 0; number < MISSIONS; number++) {
            for (Geodetic place : places(number)) {
                assertThat(passed(place, height(number)))
                        .as("mission " + number)
                        .hasSize(1);
            }
        }
        assertThat(fallen.craft().crashed()).isTrue();
        assertThat(firstPassedInOrder()).isTrue();
    }

    /** A moment after its mission was brought to it: that it was explains no mode for sticks. */
    @Test
    void aDroneThatItsPilotTakesIsNeitherCalledHomeNorToldAnything() {
        LabDrone taken = drones.get(0);
        lab.server().warehouse().put(chief.principal(), taken.id().value());
        String virtual = waitingFor(WATCH_SECONDS);
        lab.server().virtuals().start(chief.principal(), virtual, new VirtualDroneRequest.StartRequest("rtl"));
        lab.untilSeen("its mission begins", Duration.ofMinutes(3), () -> taken.mode() == AUTO);
        OrderCapture socket = new OrderCapture();
        taken.wire().capturedBy(socket);

        taken.switchedTo(LOITER);
        lab.untilSeen(
                "the mission waits for its user",
                Duration.ofSeconds(10),
                () -> run(virtual).state().equals("suspended"));
        lab.goOn(Duration.ofSeconds(15));

        assertThat(taken.mode()).isEqualTo(LOITER);
        assertThat(socket.ordersAfter(0)).isEmpty();
    }

    /** Its fail-safe is off, and its mission lasts: nobody but the server brings it home. */
    @Test
    void aDroneThatFellSilentIsCalledHomeByTheServerThatFollows() {
        LabDrone silent = drones.get(0);
        lab.server().warehouse().put(chief.principal(), silent.id().value());
        String virtual = waitingFor(WATCH_SECONDS);
        lab.server().virtuals().start(chief.principal(), virtual, new VirtualDroneRequest.StartRequest("rtl"));
        lab.untilSeen(
                "it flies", Duration.ofMinutes(3), () -> run(virtual).state().equals("flying"));
        silent.vehicle().autopilot().parameters().set("FS_GCS_ENABLE", 0);
        silent.wire().cut();
        lab.untilSeen(
                "it is given up", Duration.ofMinutes(10), () -> run(virtual).drone() == null);

        lab.crashServer();
        lab.startServer();
        silent.wire().mend();

        lab.untilSeen("it is called home", Duration.ofSeconds(30), () -> silent.mode() == RTL);
        lab.until("it is down", Duration.ofMinutes(3), silent::isDown);
    }

    private String waitingFor(double seconds) {
        MissionItem there = new MissionItem.Waypoint(drones.get(0).place(0, 20), Altitude.aboveHome(20), seconds);
        return lab.server()
                .virtuals()
                .add(
                        chief.principal(),
                        new VirtualDroneRequest("Watch", null, MissionItemRequest.of(List.of(there)), null))
                .id();
    }

    /** One of the later missions loses its drone when it is half flown: another drone flies the rest. */
    private LabDrone comesDownInFlight(List<String> virtuals) {
        List<String> later = virtuals.subList(2, MISSIONS);
        String half = lab.until(
                "a later mission is half flown",
                Duration.ofMinutes(4),
                () -> later.stream()
                        .filter(one -> run(one).state().equals("flying") && run(one).flown() == 1)
                        .findFirst());
        String bound = Objects.requireNonNull(run(half).drone()).id();
        LabDrone fallen = drones.stream()
                .filter(drone -> drone.id().value().equals(bound))
                .findFirst()
                .orElseThrow();
        fallen.craft().crash();
        lab.untilSeen(
                "it waits for another drone",
                Duration.ofSeconds(60),
                () -> Stream.ofNullable(run(half).drone())
                        .noneMatch(drone -> drone.id().equals(bound)));
        assertThat(run(half).flown()).isLessThan(run(half).total());
        lab.untilSeen(
                "it is done", Duration.ofMinutes(10), () -> run(half).state().equals("done"));
        int number = virtuals.indexOf(half);
        List<Geodetic> places = places(number);
        assertThat(passed(places.get(0), height(number))).isNotEqualTo(passed(places.get(2), height(number)));
        return fallen;
    }

    /** Whoever asked first was flown first. */
    private boolean firstPassedInOrder() {
        List<Long> begun = IntStream.range(0, MISSIONS)
                .mapToObj(n -> drones.stream()
                        .flatMap(drone -> drone.track().since(0).stream())
                        .filter(fix -> Math.abs(fix.height() - height(n)) < 2.5
                                && Geodesy.distanceMeters(fix.place(), places(n).get(0)) < 3)
                        .mapToLong(fix -> fix.atNanos())
                        .min()
                        .orElseThrow())
                .toList();
        return begun.get(0) < begun.get(2) && begun.get(1) < begun.get(2) && begun.get(2) < begun.get(4);
    }
}
