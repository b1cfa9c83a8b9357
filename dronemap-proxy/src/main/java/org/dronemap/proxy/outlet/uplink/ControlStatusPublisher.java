package org.dronemap.proxy.outlet.uplink;

import java.util.Map;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.cloud.listener.CloudListener;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.lease.ControlChange;
import org.dronemap.core.lease.ControlState;
import org.dronemap.core.lease.Lease;
import org.dronemap.core.lease.LeaseHolder;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.ControlStatus;
import org.dronemap.proxy.outlet.client.OutletClient;
import org.jspecify.annotations.Nullable;

/**
 * Tells ground stations at the outlet who controls the drones they see: CONTROL_STATUS every second and on change.
 * Owned by the outlet's thread, but for {@link #controlChanged}.
 */
final class ControlStatusPublisher implements CloudListener, AutoCloseable {
    private static final int ANSWER_SECONDS = 60;

    private final CloudManager cloud;
    private final Map<DroneId, VehicleFrameCache> vehicles;
    private final AttachedClients attached;

    ControlStatusPublisher(CloudManager cloud, Map<DroneId, VehicleFrameCache> vehicles, AttachedClients attached) {
        this.cloud = cloud;
        this.vehicles = vehicles;
        this.attached = attached;
        cloud.addListener(this);
    }

    /** Tells all of all; whose link takes nothing is told a second later. */
    void publishAll() {
        vehicles.forEach((drone, vehicle) -> {
            ControlState control = cloud.controls().control(drone);
            for (OutletClient client : attached.clients()) {
                if (client.isUpToDate() && client.shows(drone)) {
                    new ClientReplySender(client, drone, vehicle).send(status(client, control));
                }
            }
        });
    }

    /** Any thread. */
    @Override
    public void controlChanged(DroneId drone, ControlState now, ControlChange change) {
        attached.later(() -> publish(drone, now, change));
    }

    private void publish(DroneId drone, ControlState now, ControlChange change) {
        VehicleFrameCache vehicle = vehicles.get(drone);
        if (vehicle == null) {
            return;
        }
        for (OutletClient client : attached.clients()) {
            if (client.shows(drone)) {
                ClientReplySender voice = new ClientReplySender(client, drone, vehicle);
                voice.send(status(client, now));
                notifyClient(voice, change);
            }
        }
    }

    /** Under another system id than the client's own stands everybody else: the cloud, which stands between. */
    private static ControlStatus status(OutletClient client, ControlState control) {
        Lease tenure = control.tenure();
        boolean free = tenure == null || tenure.holder() instanceof LeaseHolder.Pilot;
        int flags = ControlStatus.SYSTEM_MANAGER | (free ? ControlStatus.TAKEOVER_ALLOWED : 0);
        int own = control.isHeldBy(client.user()) ? client.systemId() : client.cloudId();
        return new ControlStatus(flags, free ? 0 : own);
    }

    private static void notifyClient(ClientReplySender voice, ControlChange change) {
        OutletClient client = voice.client();
        LeaseHolder other = change.other();
        if (other == null || !other.is(client.user()) || change.by().is(client.user())) {
            return;
        }
        if (change.kind() == ControlChange.Kind.REQUESTED) {
            voice.send(new CommandLong(
                    client.systemId(),
                    0,
                    ClientCommandReader.OPERATOR_CONTROL,
                    0,
                    1,
                    0,
                    ANSWER_SECONDS,
                    client.cloudId(),
                    0,
                    0,
                    0));
        }
        String news = news(change.kind());
        if (news != null) {
            String reason = change.reason();
            boolean byMode = change.kind() == ControlChange.Kind.PILOT_ACTED;
            String why = reason == null ? "." : (byMode ? " by changing the mode to " : ": ") + reason + ".";
            voice.explain(change.by().words() + news + why);
        }
    }

    /** What whoever did it did to whom it befell; null: not told in words. */
    private static @Nullable String news(ControlChange.Kind kind) {
        return switch (kind) {
            case REQUESTED -> " asks for control";
            case REFUSED -> " keeps control";
            case HANDED_OVER -> " gave you control";
            case TAKEN_OVER, PILOT_ACTED -> " took control";
            default -> null;
        };
    }

    @Override
    public void close() {
        cloud.removeListener(this);
    }
}
