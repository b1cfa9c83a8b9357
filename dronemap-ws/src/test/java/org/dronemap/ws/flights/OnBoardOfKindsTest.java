package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.dronemap.core.access.Role;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.ws.fence.FenceService;
import org.dronemap.ws.fence.FenceView;
import org.dronemap.ws.lab.CommandRequests;
import org.dronemap.ws.lab.DirectGroundStation;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.lab.VehicleSpec;
import org.dronemap.ws.parameter.ParameterService;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The settings, places and areas that each kind of ArduPilot vehicle keeps for its owner. */
class OnBoardOfKindsTest {
    private static final int CIRCLE_INCLUSION = 5003;
    private static final int RALLY_POINT = 5100;

    @ParameterizedTest
    @MethodSource("org.dronemap.ws.lab.VehicleSpec#arduPilots")
    void keepsParametersFenceRallyPointsAndHome(VehicleSpec kind) {
        try (Laboratory lab = new Laboratory(1)) {
            Pilot ann = lab.pilot("ann", Role.OPERATOR);
            LabDrone drone = lab.ready(lab.add(kind));
            String id = drone.id().value();

            ann.does(drone, CommandRequests.readParameters());
            ann.succeeds(lab.server()
                    .parameters()
                    .set(ann.caller(), id, "FENCE_ACTION", new ParameterService.ValueRequest(0.0, null)));
            assertThat(drone.vehicle().autopilot().parameters().value("FENCE_ACTION"))
                    .isZero();

            FenceService fences = lab.server().fences();
            FenceView.FencePointView here = new FenceView.FencePointView(
                    drone.place(0, 0).latitudeDegrees(), drone.place(0, 0).longitudeDegrees());
            ann.succeeds(fences.setFence(
                    ann.caller(), id, new FenceView(List.of(new FenceView.CircleView(true, here, 200.0)), null, null)));
            ann.succeeds(fences.setRallyPoints(
                    ann.caller(),
                    id,
                    new FenceView.RallyView(
                            List.of(new FenceView.RallyPointView(47.3979, 8.5456, 20.0, "home")), List.of())));
            DirectGroundStation station = new DirectGroundStation(lab, drone);
            assertThat(station.mission(1)).extracting(MissionItemInt::command).containsExactly(CIRCLE_INCLUSION);
            assertThat(station.mission(2)).extracting(MissionItemInt::command).containsExactly(RALLY_POINT);

            ann.succeeds(lab.server().logs().refresh(ann.caller(), id));
            assertThat(lab.server().logs().logs(ann.principal(), id).logs()).isNotEmpty();

            ann.does(drone, CommandRequests.setHome(47.39771, 8.54561, 488.0));
            assertThat(drone.craft().home().latitude()).isBetween(47.397709, 47.397711);

            ann.does(drone, CommandRequests.takePicture()).does(drone, CommandRequests.setRelay(0, "on"));
            assertThat(drone.vehicle().autopilot().payload().words()).isEqualTo("pictures 1 relays on: 0");
        }
    }
}
