package org.dronemap.ws.stream;

import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.dronemap.cognitive.operation.follow.FollowState;
import org.dronemap.cognitive.operation.run.RunState;
import org.dronemap.core.access.GrantBook;
import org.dronemap.core.cloud.CloudListener;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.conduct.Operations.Picture;
import org.dronemap.core.conduct.VirtualListener;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.lease.Control;
import org.dronemap.core.lease.ControlChange;
import org.dronemap.core.operation.SavedOperation;
import org.dronemap.core.virtual.VirtualDrone;
import org.dronemap.core.zone.Zone;
import org.dronemap.core.zone.ZoneBook;
import org.dronemap.ws.service.JsonReader;
import org.dronemap.ws.service.PlanJob;
import org.dronemap.ws.service.PlanListener;

/**
 * Hears of all that changes, on any thread, and puts it into the topics' feeds; the pump has them hand it out. What must
 * arrive is given to the clients at once.
 */
final class StreamNews implements CloudListener, VirtualListener, PlanListener {
    private static final long MOVES_GAP_NANOS = 250_000_000L;
    private static final Pump.Pause NOBODY_LISTENS = new Pump.Pause(5_000_000L, 40_000_000L);

    private final GrantBook grants;
    private final StreamFace.Pictures pictures;
    private final Collection<StreamClient> clients;
    private final Runnable wake;
    private final TopicFeed<DroneState> drones;
    private final TopicFeed<Zone> zones;
    private final TopicFeed<VirtualDrone> virtualDrones;
    private final TopicFeed<PlanJob> plans;
    private final TopicFeed<Picture<RunState>> runs;
    private final TopicFeed<Picture<FollowState>> follows;
    private final TopicFeed<Picture<FollowState>> followsNow;
    private final TopicFeed<CommandRecord> commands;
    private final TopicFeed<Topics.ControlNews> controls;
    private final List<TopicFeed<?>> feeds;
    private final Set<DroneId> moved = ConcurrentHashMap.newKeySet();
    // Owned by the pump.
    private long movesNanos = System.nanoTime();
    private long edition;

    /** {@code wake} asks for a round of the pump. */
    StreamNews(
            CloudManager cloud,
            GrantBook grants,
            StreamFace.Pictures pictures,
            JsonReader json,
            StreamCrowd crowd,
            Runnable wake) {
        this.grants = grants;
        this.pictures = pictures;
        this.clients = crowd.clients();
        this.wake = wake;
        this.drones = new TopicFeed<>(Topics.drones(cloud, pictures.drones()), json);
        this.zones = new TopicFeed<>(Topics.zones(), json);
        this.virtualDrones = new TopicFeed<>(Topics.virtualDrones(pictures.virtuals(), pictures.virtualViews()), json);
        this.plans = new TopicFeed<>(Topics.plans(pictures.plans()), json);
        this.runs = new TopicFeed<>(Topics.runs(pictures.runs()), json);
        this.follows = new TopicFeed<>(Topics.follows(pictures.follows()), json);
        this.followsNow = new TopicFeed<>(Topics.followsNow(pictures.follows()), json);
        this.commands = new TopicFeed<>(Topics.commands(), json);
        this.controls = new TopicFeed<>(Topics.controls(), json);
        this.feeds = List.of(zones, virtualDrones, plans, runs, follows, followsNow, commands, controls, drones);
    }

    List<Topic<?>> topics() {
        return feeds.stream().<Topic<?>>map(TopicFeed::topic).toList();
    }

    void listen(CloudManager cloud) {
        cloud.addListener(this);
        cloud.zones().onChange(this::zonesChanged);
        pictures.virtuals().addListener(this);
        pictures.plans().addListener(this);
        pictures.runs().addListener((operation, why) -> operationChanged(operation));
    }

    @Override
    public void droneChanged(DroneState state) {
        drones.changed(Subject.drone(state.id()), () -> Optional.of(state));
        moved.add(state.id());
        wake();
    }

