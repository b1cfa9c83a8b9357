package org.dronemap.proxy.session;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.cloud.SendAuthority;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.LinkQuality;
import org.dronemap.core.drone.LinkReport;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.proxy.mavlink.procedure.RoundTripEstimator;

/** The links of one MAVLink vehicle, and the choice of the best one for sending. Owned by the lane of the session. */
final class LinkSelector {
    /** A link silent for longer than this gives way at once to one that is not. */
    private static final long SILENT_NANOS = 1_000_000_000L;

    private static final long LEFT_NANOS = 3_000_000_000L;
    /** A link silent for so long is given up when there is another. */
    private static final long GIVEN_UP_NANOS = 30_000_000_000L;
    /** Better by so much (as a share of lost messages) before the way is changed, so that it does not swing. */
    private static final double MARGIN = 0.05;

    private static final double LOSS_OF_A_MILLI = 1.0 / 2_000;
    private static final int MOST = 8;

    private final List<VehicleLink> links = new ArrayList<>();
    private VehicleLink best;
    private LinkReport publishedReport;
    private volatile boolean safe;

    LinkSelector(VehicleLink first) {
        links.add(first);
        best = first;
        publishedReport = report();
        safe = first.downlink().isSafe();
    }

    /** A further link of the same vehicle: the only one from now on, unless it and others show proof. */
    void join(VehicleLink newer) {
        for (VehicleLink link : List.copyOf(links)) {
            if (newer.proof() == null || link.proof() == null || links.size() >= MOST) {
                leave(link);
            }
        }
        links.add(newer);
        safe |= newer.downlink().isSafe();
        if (!links.contains(best)) {
            best = newer;
        }
    }

    private void leave(VehicleLink link) {
        links.remove(link);
        link.cut();
        safe = links.stream().anyMatch(other -> other.downlink().isSafe());
    }

    /** Several are in use: the same frame may come more than once. */
    boolean isRedundant() {
        return links.size() > 1;
    }

    void send(Message message) {
        best.send(message, SendAuthority.HOUSEKEEPING);
    }

    /** Sends what its mandate still lets pass when its turn on the wire comes. */
    void send(Message message, SendAuthority mandate) {
        best.send(message, mandate);
    }

    /** Sends at once what nobody but the vehicle may see, on a link where nobody can listen if there is one. */
    void sendSecret(Message message) {
        links.stream()
                .filter(link -> link.downlink().isSafe())
                .findFirst()
                .orElse(best)
                .downlink()
                .sendSecret(message);
    }

    /** There is a link on which nobody but the vehicle can listen. Any thread. */
    boolean isSafe() {
        return safe;
    }

    /** How long answers take on the link that is spoken on. */
    RoundTripEstimator roundTrip() {
        return best.meter().roundTrip();
    }

    /** A frame of the vehicle's autopilot, on whichever link. */
    void received(Frame frame, long nowNanos) {
        links.forEach(link -> link.meter().received(frame, nowNanos));
    }

    /** Asks for round trips when that is due; not where nobody has spoken for long: the vehicle may have moved on. */
    void ask(long nowNanos) {
        for (VehicleLink link : links) {
            if (link == best || link.silenceNanos(nowNanos) < LEFT_NANOS) {
                link.meter().ask(nowNanos);
            }
        }
    }

    /** True when there is news to tell. */
    boolean advance(long nowNanos) {
        boolean measured = false;
        for (VehicleLink link : links) {
            measured |= link.meter().advance(nowNanos);
            link.downlink().releaseDue(nowNanos);
        }
        if (links.size() > 1) {
            giveUp(nowNanos);
            choose(nowNanos, measured);
        }
        LinkReport now = report();
        boolean news = !now.equals(publishedReport);
        publishedReport = now;
        return news;
    }

    private void giveUp(long nowNanos) {
        for (VehicleLink link : List.copyOf(links)) {
            if (links.size() > 1 && link != best && link.silenceNanos(nowNanos) > GIVEN_UP_NANOS) {
                leave(link);
            }
        }
    }

    private void choose(long nowNanos, boolean measured) {
        boolean silent = best.silenceNanos(nowNanos) > SILENT_NANOS;
        if (!silent && !measured) {
            return;
        }
        for (VehicleLink link : links) {
            boolean better = silent || cost(link) + MARGIN < cost(best);
            if (link != best && link.silenceNanos(nowNanos) <= SILENT_NANOS && better) {
                best = link;
                silent = false;
            }
        }
    }

    /** Share of lost messages, and a little for a long way. */
    private static double cost(VehicleLink link) {
        LinkQuality quality = link.meter().quality();
        Double loss = quality.lossShort();
        Double trip = quality.roundTripMillis();
        return (loss == null ? 0 : loss) + (trip == null ? 0 : trip * LOSS_OF_A_MILLI);
    }

    VehicleLink best() {
        return best;
    }

    LinkReport report() {
        List<DroneKey> others = links.stream()
                .filter(link -> link != best)
                .map(VehicleLink::key)
                .toList();
        return new LinkReport(
                best.key(),
                best.label().transport(),
                best.meter().quality(),
                best.meter().trend(),
                others);
    }
}
