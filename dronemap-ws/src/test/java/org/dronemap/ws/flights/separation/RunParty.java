package org.dronemap.ws.flights.separation;

import java.util.List;
import org.dronemap.core.access.Role;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.MissionRunFlight;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.plan.PlanRequest;
import org.dronemap.ws.plan.PlanView;
import org.dronemap.ws.wiring.SteppedServer;
import org.jspecify.annotations.Nullable;

/**
 * A mission run of a user of its own.
 *
 * @param stoppedAfter seconds after which its user calls all of it home; null: it is flown to its end
 */
record RunParty(
        String name,
        List<Spot> pads,
        List<Spot> waypoints,
        String onCloudLoss,
        @Nullable Double stoppedAfter) implements Party {
    static RunParty whole(String name, List<Spot> pads, List<Spot> waypoints, String onCloudLoss) {
        return new RunParty(name, pads, waypoints, onCloudLoss, null);
    }

    @Override
    public boolean isFlownToItsEnd() {
        return stoppedAfter == null;
    }

    @Override
    public Flight prepared(Laboratory lab) {
        List<LabDrone> drones = Vehicles.put(lab, pads);
        Pilot pilot = lab.pilot(name.replace(' ', '-'), Role.SUPERVISOR);
        List<PlanRequest.WaypointRequest> wanted = waypoints.stream()
                .map(spot -> MissionRunFlight.waypoint(spot.place(), spot.amsl()))
                .toList();
        return new RunFlown(lab, pilot, drones, wanted, MissionRunFlight.planned(lab, pilot, drones, wanted));
    }

    private final class RunFlown implements Flight {
        private final Laboratory lab;
        private final Pilot pilot;
        private final List<LabDrone> drones;
        private final List<PlanRequest.WaypointRequest> wanted;
        private final PlanView plan;
        private final SteppedServer planner;
        private @Nullable MissionRunFlight run;
        private long begunNanos;
        private boolean stopped;

        RunFlown(
                Laboratory lab,
                Pilot pilot,
                List<LabDrone> drones,
                List<PlanRequest.WaypointRequest> wanted,
                PlanView plan) {
            this.lab = lab;
            this.pilot = pilot;
            this.drones = drones;
            this.wanted = wanted;
            this.plan = plan;
            this.planner = lab.server();
        }

        @Override
        public List<LabDrone> drones() {
            return drones;
        }

        @Override
        public void begin() {
            begunNanos = lab.time().nanos();
            MissionRunFlight.Manner manner = new MissionRunFlight.Manner("automatic", onCloudLoss, null);
            // A server does not know the plans of the one before it.
            run = lab.server() == planner
                    ? MissionRunFlight.begins(lab, pilot, drones, plan, manner)
                    : MissionRunFlight.begins(lab, pilot, drones, wanted, manner);
        }

        @Override
        public void step() {
            MissionRunFlight flown = run;
            double seconds = (lab.time().nanos() - begunNanos) / 1e9;
            if (flown != null && stoppedAfter != null && !stopped && seconds >= stoppedAfter) {
                stopped = true;
                var unused = lab.server().runs().stop(pilot.principal(), flown.id());
            }
        }

        @Override
        public boolean isOver() {
            return run != null && run.view().state().equals("over");
        }
    }
}
