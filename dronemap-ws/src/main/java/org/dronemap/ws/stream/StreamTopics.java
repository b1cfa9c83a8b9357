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
import org.dronemap.ws.plan.PlanService;
import org.dronemap.ws.plan.PlanViewMapper;
import org.dronemap.ws.run.RunService;
import org.dronemap.ws.run.RunViewMapper;
import org.dronemap.ws.stream.delivery.StreamEventRouter;
import org.dronemap.ws.stream.delivery.StreamMessageSubject;
import org.dronemap.ws.stream.delivery.StreamTopicSink;
import org.dronemap.ws.virtual.VirtualDroneService;
import org.dronemap.ws.virtual.VirtualDroneViewMapper;
import org.dronemap.ws.zone.ZoneFeature;
import org.dronemap.ws.zone.ZoneService;
import org.jspecify.annotations.Nullable;

/** Defines the stream topics of drones, commands, control, zones, virtual drones, plans, mission runs and follows. */
final class StreamTopics {
    private static final StreamTopicRate.EveryChange EVERY_CHANGE = new StreamTopicRate.EveryChange();
    private static final StreamTopicRate.Newest FOUR_A_SECOND = new StreamTopicRate.Newest(4);
    private static final StreamTopicRate.Newest TWICE_A_SECOND = new StreamTopicRate.Newest(2);

    /** Those to whom a drone that they see looks alike. */
    private record DroneSight(Role role, Set<Permission> permissions) {}

    private StreamTopics() {}

    /** In the order in which a client that has come in is told of them; at last of those of use cases. */
    static List<StreamTopic<?>> all(
            CloudManager cloud,
            StreamEventRouter news,
            StreamFace.ViewServices pictures,
            List<StreamTopic<?>> ofUseCases) {
        List<StreamTopic<?>> all = new ArrayList<>(ofCloud(cloud, news, pictures));
        all.addAll(ofUseCases);
        return List.copyOf(all);
    }

