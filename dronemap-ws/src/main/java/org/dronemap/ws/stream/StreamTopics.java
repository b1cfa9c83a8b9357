package org.dronemap.ws.stream;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.dronemap.cognitive.operation.follow.FollowState;
import org.dronemap.cognitive.operation.run.RunState;
import org.dronemap.core.access.Permission;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.conduct.Operations.Snapshot;
import org.dronemap.core.conduct.VirtualDroneListener;
import org.dronemap.core.conduct.VirtualDrones;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.virtual.VirtualDrone;
import org.dronemap.core.zone.Zone;
import org.dronemap.core.zone.ZoneRegistry;
import org.dronemap.ws.command.CommandView;
import org.dronemap.ws.drone.ControlView;
import org.dronemap.ws.drone.DroneViewMapper;
import org.dronemap.ws.follow.FollowService;
import org.dronemap.ws.plan.PlanJob;
import org.dronemap.ws.plan.PlanJobExecutor;
import org.dronemap.ws.plan.PlanListener;
import org.dronemap.ws.plan.PlanService;
import org.dronemap.ws.plan.PlanViewMapper;
import org.dronemap.ws.run.RunService;
import org.dronemap.ws.run.RunViewMapper;
import org.dronemap.ws.stream.delivery.CloudEventRouter;
import org.dronemap.ws.stream.delivery.MessageSubject;
import org.dronemap.ws.stream.delivery.TopicSink;
import org.dronemap.ws.virtual.VirtualDroneService;
import org.dronemap.ws.virtual.VirtualDroneViewMapper;
import org.dronemap.ws.zone.ZoneFeature;
import org.dronemap.ws.zone.ZoneService;
import org.jspecify.annotations.Nullable;

/** Defines the stream topics of drones, commands, control, zones, virtual drones, plans, mission runs and follows. */
final class StreamTopics {
    private static final TopicRate.EveryChange EVERY_CHANGE = new TopicRate.EveryChange();
    private static final TopicRate.Newest FOUR_A_SECOND = new TopicRate.Newest(4);
    private static final TopicRate.Newest TWICE_A_SECOND = new TopicRate.Newest(2);

    /** Those to whom a drone that they see looks alike. */
    private record DroneSight(Role role, Set<Permission> permissions) {}

    private StreamTopics() {}

    /** In the order in which a client that has come in is told of them; at last of those of use cases. */
    static List<Topic<?>> all(
            CloudManager cloud, CloudEventRouter news, StreamFace.ViewServices pictures, List<Topic<?>> ofUseCases) {
        List<Topic<?>> all = new ArrayList<>(ofCloud(cloud, news, pictures));
        all.addAll(ofUseCases);
        return List.copyOf(all);
    }

    private static List<Topic<?>> ofCloud(CloudManager cloud, CloudEventRouter news, StreamFace.ViewServices pictures) {
        return List.of(
                zones(cloud.zones()),
                virtualDrones(pictures.virtuals(), pictures.virtualViews(), news),
                plans(pictures.plans()),
                runs(pictures.runs()),
                follows(pictures.follows()),
                followsNow(pictures.follows(), news),
                commands(news),
                controls(news),
                drones(cloud, pictures.drones(), news));
    }

    /** What somebody sees of a drone is the same as long as this is. Null: nothing. */
    static @Nullable Object sightOf(Principal who, DroneId drone) {
        Set<Permission> permissions = who.permissions(drone);
        return permissions.isEmpty() ? null : new DroneSight(who.role(), permissions);
    }

