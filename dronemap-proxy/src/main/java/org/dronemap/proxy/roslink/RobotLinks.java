package org.dronemap.proxy.roslink;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.LinkReport;
import org.dronemap.proxy.roslink.wire.RobotSequenceTracker;
import org.dronemap.proxy.roslink.wire.RoslinkHeader;

/**
 * The links of one ROSLink robot: at most one of each transport, all from one host. Another one takes a place only when
 * the one there has fallen silent, so that a key which somebody copied diverts nothing from a robot that is heard.
 * Thread-safe.
 */
final class RobotLinks {
    /** Two heartbeats of a second may be lost. */
    static final long SILENT_NANOS = 2_500_000_000L;

    private final List<RobotLink> links = new ArrayList<>();
    private RobotSequenceTracker numbers = new RobotSequenceTracker();
    private long lostEarlier;

    RobotLinks(RobotLink first) {
        links.add(first);
    }

    /** A message came by one of them; how many of the robot's messages are missing. */
    synchronized long numbered(RoslinkHeader header) {
        numbers.isNew(header);
        return lost();
    }

    synchronized long lost() {
        return lostEarlier + numbers.lost();
    }

    /** Why the newcomer stays outside; empty when it is one of the links from now on. */
    synchronized Optional<String> join(RobotLink newer) {
        for (RobotLink link : links) {
            if (link.silenceNanos() < SILENT_NANOS) {
                if (!link.host().equals(newer.host())) {
                    return Optional.of("it is heard from another host");
                }
                if (link.transport().equals(newer.transport())) {
                    return Optional.of("it is heard from another port");
                }
            }
        }
        boolean elsewhere = links.stream().noneMatch(link -> link.host().equals(newer.host()));
        for (RobotLink link : List.copyOf(links)) {
            if (elsewhere || link.transport().equals(newer.transport())) {
                links.remove(link);
                link.cut();
            }
        }
        links.add(newer);
        // What came by it before is not missing, though nobody kept its numbers.
        lostEarlier += numbers.lost();
        numbers = new RobotSequenceTracker();
        return Optional.empty();
    }

    /** Where it is spoken to: a connection where one is heard, else where it was heard last. */
    synchronized RobotLink best() {
        RobotLink best = links.get(0);
        for (RobotLink link : links) {
            boolean heard = link.silenceNanos() < SILENT_NANOS;
            boolean bestHeard = best.silenceNanos() < SILENT_NANOS;
            boolean connection = !link.transport().equals("udp");
            boolean better = heard ? !bestHeard || connection : !bestHeard && link.silenceNanos() < best.silenceNanos();
            if (better) {
                best = link;
            }
        }
        return best;
    }

    /** Where it is spoken to, and wherever else it is heard. */
    synchronized List<RobotLink> all() {
        RobotLink best = best();
        return links.stream()
                .filter(link -> link == best || link.silenceNanos() < SILENT_NANOS)
                .toList();
    }

    /** None of them is believed any more. */
    synchronized void cut() {
        links.forEach(RobotLink::cut);
    }

    /** True when there is news to tell of how well they carry. On the lane. */
    synchronized boolean measure(long nowNanos) {
        boolean news = false;
        for (RobotLink link : links) {
            news |= link.measure(nowNanos);
        }
        return news;
    }

    synchronized LinkReport report() {
        RobotLink best = best();
        List<DroneKey> others =
                links.stream().filter(link -> link != best).map(RobotLink::key).toList();
        return new LinkReport(best.key(), best.transport(), best.quality(), best.trend(), others);
    }

    /** How long nothing came on any of them. */
    synchronized long silenceNanos() {
        return links.stream().mapToLong(RobotLink::silenceNanos).min().orElse(Long.MAX_VALUE);
    }
}