    private static List<StreamTopic<?>> ofCloud(
            CloudManager cloud, StreamEventRouter news, StreamFace.ViewServices pictures) {
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

    private static StreamTopic<DroneState> drones(CloudManager cloud, DroneViewMapper views, StreamEventRouter news) {
        return new StreamTopic<>(
                StreamMessage.Drone.class,
                new StreamTopicRate.NewestAsAsked(),
                new StreamTopic.SubjectMapping<>(
                        StreamMessageSubject.DRONE, drone -> drone.id().value()),
                new StreamTopic.Audience<>("whoever sees the drone", (who, drone) -> sightOf(who, drone.id())),
                (drone, who) -> new StreamMessage.Drone(views.view(drone, who)),
                cloud::drones,
                new StreamTopic.Removal(StreamMessage.DroneRemoved.class, StreamMessage.DroneRemoved::new),
                feed -> {
                    news.onChange(drone -> feed.changed(drone.id().value(), () -> Optional.of(drone)));
                    news.onRemoval(id -> feed.removed(id.value()));
                });
    }

    private static StreamTopic<Zone> zones(ZoneRegistry book) {
        return new StreamTopic<>(
                StreamMessage.ZoneChanged.class,
                EVERY_CHANGE,
                new StreamTopic.SubjectMapping<>("zone", Zone::id),
                new StreamTopic.Audience<>(
                        "the organisation that it is of, without those who do not see the drone that it is for; a global one"
                                + " everybody",
                        (who, zone) -> ZoneService.isShownTo(who, zone) ? who.organisation() : null),
                (zone, who) -> new StreamMessage.ZoneChanged(ZoneFeature.of(zone, who.organisation())),
                List::of,
                new StreamTopic.Removal(StreamMessage.ZoneRemoved.class, StreamMessage.ZoneRemoved::new),
                feed -> book.onChange(change -> publish(feed, change)));
    }

    /** Former forms go together with the new ones. */
    private static void publish(StreamTopicSink<Zone> feed, ZoneRegistry.Change change) {
        Map<String, Zone> put = new LinkedHashMap<>();
        change.put().forEach(zone -> put.put(zone.id(), zone));
        change.former().forEach(former -> feed.publish(former, put.remove(former.id())));
        put.values().forEach(feed::publish);
    }

    private static StreamTopic<VirtualDrone> virtualDrones(
            VirtualDrones virtuals, VirtualDroneViewMapper views, StreamEventRouter news) {
        return new StreamTopic<>(
                StreamMessage.VirtualDroneChanged.class,
                TWICE_A_SECOND,
                new StreamTopic.SubjectMapping<>(
                        "virtualDrone", drone -> drone.id().value()),
                new StreamTopic.Audience<>(
                        "whose it is, and supervisors of the organisation",
                        (who, drone) -> VirtualDroneService.isShownTo(who, drone) ? who : null),
                (drone, who) -> new StreamMessage.VirtualDroneChanged(views.view(drone, who)),
                virtuals::all,
                new StreamTopic.Removal(
                        StreamMessage.VirtualDroneRemoved.class, StreamMessage.VirtualDroneRemoved::new),
                feed -> {
                    virtuals.addListener(new VirtualDroneUpdates(virtuals, feed));
                    news.onMoves(drones -> virtuals.all().stream()
                            .filter(drone -> drone.boundTo() != null && drones.contains(drone.boundTo()))
                            .forEach(drone -> feed.changed(drone.id().value(), () -> virtuals.find(drone.id()))));
                });
    }

    /** Its missions go on: that is told at once. */
    private record VirtualDroneUpdates(VirtualDrones virtuals, StreamTopicSink<VirtualDrone> feed)
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

    private static StreamTopic<PlanJob> plans(PlanJobExecutor desk) {
        return new StreamTopic<>(
                StreamMessage.PlanChanged.class,
                FOUR_A_SECOND,
                new StreamTopic.SubjectMapping<>("plan", PlanJob::id),
                StreamTopic.Audience.of("whoever asked for it, and sees all of its drones", PlanService::isShownTo),
                (job, who) -> new StreamMessage.PlanChanged(PlanViewMapper.whole(job)),
                desk::everybodys,
                new StreamTopic.Removal(StreamMessage.PlanRemoved.class, StreamMessage.PlanRemoved::new),
                feed -> desk.addListener(new PlanUpdates(desk, feed)));
    }

    private record PlanUpdates(PlanJobExecutor jobs, StreamTopicSink<PlanJob> feed)
            implements PlanJobExecutor.PlanListener {
        @Override
        public void changed(PlanJob job) {
            feed.changed(job.id(), () -> jobs.find(job.id()));
        }

        @Override
        public void removed(PlanJob job) {
            feed.removed(job.id());
        }
    }

    private static StreamTopic<Snapshot<RunState>> runs(RunService runs) {
        return new StreamTopic<>(
                StreamMessage.RunChanged.class,
                FOUR_A_SECOND,
                new StreamTopic.SubjectMapping<>("run", run -> run.saved().id().value()),
                StreamTopic.Audience.of("the organisation, whoever sees all drones of the run", RunService::isShownTo),
                (run, who) -> new StreamMessage.RunChanged(RunViewMapper.view(run)),
                runs::underWay,
                null,
                feed -> runs.addListener(
                        (operation, why) -> feed.changed(operation.id().value(), () -> runs.picture(operation))));
    }

    private static StreamTopic<Snapshot<FollowState>> follows(FollowService follows) {
        return new StreamTopic<>(
                StreamMessage.FollowChanged.class,
                FOUR_A_SECOND,
                new StreamTopic.SubjectMapping<>(
                        "follow", follow -> follow.saved().id().value()),
                StreamTopic.Audience.of("the organisation, whoever sees the drone", FollowService::isShownTo),
                (follow, who) -> new StreamMessage.FollowChanged(follows.view(follow)),
                follows::underWay,
                null,
                feed -> follows.addListener(
                        (operation, why) -> feed.changed(operation.id().value(), () -> follows.picture(operation))));
    }

    private static StreamTopic<Snapshot<FollowState>> followsNow(FollowService follows, StreamEventRouter news) {
        return new StreamTopic<>(
                StreamMessage.FollowNow.class,
                FOUR_A_SECOND,
                new StreamTopic.SubjectMapping<>(
                        "followNow", follow -> follow.saved().id().value()),
                StreamTopic.Audience.of("the organisation, whoever sees the drone", FollowService::isShownTo),
                (follow, who) -> new StreamMessage.FollowNow(
                        follow.saved().id().value(), follows.view(follow).now()),
                List::of,
                null,
                feed -> news.onMoves(drones -> follows.underWay().stream()
                        .filter(follow -> drones.contains(follow.state().drone()))
                        .forEach(follow -> feed.changed(follow.saved().id().value(), () -> Optional.of(follow)))));
    }

    private static StreamTopic<CommandRecord> commands(StreamEventRouter news) {
        return new StreamTopic<>(
                StreamMessage.Command.class,
                EVERY_CHANGE,
                new StreamTopic.SubjectMapping<>(
                        StreamMessageSubject.DRONE, command -> command.drone().value()),
                StreamTopic.Audience.of("whoever sees the drone", (who, command) -> who.sees(command.drone())),
                (command, who) -> new StreamMessage.Command(CommandView.of(command)),
                List::of,
                null,
                feed -> news.onCommand(feed::publish));
    }

    private static StreamTopic<StreamEventRouter.ControlEvent> controls(StreamEventRouter news) {
        return new StreamTopic<>(
                StreamMessage.Control.class,
                EVERY_CHANGE,
                new StreamTopic.SubjectMapping<>(
                        StreamMessageSubject.DRONE, told -> told.drone().value()),
                StreamTopic.Audience.of("whoever sees the drone", (who, told) -> who.sees(told.drone())),
                (told, who) -> new StreamMessage.Control(
                        told.drone().value(), ControlView.of(told.now()), ControlView.ChangeView.of(told.change())),
                List::of,
                null,
                feed -> news.onControl(feed::publish));
    }
}
