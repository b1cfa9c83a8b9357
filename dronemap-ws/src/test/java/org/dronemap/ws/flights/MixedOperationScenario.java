package org.dronemap.ws.flights;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.dronemap.core.access.Role;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.ws.follow.FollowRequest;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.LabVehicleLink;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.MissionRunFlight;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.lab.SimulatedPhone;
import org.dronemap.ws.lab.VehicleSpec;
import org.dronemap.ws.mission.MissionItemRequest;
import org.dronemap.ws.plan.PlanRequest;
import org.dronemap.ws.run.RunView;
import org.dronemap.ws.virtual.VirtualDroneRequest;

/**
 * Ten minutes of everything at once over bad links: a mission run of three copters, a virtual drone, a phone that is followed,
 * a vehicle that falls silent, and a server that crashes. As a program it prints the sum of that, and what there was.
 */
final class MixedOperationScenario {
    private static final LabVehicleLink.Quality BAD =
            new LabVehicleLink.Quality(0.02, Duration.ofMillis(20), Duration.ofMillis(40));
    private static final Duration MINUTE = Duration.ofMinutes(1);
    private static final int WAYPOINTS = 60;
    private static final double SPACING_METERS = 45;
    private static final double HEIGHT_METERS = 25;

    private final Laboratory lab;
    private final List<LabDrone> fleet;
    private final LabDrone stock;
    private final LabDrone follower;
    private final Pilot chief;

    private MixedOperationScenario(Laboratory lab) {
        this.lab = lab;
        fleet = lab.copters(3);
        stock = lab.ready(lab.add(VehicleSpec.COPTER.inWind(4)));
        follower = lab.copter();
        chief = lab.pilot("chief", Role.SUPERVISOR);
        List<LabDrone> all = new ArrayList<>(fleet);
        all.addAll(List.of(stock, follower));
        all.forEach(drone -> drone.wire().is(BAD));
    }

    /** Prints the sum of the flight of that seed. */
    public static void main(String[] arguments) {
        System.out.println(sum(Long.parseLong(arguments[0])));
    }

    static String sum(long seed) {
        try (Laboratory lab = new Laboratory(seed)) {
            return new MixedOperationScenario(lab).fly();
        }
    }

    /** The sum of its first two minutes alone: who differs in those differs in all. */
    static String sumOfBeginning(long seed) {
        try (Laboratory lab = new Laboratory(seed)) {
            Begun unused = new MixedOperationScenario(lab).begin();
            return lab.sum();
        }
    }

    /** The run, the virtual drone and the phone of the first two minutes. */
    private record Begun(MissionRunFlight run, String virtual, SimulatedPhone phone) {}

    private Begun begin() {
        MissionRunFlight run = MissionRunFlight.begins(lab, chief, fleet, waypoints(), MissionRunFlight.Manner.ON);
        String virtual = virtual();
        SimulatedPhone phone = lab.phone(lab.pilot("walker", Role.OPERATOR), follower, 20, 0);
        phone.asks(follower, new FollowRequest.PlaceRequest("behind", null, null, 6.0, 12.0), 60)
                .starts();
        phone.walks(0, 1.4);
        lab.goOn(MINUTE.multipliedBy(2));
        return new Begun(run, virtual, phone);
    }

    private String fly() {
        Begun begun = begin();
        MissionRunFlight run = begun.run();
        SimulatedPhone phone = begun.phone();
        fleet.get(1).vehicle().silence(MINUTE.toMillis());
        lab.goOn(MINUTE.multipliedBy(2));
        lab.crashServer();
        lab.goOn(Duration.ofSeconds(3));
        lab.startServer();
        lab.goOn(MINUTE);
        phone.walks(-1, -0.5);
        lab.goOn(MINUTE.multipliedBy(2));
        phone.stops();
        lab.goOn(MINUTE.multipliedBy(3));
        List<String> triggers = run.view().explanations().stream()
                .map(RunView.ExplanationView::trigger)
                .toList();
        String end = run.view().counts() + ", " + triggers + ", " + phone.view().state() + ", "
                + lab.server()
                        .virtuals()
                        .one(chief.principal(), begun.virtual())
                        .run();
        return lab.sum() + " " + lab.frames() + " frames, " + end;
    }

    /** Ten by six, north of the fleet. */
    private List<PlanRequest.WaypointRequest> waypoints() {
        LabDrone first = fleet.get(0);
        return IntStream.range(0, WAYPOINTS)
                .mapToObj(n -> MissionRunFlight.waypoint(
                        first.place((1 + n % 10) * SPACING_METERS, n / 10 * SPACING_METERS),
                        first.groundAmsl() + HEIGHT_METERS))
                .toList();
    }

    private String virtual() {
        List<MissionItem> items = new ArrayList<>();
        for (int number = 1; number <= 10; number++) {
            items.add(new MissionItem.Waypoint(stock.place(-40.0 * number, 0), Altitude.aboveHome(40), 15));
        }
        lab.server().warehouse().put(chief.principal(), stock.id().value());
        String id = lab.server()
                .virtuals()
                .add(chief.principal(), new VirtualDroneRequest("Survey", null, MissionItemRequest.of(items), null))
                .id();
        return lab.server().virtuals().start(chief.principal(), id, null).id();
    }
}