    private static Topic<DroneState> drones(CloudManager cloud, DroneViewMapper views, CloudEventRouter news) {
        return new Topic<>(
                StreamMessage.Drone.class,
                new TopicRate.NewestAsAsked(),
                new Topic.SubjectMapping<>(
                        MessageSubject.DRONE, drone -> drone.id().value()),
                new Topic.Audience<>("whoever sees the drone", (who, drone) -> sightOf(who, drone.id())),
                (drone, who) -> new StreamMessage.Drone(views.view(drone, who)),
                cloud::drones,
                new Topic.Removal(StreamMessage.DroneRemoved.class, StreamMessage.DroneRemoved::new),
                feed -> {
                    news.onChange(drone -> feed.changed(drone.id().value(), () -> Optional.of(drone)));
                    news.onRemoval(id -> feed.removed(id.value()));
                });
    }

    private static Topic<Zone> zones(ZoneRegistry book) {
        return new Topic<>(
                StreamMessage.ZoneChanged.class,
                EVERY_CHANGE,
                new Topic.SubjectMapping<>("zone", Zone::id),
                new Topic.Audience<>(
                        "the organisation that it is of, without those who do not see the drone that it is for; a global one"
                                + " everybody",
                        (who, zone) -> ZoneService.isShownTo(who, zone) ? who.organisation() : null),
                (zone, who) -> new StreamMessage.ZoneChanged(ZoneFeature.of(zone, who.organisation())),
                List::of,
                new Topic.Removal(StreamMessage.ZoneRemoved.class, StreamMessage.ZoneRemoved::new),
                feed -> book.onChange(change -> publish(feed, change)));
    }

    /** Former forms go together with the new ones. */
    private static void publish(TopicSink<Zone> feed, ZoneRegistry.Change change) {
        Map<String, Zone> put = new LinkedHashMap<>();
        change.put().forEach(zone -> put.put(zone.id(), zone));
        change.former().forEach(former -> feed.publish(former, put.remove(former.id())));
        put.values().forEach(feed::publish);
    }

    private static Topic<VirtualDrone> virtualDrones(
            VirtualDrones virtuals, VirtualDroneViewMapper views, CloudEventRouter news) {
        return new Topic<>(
                StreamMessage.VirtualDroneChanged.class,
                TWICE_A_SECOND,
                new Topic.SubjectMapping<>("virtualDrone", drone -> drone.id().value()),
                new Topic.Audience<>(
                        "whose it is, and supervisors of the organisation",
                        (who, drone) -> VirtualDroneService.isShownTo(who, drone) ? who : null),
                (drone, who) -> new StreamMessage.VirtualDroneChanged(views.view(drone, who)),
                virtuals::all,
                new Topic.Removal(StreamMessage.VirtualDroneRemoved.class, StreamMessage.VirtualDroneRemoved::new),
                feed -> {
                    virtuals.addListener(new VirtualDroneUpdates(virtuals, feed));
                    news.onMoves(drones -> virtuals.all().stream()
                            .filter(drone -> drone.boundTo() != null && drones.contains(drone.boundTo()))
                            .forEach(drone -> feed.changed(drone.id().value(), () -> virtuals.find(drone.id()))));
                });
    }

    /** Its missions go on: that is told at once. */
    private record VirtualDroneUpdates(VirtualDrones virtuals, TopicSink<VirtualDrone> feed)
            implements VirtualDroneListener {
        @Override
        public void changed(VirtualDrone drone) {
            publish(drone);
            if (drone.isWaiting() || !drone.isUnderWay()) {
                // Those behind it in the queue may have moved up.
                virtuals.all().stream().filter(VirtualDrone::isWaiting).forEach(this::publish);
            }
        }

        private void publish(VirtualDrone drone) {
            feed.changedAtOnce(drone.id().value(), () -> virtuals.find(drone.id()));
        }

        @Override
        public void removed(VirtualDrone drone) {
            feed.removed(drone.id().value());
        }
    }

