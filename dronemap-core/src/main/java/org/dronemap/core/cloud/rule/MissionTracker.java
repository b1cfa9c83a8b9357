package org.dronemap.core.cloud.rule;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.TreeSet;
import java.util.function.Consumer;
import org.dronemap.core.drone.KnownMission;
import org.dronemap.core.drone.MissionPhase;
import org.dronemap.core.drone.MissionProgress;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.mission.CountText;
import org.dronemap.core.mission.MissionComparison;
import org.dronemap.core.mission.MissionItem;
import org.jspecify.annotations.Nullable;

/**
 * Tracks the mission on board one vehicle and its progress, and notices changes made outside this cloud. Owned by the
 * drone's lane.
 */
public final class MissionTracker {
    private final Consumer<KnownMission> remember;
    private final TreeSet<Integer> reached = new TreeSet<>();
    private @Nullable KnownMission known;
    private @Nullable List<MissionItem> items;
    private @Nullable String hash;
    private @Nullable Integer current;
    private @Nullable Integer lastFlown;
    private @Nullable Integer lastReached;
    private @Nullable MissionPhase phase;
    private @Nullable String notice;
    private boolean comparedItem;
    private boolean landingSequence;

    /** {@code known} is what was remembered before a restart; {@code remember} keeps the newest. */
    public MissionTracker(@Nullable KnownMission known, Consumer<KnownMission> remember) {
        this.known = known;
        this.remember = remember;
    }

    public MissionProgress progress() {
        return new MissionProgress(items, hash, current, phase, List.copyOf(reached), notice, landingSequence);
    }

    /** The answer is a sentence when something happened that people should hear of. */
    public Optional<String> apply(DroneEvent.MissionRead read) {
        KnownMission before = known;
        boolean first = items == null;
        if (read.asUploaded() || !read.items().equals(items)) {
            reached.clear();
            lastFlown = null;
        }
        items = read.items();
        hash = read.hash();
        landingSequence = read.landingSequence();
        if (read.asUploaded()) {
            notice = null;
            comparedItem = true;
            return keep();
        }
        Optional<String> difference = before == null ? Optional.empty() : difference(before, read);
        if (difference.isPresent()) {
            notice = noticeOf(difference.get(), before, read.items());
            comparedItem = true;
            // A vehicle that forgot its mission with its power does what it always does.
            return first && read.items().isEmpty() ? Optional.empty() : Optional.of(notice);
        }
        notice = null;
        if (before == null) {
            keep();
        } else if (before.hash() == null && hash != null) {
            remember(before.withHash(hash));
        }
        return first ? compareItem() : Optional.empty();
    }

    private Optional<String> difference(KnownMission before, DroneEvent.MissionRead read) {
        if (before.hash() != null && before.hash().equals(read.hash())) {
            // An earlier version may have had other words for the same items.
            return Optional.empty();
        }
        Optional<String> visible = MissionComparison.difference(before.items(), read.items());
        boolean otherHash =
                before.hash() != null && read.hash() != null && !before.hash().equals(read.hash());
        return visible.isEmpty() && otherHash ? Optional.of("its items have other settings") : visible;
    }

    private static String noticeOf(String difference, @Nullable KnownMission before, List<MissionItem> found) {
        if (before != null && found.isEmpty()) {
            return "The vehicle holds no mission now; the last one that the cloud knew had "
                    + CountText.of(before.items().size(), "item") + ".";
        }
        return "The mission on the vehicle is not the one that the cloud last knew: " + difference + ".";
    }

    public void apply(DroneEvent.MissionItemReached arrived) {
        int index = arrived.index();
        // Some autopilots say their last one again and again, also when it lies ahead once more.
        if (!Objects.equals(index, lastReached)) {
            reached.add(index);
        }
        lastReached = index;
    }

    /** As above. */
    public Optional<String> apply(DroneEvent.MissionCurrentReported heard) {
        Integer index = heard.index();
        if (Objects.equals(index, current) && heard.phase() == phase) {
            return Optional.empty();
        }
        current = index;
        phase = heard.phase();
        follow(index, phase);
        Optional<String> sentence = compareItem();
        if (items != null && notice == null) {
            keep();
        }
        return sentence;
    }

    private void follow(@Nullable Integer index, @Nullable MissionPhase now) {
        List<MissionItem> all = items;
        if (now == MissionPhase.COMPLETE) {
            if (all != null && !all.isEmpty()) {
                reached.add(all.size() - 1);
            }
        } else if (index != null && (now == null || now == MissionPhase.RUNNING)) {
            if (lastFlown != null && index < lastFlown) {
                // It flies this part again.
                reached.tailSet(index).clear();
            }
            lastFlown = index;
        }
    }

    /** Once after a restart, when mission and item are both known: what did the vehicle do meanwhile? */
    private Optional<String> compareItem() {
        KnownMission before = known;
        if (comparedItem || items == null || current == null || before == null) {
            return Optional.empty();
        }
        comparedItem = true;
        Integer was = before.current();
        int last = items.size() - 1;
        if (was != null && phase == MissionPhase.COMPLETE && was < last) {
            passed(items.size());
            return Optional.of("While the cloud was away the vehicle flew its mission to the end.");
        }
        if (was == null || was >= current) {
            return Optional.empty();
        }
        passed(current);
        return Optional.of("While the cloud was away the vehicle flew on from item " + (was + 1) + " to item "
                + (current + 1) + " of its mission.");
    }

    private void passed(int count) {
        for (int index = 0; index < count; index++) {
            reached.add(index);
        }
    }

    private Optional<String> keep() {
        if (items != null) {
            remember(new KnownMission(items, hash, current));
        }
        return Optional.empty();
    }

    private void remember(KnownMission now) {
        known = now;
        remember.accept(now);
    }
}
