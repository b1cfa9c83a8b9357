package org.dronemap.ws.service;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.dronemap.cognitive.operation.follow.FollowOrder;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.command.Command;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Home;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.Spot;
import org.dronemap.core.lease.Control;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.FenceZone;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.core.virtual.Demand;
import org.dronemap.core.virtual.Needs;
import org.dronemap.core.virtual.Selection;
import org.dronemap.core.virtual.Share;
import org.dronemap.core.virtual.Tour;
import org.dronemap.core.zone.Zone;

/** Finds the drone that follows a phone, by the same reckoning as for virtual drones, and what binds it. */
final class FollowDrones {
    private static final Duration AHEAD = Duration.ofHours(1);
    private static final int CORNERS = 36;
    private static final double SECONDS = 60;
    private static final Needs NEEDS =
            new Needs(null, Set.of(Capability.TAKE_OFF, Capability.TRACK, Capability.RETURN_TO_LAUNCH), null, null);

    private final CloudManager cloud;

    FollowDrones(CloudManager cloud) {
        this.cloud = cloud;
    }

    /** What it has to do: come, stay for so many minutes, go home. */
    record Task(Geodetic near, FollowOrder.Place place, double minutes) {
        private Demand demand() {
            Altitude height = new Altitude(place.heightMeters(), Altitude.Reference.HOME);
            MissionItem.Waypoint there = new MissionItem.Waypoint(near, height, minutes * SECONDS);
            return new Demand(NEEDS, new Tour(place.heightMeters(), List.of(there), false), 0);
        }
    }

    /** Among these; a conflict with why each cannot when none can. */
    FollowOrder.Chosen choose(Principal principal, List<DroneState> drones, Task task) {
        Selection selection = Selection.of(task.demand(), drones, (drone, share) -> objection(principal, drone, share));
        Function<DroneId, String> names = id -> drones.stream()
                .filter(drone -> drone.id().equals(id))
                .map(DroneState::name)
                .findFirst()
                .orElse(id.value());
        return selection
                .choice()
                .map(choice -> chosen(choice.chosen(), choice.sentence(names)))
                .orElseThrow(() -> Rejection.conflict(
                        drones.isEmpty()
                                ? "No drone of the warehouse is yours to command; name one that you look after."
                                : "No drone can follow now. "
                                        + selection.unfit().stream()
                                                .map(one -> names.apply(one.drone()) + ": " + one.why())
                                                .collect(Collectors.joining(" "))));
    }

    private FollowOrder.Chosen chosen(DroneId id, String why) {
        DroneState drone = cloud.drone(id).orElseThrow(() -> Rejection.unknown("drone", id.value()));
        Home home = drone.home();
        if (home == null) {
            throw Rejection.conflict("Where the home of " + drone.name() + " is, is not known any more.");
        }
        return new FollowOrder.Chosen(id, drone.name(), home.point(), home.altitudeAmslMeters(), why);
    }

    private Optional<String> objection(Principal principal, DroneState drone, Share share) {
        Control control = cloud.controls().control(drone.id());
        if (control.tenure() != null && !control.isHeldBy(principal.name())) {
            return Optional.of(control.sentence());
        }
        // Whether zones let it go there and back.
        return cloud.gate().whyNot(principal, drone, new Command.UploadMission(share.mission()));
    }

    List<DroneState> commandable(Principal principal) {
        return cloud.drones().stream()
                .filter(drone -> principal.sees(drone.id()) && principal.may(Role.OPERATOR, drone.id()))
                .toList();
    }

    /** The zones that bind it now or soon, at whatever height. */
    FollowOrder.Fences fences(String user, DroneId drone, Instant now) {
        List<FollowOrder.Area> stayIn = new ArrayList<>();
        List<FollowOrder.Area> keepOut = new ArrayList<>();
        for (Zone zone : cloud.zones().binding(user, drone, now, now.plus(AHEAD))) {
            (zone.shape().inside() ? stayIn : keepOut).add(new FollowOrder.Area(corners(zone.shape())));
        }
        return new FollowOrder.Fences(stayIn, keepOut);
    }

    /** Of a circle within which it stays the area is a little smaller, of one that it keeps out of a little larger. */
    private static List<Geodetic> corners(FenceZone shape) {
        if (shape instanceof FenceZone.Polygon polygon) {
            return polygon.corners();
        }
        FenceZone.Circle circle = (FenceZone.Circle) shape;
        double radius = circle.inside() ? circle.radiusMeters() : circle.radiusMeters() / Math.cos(Math.PI / CORNERS);
        LocalPlane plane = new LocalPlane(circle.center());
        List<Geodetic> corners = new ArrayList<>();
        for (int corner = 0; corner < CORNERS; corner++) {
            double angle = 2 * Math.PI * corner / CORNERS;
            corners.add(plane.place(new Spot(radius * Math.sin(angle), radius * Math.cos(angle))));
        }
        return corners;
    }
}
