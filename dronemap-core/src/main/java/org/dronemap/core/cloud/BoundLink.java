package org.dronemap.core.cloud;

import org.dronemap.core.cloud.lane.Lane;
import org.dronemap.core.cloud.lane.LinkPace;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.LinkReport;
import org.dronemap.core.event.DroneEvent;

/** The DroneLink of one session that is bound to a drone: passes on what arrives while the session is current. */
final class BoundLink implements DroneLink {
    private final ManagedDrone drone;
    private final LinkSession session;
    private final Registrations registrations;

    /** Registry of drones, as the link session of one drone uses it. */
    interface Registrations {
        boolean contains(ManagedDrone drone);

        /** Writes down what is new about it. */
        void remember(ManagedDrone drone);

        void drop(ManagedDrone drone);

        /** As if it had never been. */
        void forget(ManagedDrone nobody);
    }

    BoundLink(ManagedDrone drone, LinkSession session, Registrations registrations) {
        this.drone = drone;
        this.session = session;
        this.registrations = registrations;
    }

    @Override
    public DroneId id() {
        return drone.id();
    }

    @Override
    public Lane lane() {
        return drone.lane();
    }

    @Override
    public boolean isGone() {
        return !registrations.contains(drone) || !drone.isAttachedTo(session);
    }

    @Override
    public void received(LinkPace pace) {
        if (drone.isAttachedTo(session)) {
            drone.received(pace);
        }
    }

    @Override
    public void accept(DroneEvent event) {
        if (!drone.isAttachedTo(session)) {
            return;
        }
        drone.accept(event);
        if (drone.drone().leftTheGround() || event instanceof DroneEvent.Identified) {
            registrations.remember(drone);
        }
    }

    @Override
    public void linkChanged(LinkReport report) {
        if (drone.isAttachedTo(session)) {
            drone.linkChanged(report);
        }
    }

    @Override
    public void proved(IdentityProof proof) {
        if (drone.isAttachedTo(session)) {
            drone.proved(proof);
            registrations.remember(drone);
        }
    }

    @Override
    public void becamePart() {
        drone.lane().execute(() -> {
            if (registrations.contains(drone)) {
                drone.becamePart();
                registrations.remember(drone);
            }
        });
    }

    @Override
    public void withdraw() {
        if (drone.isOnlyJustKnown()) {
            registrations.forget(drone);
        }
    }

    @Override
    public void replayEnded() {
        if (drone.isAttachedTo(session)) {
            drone.replayEnded();
        }
    }

    @Override
    public void disconnect() {
        if (session.replay()) {
            registrations.drop(drone);
        }
    }
}
