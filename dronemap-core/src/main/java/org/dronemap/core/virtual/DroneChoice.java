package org.dronemap.core.virtual;

import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.dronemap.core.drone.DroneId;
import org.jspecify.annotations.Nullable;

/**
 * The drone chosen to serve a virtual drone or a follow, with the reason and the runner-up.
 *
 * @param runnerUp null: there was no other one
 * @param deciding what the two were told apart by; null without a runner-up
 * @param chosenValue the chosen one's quantity, and {@code otherValue} the runner-up's
 * @param energy what the mission takes, in words
 * @param unfit drones that could not serve, and why
 */
public record DroneChoice(
        DroneId chosen,
        @Nullable DroneId runnerUp,
        @Nullable SelectionCriterion deciding,
        double chosenValue,
        double otherValue,
        String energy,
        List<Unfit> unfit) {
    /** A drone that could not serve; {@code why} is a sentence. */
    public record Unfit(DroneId drone, String why) {}

    public DroneChoice {
        unfit = List.copyOf(unfit);
    }

    /** Empty when nobody can serve. */
    public static Optional<DroneChoice> among(Collection<DroneCandidate> candidates, List<Unfit> unfit) {
        List<DroneCandidate> best =
                candidates.stream().sorted(DroneCandidate.BEST_FIRST).limit(2).toList();
        if (best.isEmpty()) {
            return Optional.empty();
        }
        DroneCandidate first = best.get(0);
        if (best.size() == 1) {
            return Optional.of(new DroneChoice(first.drone(), null, null, 0, 0, first.energy(), unfit));
        }
        DroneCandidate second = best.get(1);
        SelectionCriterion deciding = first.decidingAgainst(second);
        return Optional.of(new DroneChoice(
                first.drone(),
                second.drone(),
                deciding,
                first.value(deciding, 1),
                second.value(deciding, 2),
                first.energy(),
                unfit));
    }

    /** Names drones as {@code name} does: for those who may know them. */
    public String sentence(Function<DroneId, String> name) {
        String why = deciding == null || runnerUp == null
                ? name.apply(chosen) + " was chosen: no other drone "
                        + (unfit.isEmpty() ? "came into question." : "could serve.")
                : name.apply(chosen) + " was chosen: " + deciding.words(chosenValue) + ", the runner-up "
                        + name.apply(runnerUp) + " " + deciding.words(otherValue) + ".";
        return why + energySentence() + others(name);
    }

    /** Names no drone: for those who hold the virtual one alone. */
    public String anonymous() {
        String why = deciding == null
                ? "A drone was chosen: no other one could serve."
                : "A drone was chosen: " + deciding.words(chosenValue) + ", the runner-up " + deciding.words(otherValue)
                        + ".";
        return why + energySentence();
    }

    private String energySentence() {
        return " The mission takes " + energy + ".";
    }

    private String others(Function<DroneId, String> name) {
        return unfit.isEmpty()
                ? ""
                : " Others could not serve: "
                        + unfit.stream()
                                .map(one -> name.apply(one.drone()) + ": " + one.why())
                                .collect(Collectors.joining(" "));
    }
}
