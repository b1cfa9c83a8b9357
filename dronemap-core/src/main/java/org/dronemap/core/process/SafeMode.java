package org.dronemap.core.process;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Precautions of a start after repeated crashes: no operations, and no bytes from suspected peers. After {@value
 * #MOST_ENDS} ends within two minutes it goes on with no operation, and takes nothing from whose bytes were being
 * worked on at two of them: one of these may be why they ended, and links, hold, land and return must be there.
 *
 * @param ends that it goes by, the oldest first; none: there is no need for care
 * @param refused whom nothing is taken from
 */
public record SafeMode(List<ProcessCrash> ends, Set<PeerPattern> refused) {
    /** An ordinary start. */
    public static final SafeMode NONE = new SafeMode(List.of(), Set.of());

    private static final int MOST_ENDS = 3;
    private static final Duration TOGETHER = Duration.ofMinutes(2);
    private static final int PROOF = 2;

    public SafeMode {
        ends = List.copyOf(ends);
        refused = Set.copyOf(refused);
    }

    /** {@code ends}: all that are known, the oldest first. */
    public static SafeMode after(List<ProcessCrash> ends, Instant now) {
        if (ends.isEmpty() || isLongBefore(ends.get(ends.size() - 1), now)) {
            return NONE;
        }
        // Before the newest end, not before now: a start may take long.
        Instant newest = ends.get(ends.size() - 1).at();
        List<ProcessCrash> together =
                ends.stream().filter(end -> !isLongBefore(end, newest)).toList();
        return together.size() < MOST_ENDS ? NONE : new SafeMode(together, suspects(together));
    }

    private static boolean isLongBefore(ProcessCrash end, Instant time) {
        return end.at().isBefore(time.minus(TOGETHER));
    }

    public boolean isActive() {
        return !ends.isEmpty();
    }

    public boolean refuses(PeerPattern peer) {
        return refused.stream().anyMatch(group -> group.covers(peer));
    }

    /** Ports change with each connection, so that a vehicle, and at last a host, may have to stand for them. */
    private static Set<PeerPattern> suspects(List<ProcessCrash> ends) {
        return Stream.<Function<PeerPattern, Optional<PeerPattern>>>of(
                        peer -> Optional.of(peer.address()),
                        PeerPattern::vehicle,
                        peer -> Optional.of(peer.anyOfHost()))
                .map(group -> often(ends, group))
                .filter(often -> !often.isEmpty())
                .findFirst()
                .orElse(Set.of());
    }

    private static Set<PeerPattern> often(List<ProcessCrash> ends, Function<PeerPattern, Optional<PeerPattern>> group) {
        Map<PeerPattern, Long> times = ends.stream()
                .flatMap(end -> end.peers().stream()
                        .map(group)
                        .flatMap(Optional::stream)
                        .distinct())
                .collect(Collectors.groupingBy(Function.identity(), Collectors.counting()));
        return times.entrySet().stream()
                .filter(entry -> entry.getValue() >= PROOF)
                .map(Map.Entry::getKey)
                .collect(Collectors.toSet());
    }
}
