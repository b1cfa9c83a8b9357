package org.dronemap.core.cloud;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.TreeSet;
import java.util.function.Consumer;
import org.dronemap.core.drone.KnownMission;
import org.dronemap.core.drone.MissionProgress;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.mission.MissionComparison;
import org.dronemap.core.mission.MissionItem;
import org.jspecify.annotations.Nullable;

/** Follows the mission on one vehicle and notices what changed without the cloud. Owned by the drone's lane. */
final class MissionTracker {
    private final Consumer<KnownMission> remember;
    private final TreeSet<Integer> reached = new TreeSet<>();
    private @Nullable KnownMission known;
    private @Nullable List<MissionItem> items;
    private @Nullable Integer current;
    private @Nullable String notice;
    private boolean comparedItem;

    /** {@code known} is what was remembered before a restart; {@code remember} keeps the newest. */
    MissionTracker(@Nullable KnownMission known, Consumer<KnownMission> remember) {
        this.known = known;
        this.remember = remember;
    }

    MissionProgress progress() {
        return new MissionProgress(items, current, List.copyOf(reached), notice);
    }

    /** Takes a mission event in; the answer is a sentence when something happened that people should hear of. */
    Optional<String> apply(DroneEvent event) {
        if (event instanceof DroneEvent.MissionRead read) {
            return read(read);
        }
        if (event instanceof DroneEvent.MissionCurrentHeard heard) {
            return headsFor(heard.index());
        }
        if (event instanceof DroneEvent.MissionItemReached arrived) {
            reached.add(arrived.index());
        }
        return Optional.empty();
    }

    private Optional<String> read(DroneEvent.MissionRead read) {
        KnownMission before = known;
        boolean first = items == null;
        if (read.asUploaded() || !read.items().equals(items)) {
            reached.clear();
        }
        items = read.items();
        if (read.asUploaded()) {
            notice = null;
            comparedItem = true;
            return keep();
        }
        Optional<String> difference =
                before == null ? Optional.empty() : MissionComparison.difference(before.items(), read.items());
        if (difference.isPresent()) {
            notice = "The mission on the vehicle is not the one that the cloud last knew: " + difference.get() + ".";
            comparedItem = true;
            return Optional.of(notice);
        }
        if (before == null) {
            keep();
        }
        return first ? compareItem() : Optional.empty();
    }

    private Optional<String> headsFor(@Nullable Integer index) {
        if (Objects.equals(index, current)) {
            return Optional.empty();
        }
        if (index != null && current != null && index < current) {
            // It flies this part again.
            reached.tailSet(index).clear();
        }
        current = index;
        Optional<String> sentence = compareItem();
        if (items != null && notice == null) {
            keep();
        }
        return sentence;
    }

    /** Once after a restart, when mission and item are both known: what did the vehicle do meanwhile? */
    private Optional<String> compareItem() {
        KnownMission before = known;
        if (comparedItem || items == null || current == null || before == null) {
            return Optional.empty();
        }
        comparedItem = true;
        Integer was = before.current();
        if (was == null || was >= current) {
            return Optional.empty();
        }
        for (int passed = 0; passed < current; passed++) {
            reached.add(passed);
        }
        return Optional.of("While the cloud was away the vehicle flew on from item " + (was + 1) + " to item "
                + (current + 1) + " of its mission.");
    }

    private Optional<String> keep() {
        if (items != null) {
            KnownMission now = new KnownMission(items, current);
            known = now;
            remember.accept(now);
        }
        return Optional.empty();
    }
}