    @Override
    public void droneRemoved(DroneId id) {
        drones.removed(Subject.drone(id));
        wake();
    }

    @Override
    public void commandChanged(CommandRecord command) {
        commands.tell(clients, command);
        wake();
    }

    @Override
    public void controlChanged(DroneId drone, Control now, ControlChange change) {
        controls.tell(clients, new Topics.ControlNews(drone, now, change));
        wake();
    }

    @Override
    public void changed(VirtualDrone drone) {
        virtualDroneChanged(drone);
        if (drone.isWaiting() || !drone.isUnderWay()) {
            // Those behind it in the queue may have moved up.
            pictures.virtuals().all().stream().filter(VirtualDrone::isWaiting).forEach(this::virtualDroneChanged);
        }
        wake();
    }

    private void virtualDroneChanged(VirtualDrone drone) {
        virtualDrones.changedAtOnce(
                Subject.virtualDrone(drone), () -> pictures.virtuals().find(drone.id()));
    }

    @Override
    public void removed(VirtualDrone drone) {
        virtualDrones.removed(Subject.virtualDrone(drone));
        wake();
    }

    @Override
    public void changed(PlanJob job) {
        plans.changed(Subject.plan(job), () -> pictures.plans().find(job.id()));
        wake();
    }

    @Override
    public void removed(PlanJob job) {
        plans.removed(Subject.plan(job));
        wake();
    }

    private void operationChanged(SavedOperation operation) {
        runs.changed(Subject.run(operation), () -> pictures.runs().picture(operation));
        follows.changed(Subject.follow(operation), () -> pictures.follows().picture(operation));
        wake();
    }

    private void zonesChanged(ZoneBook.Change change) {
        Map<String, Zone> former = change.former().stream().collect(Collectors.toMap(Zone::id, Function.identity()));
        Map<String, Zone> put = change.put().stream().collect(Collectors.toMap(Zone::id, Function.identity()));
        change.former().forEach(zone -> zones.tell(clients, zone, put.get(zone.id())));
        change.put().stream().filter(zone -> !former.containsKey(zone.id())).forEach(zone -> zones.tell(clients, zone));
        wake();
    }

    private void wake() {
        if (!clients.isEmpty()) {
            wake.run();
        }
    }

    /** A round of the pump: hands out what is due, and says when to come again. */
    Pump.Pause publish(long nowNanos) {
        feeds.forEach(feed -> feed.tellRemoved(clients));
        settle();
        if (nowNanos - movesNanos >= MOVES_GAP_NANOS) {
            movesNanos = nowNanos;
            addMoved();
        }
        Pump.Pause pause = Pump.Pause.ANY;
        for (TopicFeed<?> feed : feeds) {
            pause = pause.and(feed.publish(clients, nowNanos));
        }
        return pause.equals(Pump.Pause.ANY) ? NOBODY_LISTENS : pause;
    }

    /** When clients have come in, and when grants were changed, have begun or have ended. */
    private void settle() {
        long now = grants.edition();
        boolean changed = now != edition;
        edition = now;
        List<StreamClient> arrived =
                clients.stream().filter(StreamClient::settle).toList();
        feeds.forEach(feed -> feed.settle(changed && feed.isTakenBack() ? clients : arrived));
    }

    /** What is served by a drone moves with it. */
    private void addMoved() {
        if (moved.isEmpty()) {
            return;
        }
        Set<DroneId> drones = Set.copyOf(moved);
        moved.removeAll(drones);
        for (VirtualDrone drone : pictures.virtuals().all()) {
            if (drone.boundTo() != null && drones.contains(drone.boundTo())) {
                virtualDrones.changed(
                        Subject.virtualDrone(drone), () -> pictures.virtuals().find(drone.id()));
            }
        }
        for (Picture<FollowState> follow : pictures.follows().underWay()) {
            if (drones.contains(follow.state().drone())) {
                followsNow.changed(Subject.followNow(follow.saved()), () -> Optional.of(follow));
            }
        }
    }
}
