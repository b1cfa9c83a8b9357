package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import org.dronemap.core.access.Role;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.ws.control.ControlRequest;
import org.dronemap.ws.control.SteeringRequest;
import org.dronemap.ws.follow.FollowRequest.PlaceRequest;
import org.dronemap.ws.lab.Administrator;
import org.dronemap.ws.lab.CommandRequests;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.MissionRunFlight;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.lab.SimulatedPhone;
import org.dronemap.ws.mission.MissionItemRequest;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.virtual.VirtualDroneRequest;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Whatever a drone is at, and whatever becomes of whoever has it, at a moment that chance chooses: it comes down by itself, and
 * one that somebody else took over gets not a byte that orders something. Judged by what the vehicles truly do, and by the
 * bytes at their sockets.
 */
class RandomMomentsTest {
    /** With {@code -Ddronemap.moments=20} there are two hundred moments. */
    private static final long FLIGHTS = Long.getLong("dronemap.moments", 4);

    private static final int DRONES = 10;
    private static final long GUIDED = 4;
    private static final long ALT_HOLD = 2;
    private static final long LOITER = 5;
    private static final long AUTO = 3;
    private static final long LAND = 9;
    private static final Set<Long> HOMEWARD = Set.of(6L, LAND, 21L);
    private static final double HEIGHT = 15;
    private static final Duration RHYTHM = Duration.ofMillis(100);
    /** 30 s without a command, 30 s until it is called back, some for each step. */
    private static final Duration UNTIL_HOMEWARD = Duration.ofSeconds(75);

    private static final Duration UNTIL_DOWN = Duration.ofMinutes(8);
    /** What it was told so shortly before may have put it into any mode. */
    private static final Duration EFFECT = Duration.ofSeconds(5);

    private static final Duration SEEN = Duration.ofSeconds(1);

    enum Kind {
        GUIDED,
        VELOCITY,
        STICKS,
        MISSION,
        RUN,
        FOLLOW,
        VIRTUAL
    }

    private static final Set<Kind> OPERATIONS = Set.of(Kind.RUN, Kind.FOLLOW, Kind.VIRTUAL);

    enum End {
        VANISHES,
        HANDS_OVER,
        MAY_NO_MORE,
        GIVES_BACK,
        IS_STOPPED_BY_A_SUPERVISOR,
        PILOT_TAKES_IT,
        STATION_TAKES_IT
    }

    enum Fate {
        NOTHING,
        KILLED,
        STANDS_STILL
    }

    static LongStream seeds() {
        return LongStream.rangeClosed(1, FLIGHTS);
    }

    /** One drone with whoever flies it. */
    private final class Flight {
        private final Laboratory lab;
        private final LabDrone drone;
        private final Pilot pilot;
        private final Kind kind;
        private final End end;
        private final OrderCapture socket = new OrderCapture();
        private boolean steers;
        private @Nullable SimulatedPhone phone;
        private long endedNanos;
        private boolean taken;
        /** It may have been an order that put it into that mode, for all that the server can know. */
        private boolean ambiguous;

        private long takenMode;
        /** When one that was taken was down; 0: it flies on. */
        private long downNanos;

        Flight(Laboratory lab, LabDrone drone, Kind kind, End end) {
            this.lab = lab;
            this.drone = drone;
            this.kind = kind;
            this.end = end;
            this.pilot = lab.pilot("pilot-" + drone.name().replace(' ', '-'), Role.OPERATOR);
            drone.wire().capturedBy(socket);
            var unused = lab.time().worker("hands of " + pilot.name(), 1).every(RHYTHM, RHYTHM, this::steer);
        }

        private void steer() {
            long since = lab.time().nanos() - endedNanos;
            if (taken && since > SEEN.toNanos() && since < 2 * SEEN.toNanos() && drone.mode() != takenMode) {
                // What was under way to it at that very moment has undone it.
                taken = false;
            }
            if (downNanos == 0 && taken && drone.isDown()) {
                downNanos = lab.time().nanos();
            }
            if (!steers || !lab.isUp()) {
                return;
            }
            SteeringRequest forward = kind == Kind.STICKS
                    ? new SteeringRequest(null, new SteeringRequest.Sticks(0.3, null, null, null), null)
                    : new SteeringRequest(new SteeringRequest.Velocity(null, 0.5, null, null, null, null), null, null);
            try {
                lab.server()
                        .steering()
                        .steer(pilot.principal(), "stream", drone.id().value(), forward);
            } catch (Rejection notNow) {
                // Whoever steers by hand goes on and on.
            }
        }

