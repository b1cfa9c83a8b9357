package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Objects;
import org.dronemap.core.access.Role;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.lab.VehicleSpec;
import org.dronemap.ws.lab.WingedSpecs;
import org.dronemap.ws.mission.MissionItemRequest;
import org.dronemap.ws.virtual.VirtualDroneRequest;
import org.dronemap.ws.virtual.VirtualDroneView;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** A mission of a virtual drone ends in the own way of the kind of vehicle that flies it. */
class VirtualDroneKindsTest {
    private static final Duration FLIGHT = Duration.ofMinutes(6);
    private static final Duration DRIVE = Duration.ofMinutes(3);

    private final Laboratory lab = new Laboratory(1);
    private final Pilot chief = lab.pilot("chief", Role.SUPERVISOR);

    @AfterEach
    void close() {
        lab.close();
    }

    /** Asked for, with that drone in the warehouse. */
    private String begun(LabDrone drone, double north, double meters) {
        MissionItem there = new MissionItem.Waypoint(drone.place(north, 0), Altitude.aboveHome(meters), 0);
        String id = lab.server()
                .virtuals()
                .add(
                        chief.principal(),
                        new VirtualDroneRequest("Watch", null, MissionItemRequest.of(List.of(there)), null))
                .id();
        lab.server().warehouse().put(chief.principal(), drone.id().value());
        lab.server().virtuals().start(chief.principal(), id, null);
        return id;
    }

    private VirtualDroneView.RunView run(String virtual) {
        return Objects.requireNonNull(
                lab.server().virtuals().one(chief.principal(), virtual).run());
    }

    private void reaches(String virtual, String state, Duration within) {
        lab.untilSeen(state, within, () -> run(virtual).state().equals(state));
    }

    @Test
    void aRoverIsDoneWhenItStandsAtHomeAndIsDisarmedThere() {
        LabDrone rover = lab.ready(lab.add(VehicleSpec.ROVER));
        String virtual = begun(rover, 40, 0);

        reaches(virtual, "done", DRIVE);

        assertThat(run(virtual).sentence()).isEqualTo("Done: all waypoints are flown and the drone is back.");
        assertThat(rover.away()).isLessThan(5);
        assertThat(rover.craft().armed()).isFalse();
    }

    @Test
    void aRoverThatIsStoppedComesHomeFirst() {
        LabDrone rover = lab.ready(lab.add(VehicleSpec.ROVER));
        String virtual = begun(rover, 80, 0);
        lab.until("it is under way", DRIVE, () -> rover.away() > 20);

        lab.server().virtuals().stop(chief.principal(), virtual);
        reaches(virtual, "stopped", DRIVE);

        assertThat(rover.away()).isLessThan(5);
        assertThat(rover.craft().armed()).isFalse();
    }

    @Test
    void aPlaneTakesOffAndIsDoneWhenItCirclesOverItsHome() {
        LabDrone plane = lab.ready(lab.add(WingedSpecs.PLANE));
        String virtual = begun(plane, 600, 80);

        reaches(virtual, "done", FLIGHT);

        assertThat(run(virtual).sentence())
                .isEqualTo(
                        "Done: all waypoints are flown. The drone circles over its home, since no mission of a virtual"
                                + " drone lands it. Nobody controls it now: take control of it and land it.");
        assertThat(plane.away()).isLessThan(250);
        assertThat(plane.height()).isGreaterThan(30);
    }

    @Test
    void aPlaneThatIsStoppedIsFreeWhenItCirclesOverItsHome() {
        LabDrone plane = lab.ready(lab.add(WingedSpecs.PLANE));
        String virtual = begun(plane, 1_500, 80);
        lab.until("it is under way", FLIGHT, () -> plane.away() > 500);

        lab.server().virtuals().stop(chief.principal(), virtual);
        reaches(virtual, "stopped", FLIGHT);

        assertThat(run(virtual).sentence()).contains("circles over its home");
        assertThat(plane.away()).isLessThan(250);
    }

    /** Its own return circles at home unless it is told otherwise; it lands on its rotors. */
    @Test
    void aQuadPlaneLandsAtHome() {
        LabDrone plane = lab.ready(lab.add(WingedSpecs.QUADPLANE));
        String virtual = begun(plane, 600, 60);

        reaches(virtual, "done", Duration.ofMinutes(10));

        assertThat(run(virtual).sentence()).isEqualTo("Done: all waypoints are flown and the drone is back.");
        assertThat(plane.away()).isLessThan(30);
        assertThat(plane.craft().armed()).isFalse();
    }
}
