package org.dronemap.ws.soap;

import java.util.List;
import org.dronemap.ws.service.VirtualDroneRequest;
import org.dronemap.ws.service.VirtualDroneService;
import org.jspecify.annotations.Nullable;

/** Virtual drones over SOAP. Any thread. */
public final class SoapVirtualDrones {
    private final SoapCaller caller;
    private final VirtualDroneService virtuals;

    public SoapVirtualDrones(SoapCaller caller, VirtualDroneService virtuals) {
        this.caller = caller;
        this.virtuals = virtuals;
    }

    /** What is to be made, as a caller wrote it. */
    record Wish(
            @Nullable String name,
            @Nullable String kind,
            @Nullable Integer enduranceMinutes,
            @Nullable List<String> needs,
            @Nullable List<SoapWaypoint> waypoints) {
        private VirtualDroneRequest request() {
            return new VirtualDroneRequest(
                    name,
                    new VirtualDroneRequest.NeedsView(
                            kind, needs == null ? null : List.copyOf(needs), enduranceMinutes, null),
                    waypoints == null
                            ? null
                            : waypoints.stream().map(SoapWaypoint::view).toList());
        }
    }

    List<SoapVirtualDrone> all() {
        return virtuals.all(caller.reading()).stream().map(SoapVirtualDrone::of).toList();
    }

    SoapVirtualDrone one(String id) {
        return SoapVirtualDrone.of(virtuals.one(caller.reading(), id));
    }

    SoapVirtualDrone make(Wish wish) {
        return SoapVirtualDrone.of(virtuals.add(caller.reading(), wish.request()));
    }

    SoapVirtualDrone start(String id, @Nullable String onCloudLoss) {
        return SoapVirtualDrone.of(
                virtuals.start(caller.reading(), id, new VirtualDroneRequest.StartRequest(onCloudLoss)));
    }

    /** Brings a drone home, and so is never made to wait. */
    SoapVirtualDrone stop(String id) {
        return SoapVirtualDrone.of(virtuals.stop(caller.principal(), id));
    }

    SoapVirtualDrone resume(String id) {
        return SoapVirtualDrone.of(virtuals.resume(caller.reading(), id));
    }

    void remove(String id) {
        virtuals.remove(caller.reading(), id);
    }
}
