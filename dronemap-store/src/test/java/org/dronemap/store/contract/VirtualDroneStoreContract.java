package org.dronemap.store.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.MissionCloudLossPolicy;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.DroneRecord;
import org.dronemap.core.drone.Identification;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.Mission;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.core.organisation.OrganisationId;
import org.dronemap.core.virtual.DroneChoice;
import org.dronemap.core.virtual.DroneRequirements;
import org.dronemap.core.virtual.RequiredArea;
import org.dronemap.core.virtual.SelectionCriterion;
import org.dronemap.core.virtual.VirtualDrone;
import org.dronemap.core.virtual.VirtualDroneId;
import org.dronemap.core.virtual.VirtualDroneStore;
import org.dronemap.core.virtual.VirtualPlan;
import org.dronemap.core.virtual.VirtualRun;
import org.dronemap.core.virtual.VirtualRunAssignment;
import org.dronemap.core.virtual.VirtualRunOrder;
import org.dronemap.core.virtual.VirtualRunStage;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** What every {@link VirtualDroneStore} keeps to. */
public abstract class VirtualDroneStoreContract {
    private static final Instant THEN = Instant.parse("2026-03-04T05:06:07.123456Z");
    private static final DroneId COPTER = new DroneId("copter-1");
    private static final DroneId OTHER = new DroneId("copter-2");
    private static final Mission MISSION = new Mission(List.of(
            new MissionItem.TakeOff(12.5),
            new MissionItem.Waypoint(new Geodetic(47.1234567, 8.5), Altitude.aboveHome(20), 3),
            new MissionItem.ReturnToLaunch()));

    private VirtualDroneStore store;

    /** A store without virtual drones that knows the drones copter-1 and copter-2. */
    protected abstract VirtualDroneStore emptyStore(List<DroneRecord> drones);

    @BeforeEach
    void open() {
        store = emptyStore(List.of(record(COPTER), record(OTHER)));
    }

    private static DroneRecord record(DroneId id) {
        return new DroneRecord(
                id,
                "Copter",
                new DroneKey("127.0.0.1", 14601, 1),
                "udp",
                new Identification(VehicleKind.MULTICOPTER, "ArduPilot", "ArduCopter", "4.5.6", null),
                THEN);
    }

    @Test
    void isEmptyAtFirst() {
        assertThat(store.virtualDrones()).isEmpty();
        assertThat(store.warehouse()).isEmpty();
        assertThat(store.delete(new VirtualDroneId("v1"))).isFalse();
        assertThat(store.removeFromWarehouse(COPTER)).isFalse();
    }

    @Test
    void givesBackPlannedOnesAndThoseUnderWayAsTheyWere() {
        VirtualDrone planned = drone("v2", DroneRequirements.NONE, null);
        VirtualDrone demanding = drone(
                "v1",
                new DroneRequirements(
                        VehicleKind.FIXED_WING,
                        Set.of(Capability.TAKE_PICTURE, Capability.SET_RELAY),
                        25,
                        new RequiredArea(new Geodetic(-17, 179.9), 250.5)),
                run(VirtualRunStage.FLYING, assignment(COPTER)));
        VirtualDrone waiting = drone("v3", DroneRequirements.NONE, run(VirtualRunStage.QUEUED, null))
                .recalling(OTHER);

        store.save(planned);
        store.save(demanding);
        store.save(waiting);

        assertThat(store.virtualDrones()).containsExactly(demanding, planned, waiting);
    }

    @Test
    void replacesAndForgets() {
        VirtualDrone bound = drone("v1", DroneRequirements.NONE, run(VirtualRunStage.UPLOADING, assignment(COPTER)));
        store.save(bound);
        VirtualDrone done = bound.with(0, run(VirtualRunStage.DONE, null))
                .with("Renamed “x”", new VirtualPlan(DroneRequirements.NONE, MISSION, 8));
        store.save(done);

        assertThat(store.virtualDrones()).containsExactly(done);
        assertThat(store.delete(done.id())).isTrue();
        assertThat(store.virtualDrones()).isEmpty();
    }

    @Test
    void bindsNoDroneTwice() {
        VirtualDrone first = drone("v1", DroneRequirements.NONE, run(VirtualRunStage.FLYING, assignment(COPTER)));
        VirtualDrone second = drone("v2", DroneRequirements.NONE, run(VirtualRunStage.UPLOADING, assignment(COPTER)));
        store.save(first);

        assertThatThrownBy(() -> store.save(second)).isInstanceOf(RuntimeException.class);
        assertThat(store.virtualDrones()).containsExactly(first);

        store.save(first.with(0, run(VirtualRunStage.DONE, null)));
        store.save(second);
        assertThat(store.virtualDrones()).hasSize(2);
    }

    @Test
    void eachShareOfAMissionBindsADroneOfItsOwn() {
        VirtualRun waits = run(VirtualRunStage.QUEUED, null);
        VirtualDrone shared = drone("v1", DroneRequirements.NONE, waits)
                .with(List.of(run(VirtualRunStage.FLYING, assignment(COPTER)), waits));
        store.save(shared);
        VirtualDrone both = shared.with(1, run(VirtualRunStage.ARMING, assignment(OTHER)));
        store.save(both);
        assertThat(store.virtualDrones()).containsExactly(both);
        VirtualDrone second = drone("v2", DroneRequirements.NONE, run(VirtualRunStage.UPLOADING, assignment(OTHER)));
        assertThatThrownBy(() -> store.save(second)).isInstanceOf(RuntimeException.class);

        store.save(both.with(1, waits));
        store.save(second);
        assertThat(store.virtualDrones()).hasSize(2);
        assertThat(store.delete(second.id())).isTrue();
        store.save(both);
    }

    @Test
    void keepsWhichDronesMayServe() {
        store.addToWarehouse(COPTER);
        store.addToWarehouse(COPTER);
        store.addToWarehouse(OTHER);
        assertThat(store.warehouse()).containsExactlyInAnyOrder(COPTER, OTHER);

        assertThat(store.removeFromWarehouse(COPTER)).isTrue();
        assertThat(store.warehouse()).containsExactly(OTHER);
    }

    private static VirtualDrone drone(String id, DroneRequirements needs, @Nullable VirtualRun run) {
        return new VirtualDrone(
                new VirtualDroneId(id),
                "Survey",
                "ann",
                "#1",
                OrganisationId.HOME,
                new VirtualPlan(needs, run == null ? null : MISSION, 1),
                run == null ? List.of() : List.of(run),
                List.of(),
                THEN);
    }

    private static VirtualRun run(VirtualRunStage stage, @Nullable VirtualRunAssignment assignment) {
        return new VirtualRun(
                new VirtualRunOrder(7, MISSION, MissionCloudLossPolicy.RETURN_TO_LAUNCH, 3),
                1,
                stage,
                assignment,
                Map.of(OTHER, THEN.plusSeconds(600)),
                2,
                "It flies.",
                "PreArm: no",
                THEN);
    }

    private static VirtualRunAssignment assignment(DroneId drone) {
        DroneChoice choice = new DroneChoice(
                drone,
                OTHER,
                SelectionCriterion.LINK_LOSS,
                1,
                2.5,
                "some 3 %",
                List.of(new DroneChoice.Unfit(OTHER, "It is armed or in the air.")));
        return new VirtualRunAssignment(choice, 0, 12.5, new CommandId("command-1"), 1, THEN);
    }
}
