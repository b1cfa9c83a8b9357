package org.dronemap.ws.stream;

import java.util.List;
import java.util.Set;
import org.dronemap.cognitive.operation.follow.FollowState;
import org.dronemap.cognitive.operation.run.RunState;
import org.dronemap.core.access.Permission;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.conduct.Operations.Picture;
import org.dronemap.core.conduct.VirtualDrones;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.lease.Control;
import org.dronemap.core.lease.ControlChange;
import org.dronemap.core.virtual.VirtualDrone;
import org.dronemap.core.zone.Zone;
import org.dronemap.ws.service.CommandView;
import org.dronemap.ws.service.ControlView;
import org.dronemap.ws.service.DroneViews;
import org.dronemap.ws.service.FollowService;
import org.dronemap.ws.service.PlanDesk;
import org.dronemap.ws.service.PlanJob;
import org.dronemap.ws.service.PlanService;
import org.dronemap.ws.service.PlanViews;
import org.dronemap.ws.service.RunService;
import org.dronemap.ws.service.RunViews;
import org.dronemap.ws.service.VirtualDroneService;
import org.dronemap.ws.service.VirtualDroneViews;
import org.dronemap.ws.service.ZoneFeature;
import org.dronemap.ws.service.ZoneService;
import org.jspecify.annotations.Nullable;

/** All topics of the stream: a new one is declared here, and {@link StreamNews} says when its things change. */
final class Topics {
    private static final Rate.EveryChange EVERY_CHANGE = new Rate.EveryChange();
    private static final Rate.Newest FOUR_A_SECOND = new Rate.Newest(4);
    private static final Rate.Newest TWICE_A_SECOND = new Rate.Newest(2);

    /** Those to whom a drone that they see looks alike. */
    private record DroneSight(Role role, Set<Permission> permissions) {}

    /** What has happened to who has a drone. */
    record ControlNews(DroneId drone, Control now, ControlChange change) {}

    private Topics() {}

    /** What somebody sees of a drone is the same as long as this is. Null: nothing. */
    static @Nullable Object sightOf(Principal who, DroneId drone) {
        Set<Permission> permissions = who.permissions(drone);
        return permissions.isEmpty() ? null : new DroneSight(who.role(), permissions);
    }

    static Topic<DroneState> drones(CloudManager cloud, DroneViews views) {
        return new Topic<>(
                StreamMessage.Drone.class,
                new Rate.NewestAsAsked(),
                drone -> Subject.drone(drone.id()),
                new Topic.Audience<>("whoever sees the drone", (who, drone) -> sightOf(who, drone.id())),
                (drone, who) -> new StreamMessage.Drone(views.view(drone, who)),
                cloud::drones,
                new Topic.Removal(StreamMessage.DroneRemoved.class, StreamMessage.DroneRemoved::new));
    }

    static Topic<Zone> zones() {
        return new Topic<>(
                StreamMessage.ZoneChanged.class,
                EVERY_CHANGE,
                Subject::zone,
                new Topic.Audience<>(
                        "the organisation that it is of, without those who do not see the drone that it is for; a global one"
                                + " everybody",
                        (who, zone) -> ZoneService.isShownTo(who, zone) ? who.organisation() : null),
                (zone, who) -> new StreamMessage.ZoneChanged(ZoneFeature.of(zone, who.organisation())),
                List::of,
                new Topic.Removal(StreamMessage.ZoneRemoved.class, StreamMessage.ZoneRemoved::new));
    }

    static Topic<VirtualDrone> virtualDrones(VirtualDrones virtuals, VirtualDroneViews views) {
        return new Topic<>(
                StreamMessage.VirtualDroneChanged.class,
                TWICE_A_SECOND,
                Subject::virtualDrone,
                new Topic.Audience<>(
                        "whose it is, and supervisors of the organisation",
                        (who, drone) -> VirtualDroneService.isShownTo(who, drone) ? who : null),
                (drone, who) -> new StreamMessage.VirtualDroneChanged(views.view(drone, who)),
                virtuals::all,
                new Topic.Removal(StreamMessage.VirtualDroneRemoved.class, StreamMessage.VirtualDroneRemoved::new));
    }

    static Topic<PlanJob> plans(PlanDesk desk) {
        return new Topic<>(
                StreamMessage.PlanChanged.class,
                FOUR_A_SECOND,
                Subject::plan,
                Topic.Audience.of("whoever asked for it, and sees all of its drones", PlanService::isShownTo),
                (job, who) -> new StreamMessage.PlanChanged(PlanViews.whole(job)),
                desk::everybodys,
                new Topic.Removal(StreamMessage.PlanRemoved.class, StreamMessage.PlanRemoved::new));
    }

    static Topic<Picture<RunState>> runs(RunService runs) {
        return new Topic<>(
                StreamMessage.RunChanged.class,
                FOUR_A_SECOND,
                run -> Subject.run(run.saved()),
                Topic.Audience.of("the organisation, whoever sees all drones of the run", RunService::isShownTo),
                (run, who) -> new StreamMessage.RunChanged(RunViews.view(run)),
                runs::underWay,
                null);
    }

    static Topic<Picture<FollowState>> follows(FollowService follows) {
        return new Topic<>(
                StreamMessage.FollowChanged.class,
                FOUR_A_SECOND,
                follow -> Subject.follow(follow.saved()),
                Topic.Audience.of("the organisation, whoever sees the drone", FollowService::isShownTo),
                (follow, who) -> new StreamMessage.FollowChanged(follows.view(follow)),
                follows::underWay,
                null);
    }

    static Topic<Picture<FollowState>> followsNow(FollowService follows) {
        return new Topic<>(
                StreamMessage.FollowNow.class,
                FOUR_A_SECOND,
                follow -> Subject.followNow(follow.saved()),
                Topic.Audience.of("the organisation, whoever sees the drone", FollowService::isShownTo),
                (follow, who) -> new StreamMessage.FollowNow(
                        follow.saved().id().value(), follows.view(follow).now()),
                List::of,
                null);
    }

    static Topic<CommandRecord> commands() {
        return new Topic<>(
                StreamMessage.Command.class,
                EVERY_CHANGE,
                command -> Subject.drone(command.drone()),
                Topic.Audience.of("whoever sees the drone", (who, command) -> who.sees(command.drone())),
                (command, who) -> new StreamMessage.Command(CommandView.of(command)),
                List::of,
                null);
    }

    static Topic<ControlNews> controls() {
        return new Topic<>(
                StreamMessage.Control.class,
                EVERY_CHANGE,
                news -> Subject.drone(news.drone()),
                Topic.Audience.of("whoever sees the drone", (who, news) -> who.sees(news.drone())),
                (news, who) -> new StreamMessage.Control(
                        news.drone().value(), ControlView.of(news.now()), ControlView.ChangeView.of(news.change())),
                List::of,
                null);
    }
}