        void begins(Pilot chief) {
            switch (kind) {
                case GUIDED -> {
                    pilot.takesOff(drone, HEIGHT);
                    pilot.fliesTo(drone, drone.place(40, 0), HEIGHT);
                }
                case VELOCITY -> {
                    pilot.takesOff(drone, HEIGHT);
                    lab.until("it is up", Duration.ofSeconds(40), () -> drone.height() > HEIGHT - 1);
                    steers = true;
                }
                case STICKS -> {
                    pilot.takesOff(drone, HEIGHT);
                    lab.until("it is up", Duration.ofSeconds(40), () -> drone.height() > HEIGHT - 1);
                    pilot.does(drone, CommandRequests.setMode("LOITER"));
                    steers = true;
                }
                case MISSION -> {
                    pilot.plans(drone, HEIGHT, drone.place(30, 0), drone.place(60, 0));
                    pilot.does(drone, CommandRequests.setMode("GUIDED"));
                    pilot.does(drone, CommandRequests.arm());
                    pilot.does(drone, CommandRequests.startMission("continue"));
                }
                case RUN -> beginsRun();
                case FOLLOW -> {
                    phone = lab.phone(pilot, drone, 20, 0);
                    phone.asks(drone, new PlaceRequest("fixed", 180.0, null, 5.0, HEIGHT), 30)
                            .starts();
                }
                case VIRTUAL -> beginsVirtual(chief);
            }
        }

        private void beginsRun() {
            var unused = MissionRunFlight.begins(
                    lab,
                    pilot,
                    List.of(drone),
                    List.of(
                            MissionRunFlight.waypoint(drone.place(30, 0), drone.groundAmsl() + 20),
                            MissionRunFlight.waypoint(drone.place(60, 0), drone.groundAmsl() + 20)),
                    MissionRunFlight.Manner.ON);
        }

        private void beginsVirtual(Pilot chief) {
            List<MissionItem> items = List.of(
                    new MissionItem.Waypoint(drone.place(30, 0), Altitude.aboveHome(HEIGHT), 0),
                    new MissionItem.Waypoint(drone.place(60, 0), Altitude.aboveHome(HEIGHT), 0));
            VirtualDroneRequest asked =
                    new VirtualDroneRequest("V " + drone.name(), null, MissionItemRequest.of(items), null);
            String made = lab.server().virtuals().add(pilot.principal(), asked).id();
            lab.server().virtuals().start(pilot.principal(), made, null);
            lab.server().warehouse().put(chief.principal(), drone.id().value());
        }

        void ends(Administrator root, Pilot chief) {
            endedNanos = lab.time().nanos();
            String id = drone.id().value();
            switch (end) {
                case VANISHES -> vanishes();
                case HANDS_OVER -> {
                    vanishes();
                    tries(() -> {
                        pilot.takesControl(drone);
                        pilot.controls(id, new ControlRequest.HandOver(chief.name()));
                    });
                }
                case MAY_NO_MORE -> root.disables(pilot);
                case GIVES_BACK -> {
                    vanishes();
                    tries(() -> pilot.releases(id));
                }
                case IS_STOPPED_BY_A_SUPERVISOR -> {
                    vanishes();
                    tries(() -> chief.does(drone, CommandRequests.hold()));
                }
                case PILOT_TAKES_IT -> isTakenInto(drone.mode() == LOITER ? ALT_HOLD : LOITER);
                case STATION_TAKES_IT -> isTakenInto(drone.mode() == GUIDED ? LOITER : GUIDED);
            }
        }

