package org.dronemap.ws.flights.separation;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.dronemap.core.access.Role;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.mission.MissionItemRequest;
import org.dronemap.ws.virtual.VirtualDroneRequest;
import org.dronemap.ws.virtual.VirtualDroneView;

/** The mission of a virtual drone, for which the warehouse gets one drone as it begins. */
record VirtualParty(String name, Spot pad, List<Spot> waypoints, String onCloudLoss) implements Party {
    @Override
    public List<Spot> pads() {
        return List.of(pad);
    }

    @Override
    public Flight prepared(Laboratory lab) {
        LabDrone drone = Vehicles.put(lab, pad);
        Pilot owner = lab.pilot(name.replace(' ', '-'), Role.SUPERVISOR);
        List<MissionItem> items = waypoints.stream()
                .<MissionItem>map(
                        spot -> new MissionItem.Waypoint(spot.place(), Altitude.aboveHome(spot.up() - pad.up()), 0))
                .toList();
        String virtual = lab.server()
                .virtuals()
                .add(owner.principal(), new VirtualDroneRequest(name, null, MissionItemRequest.of(items), null))
                .id();
        return new Flight() {
            private boolean begun;

            @Override
            public List<LabDrone> drones() {
                return List.of(drone);
            }

            @Override
            public void begin() {
                lab.server().warehouse().put(owner.principal(), drone.id().value());
                var unused = lab.server()
                        .virtuals()
                        .start(owner.principal(), virtual, new VirtualDroneRequest.StartRequest(onCloudLoss));
                begun = true;
            }

            @Override
            public boolean isOver() {
                return begun
                        && Optional.ofNullable(lab.server()
                                        .virtuals()
                                        .one(owner.principal(), virtual)
                                        .run())
                                .map(VirtualDroneView.RunView::state)
                                .filter(state -> Objects.equals(state, "done"))
                                .isPresent();
            }
        };
    }
}
