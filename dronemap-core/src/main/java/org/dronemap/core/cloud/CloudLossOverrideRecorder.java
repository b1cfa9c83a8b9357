package org.dronemap.core.cloud;

import java.time.Clock;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.concurrent.CompletableFuture;
import java.util.function.DoublePredicate;
import org.dronemap.core.command.ParameterOverrideRecorder;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.ParameterOverrides;
import org.dronemap.core.parameter.OverriddenParameter;
import org.dronemap.core.parameter.ParameterValue;
import org.jspecify.annotations.Nullable;

/**
 * Records, for one command that sets or restores a drone's cloud-loss parameters, the owner's values and the result. On
 * its lane.
 */
final class CloudLossOverrideRecorder implements ParameterOverrideRecorder {
    private final DroneState drone;
    private final ParameterOverrideRegistry desk;
    private final DoublePredicate allowed;
    private final Clock clock;
    private final List<String> left = new ArrayList<>();
    private @Nullable OverridePlan plan;
    private boolean crossing;

    /** {@code allowed}: whether it may fly home at that height. */
    CloudLossOverrideRecorder(DroneState drone, ParameterOverrideRegistry desk, DoublePredicate allowed, Clock clock) {
        this.drone = drone;
        this.desk = desk;
        this.allowed = allowed;
        this.clock = clock;
    }

    /** As kept, of an earlier use that is not put back. */
    List<OverriddenParameter> earlier() {
        return desk.kept(drone.id()).map(ParameterOverrides::values).orElse(List.of());
    }

    @Nullable
    OverridePlan plan() {
        return plan;
    }

    /** No height was free: its way home may cross another's. */
    boolean crossing() {
        return crossing;
    }

    /** A sentence on each value that was left as it was found. */
    List<String> left() {
        return left;
    }

    @Override
    public double returnMeters(double owners) {
        OptionalDouble chosen = desk.heights().choose(drone, owners, allowed);
        crossing = chosen.isEmpty();
        return chosen.orElse(owners);
    }

    @Override
    public CompletableFuture<Void> keep(OverridePlan found) {
        plan = found;
        List<OverriddenParameter> values = new ArrayList<>(found.values());
        // What the vehicle did not tell this time is still outstanding.
        earlier().stream()
                .filter(before -> values.stream().noneMatch(now -> now.name().equals(before.name())))
                .forEach(values::add);
        return values.isEmpty() && found.returnMeters() == null
                ? CompletableFuture.completedFuture(null)
                : desk.keep(new ParameterOverrides(
                        drone.id(), drone.name(), clock.instant(), found.returnMeters(), false, values));
    }

    @Override
    public void skipped(List<ParameterValue> shown) {
        for (ParameterValue value : shown) {
            String owners = earlier().stream()
                    .filter(kept -> kept.name().equals(value.name()))
                    .map(kept -> new ParameterValue(kept.name(), kept.owners()).text())
                    .findFirst()
                    .orElse(value.name());
            left.add(String.format(
                    Locale.ROOT,
                    "%s was changed by somebody else meanwhile, so it stays; its owner had set %s.",
                    value.text(),
                    owners));
        }
    }
}