        /** Whoever is not in the air yet, or on its way down, is nobody's flight. */
        private void isTakenInto(long mode) {
            vanishes();
            if (drone.height() > 2 && !HOMEWARD.contains(drone.mode())) {
                long effect = lab.time().nanos() - EFFECT.toNanos();
                ambiguous = !socket.ordersAfter(effect).isEmpty();
                drone.switchedTo(mode);
                taken = true;
                takenMode = mode;
            }
        }

        /** It may have landed by then, or belong to an operation. */
        private void tries(Runnable what) {
            try {
                what.run();
            } catch (Rejection | AssertionError notNow) {
                // Then it has just vanished.
            }
        }

        void vanishes() {
            steers = false;
            if (phone != null) {
                phone.isSilent();
            }
        }

        boolean isTaken() {
            return taken;
        }

        /** Operations have a time of their own. */
        boolean isLookedAfter() {
            return OPERATIONS.contains(kind)
                    || drone.isDown()
                    || HOMEWARD.contains(drone.mode())
                    || drone.mode() == AUTO;
        }

        String words() {
            return kind + ", " + end + ": " + drone.words();
        }
    }

    @ParameterizedTest
    @MethodSource("seeds")
    void nobodyIsLeftInTheAir(long seed) {
        SplittableRandom chance = new SplittableRandom(seed * 7_919);
        Fate fate = Fate.values()[(int) (seed % Fate.values().length)];
        try (Laboratory lab = new Laboratory(seed)) {
            Administrator root = lab.administrator();
            Pilot chief = lab.pilot("chief", Role.SUPERVISOR);
            List<Flight> flights = begun(lab, chief, chance);
            List<Flight> left = new ArrayList<>(flights);
            int crash = chance.nextInt(DRONES);
            for (int moment = 0; moment < DRONES; moment++) {
                lab.goOn(Duration.ofMillis(chance.nextLong(200, 4_000)));
                if (moment == crash) {
                    befalls(lab, fate);
                }
                left.remove(chance.nextInt(left.size())).ends(root, chief);
            }
            flights.forEach(Flight::vanishes);
            lab.goOn(UNTIL_HOMEWARD);
            judge(lab, flights, "seed " + seed + ", " + fate);
        }
    }

    private List<Flight> begun(Laboratory lab, Pilot chief, SplittableRandom chance) {
        List<LabDrone> drones = lab.copters(DRONES);
        List<Flight> flights = IntStream.range(0, DRONES)
                .mapToObj(number -> new Flight(
                        lab,
                        drones.get(number),
                        Kind.values()[chance.nextInt(Kind.values().length)],
                        End.values()[chance.nextInt(End.values().length)]))
                .toList();
        flights.forEach(flight -> flight.begins(chief));
        return flights;
    }

    private static void befalls(Laboratory lab, Fate fate) {
        switch (fate) {
            case NOTHING -> {}
            case KILLED -> {
                lab.crashServer();
                lab.goOn(Duration.ofSeconds(8));
                lab.startServer();
                lab.goOn(Duration.ofSeconds(3));
            }
            case STANDS_STILL -> lab.stopServer(Duration.ofSeconds(20));
        }
    }

    private static void judge(Laboratory lab, List<Flight> flights, String where) {
        List<Flight> taken = flights.stream()
                .filter(flight -> flight.isTaken() && !flight.ambiguous)
                .toList();
        List<Flight> others =
                flights.stream().filter(flight -> !flight.isTaken()).toList();
        assertThat(others)
                .as(where + ": somebody's, or on the way home")
                .allSatisfy(flight ->
                        assertThat(flight.isLookedAfter()).as(flight.words()).isTrue());
        lab.untilSeen(
                where + ": all are down", UNTIL_DOWN, () -> others.stream().allMatch(flight -> flight.drone.isDown()));
        for (Flight flight : taken) {
            long seen = flight.endedNanos + SEEN.toNanos();
            assertThat(flight.socket.ordersAfter(seen))
                    .as(where + ": " + flight.words())
                    .allMatch(order -> flight.downNanos > 0 && order.nanos() > flight.downNanos);
            assertThat(flight.socket.lastHeartbeatNanos())
                    .as(where + ": heartbeats go on")
                    .isGreaterThan(lab.time().nanos() - Duration.ofSeconds(3).toNanos());
        }
    }
}