    private static Topic<PlanJob> plans(PlanJobExecutor desk) {
        return new Topic<>(
                StreamMessage.PlanChanged.class,
                FOUR_A_SECOND,
                new Topic.SubjectMapping<>("plan", PlanJob::id),
                Topic.Audience.of("whoever asked for it, and sees all of its drones", PlanService::isShownTo),
                (job, who) -> new StreamMessage.PlanChanged(PlanViewMapper.whole(job)),
                desk::everybodys,
                new Topic.Removal(StreamMessage.PlanRemoved.class, StreamMessage.PlanRemoved::new),
                feed -> desk.addListener(new PlanUpdates(desk, feed)));
    }

    private record PlanUpdates(PlanJobExecutor desk, TopicSink<PlanJob> feed) implements PlanListener {
        @Override
        public void changed(PlanJob job) {
            feed.changed(job.id(), () -> desk.find(job.id()));
        }

        @Override
        public void removed(PlanJob job) {
            feed.removed(job.id());
        }
    }

    private static Topic<Snapshot<RunState>> runs(RunService runs) {
        return new Topic<>(
                StreamMessage.RunChanged.class,
                FOUR_A_SECOND,
                new Topic.SubjectMapping<>("run", run -> run.saved().id().value()),
                Topic.Audience.of("the organisation, whoever sees all drones of the run", RunService::isShownTo),
                (run, who) -> new StreamMessage.RunChanged(RunViewMapper.view(run)),
                runs::underWay,
                null,
                feed -> runs.addListener(
                        (operation, why) -> feed.changed(operation.id().value(), () -> runs.picture(operation))));
    }

    private static Topic<Snapshot<FollowState>> follows(FollowService follows) {
        return new Topic<>(
                StreamMessage.FollowChanged.class,
                FOUR_A_SECOND,
                new Topic.SubjectMapping<>(
                        "follow", follow -> follow.saved().id().value()),
                Topic.Audience.of("the organisation, whoever sees the drone", FollowService::isShownTo),
                (follow, who) -> new StreamMessage.FollowChanged(follows.view(follow)),
                follows::underWay,
                null,
                feed -> follows.addListener(
                        (operation, why) -> feed.changed(operation.id().value(), () -> follows.picture(operation))));
    }

    private static Topic<Snapshot<FollowState>> followsNow(FollowService follows, CloudEventRouter news) {
        return new Topic<>(
                StreamMessage.FollowNow.class,
                FOUR_A_SECOND,
                new Topic.SubjectMapping<>(
                        "followNow", follow -> follow.saved().id().value()),
                Topic.Audience.of("the organisation, whoever sees the drone", FollowService::isShownTo),
                (follow, who) -> new StreamMessage.FollowNow(
                        follow.saved().id().value(), follows.view(follow).now()),
                List::of,
                null,
                feed -> news.onMoves(drones -> follows.underWay().stream()
                        .filter(follow -> drones.contains(follow.state().drone()))
                        .forEach(follow -> feed.changed(follow.saved().id().value(), () -> Optional.of(follow)))));
    }

    private static Topic<CommandRecord> commands(CloudEventRouter news) {
        return new Topic<>(
                StreamMessage.Command.class,
                EVERY_CHANGE,
                new Topic.SubjectMapping<>(
                        MessageSubject.DRONE, command -> command.drone().value()),
                Topic.Audience.of("whoever sees the drone", (who, command) -> who.sees(command.drone())),
                (command, who) -> new StreamMessage.Command(CommandView.of(command)),
                List::of,
                null,
                feed -> news.onCommand(feed::publish));
    }

    private static Topic<CloudEventRouter.ControlEvent> controls(CloudEventRouter news) {
        return new Topic<>(
                StreamMessage.Control.class,
                EVERY_CHANGE,
                new Topic.SubjectMapping<>(
                        MessageSubject.DRONE, told -> told.drone().value()),
                Topic.Audience.of("whoever sees the drone", (who, told) -> who.sees(told.drone())),
                (told, who) -> new StreamMessage.Control(
                        told.drone().value(), ControlView.of(told.now()), ControlView.ChangeView.of(told.change())),
                List::of,
                null,
                feed -> news.onControl(feed::publish));
    }
}
