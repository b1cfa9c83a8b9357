package org.dronemap.core.parameter;

import java.util.ArrayList;
import java.util.List;

/**
 * Compares a parameter file with a vehicle: what differs, what is unknown, and what does not fit.
 *
 * @param same how many are as in the file already
 * @param unknown names that the vehicle does not have
 * @param unfit what the parameter's type cannot hold
 */
public record ParameterComparison(List<Difference> different, int same, List<String> unknown, List<Difference> unfit) {
    /** A parameter as the vehicle holds it, and what it would get. */
    public record Difference(Parameter held, double wanted) {}

    public ParameterComparison {
        different = List.copyOf(different);
        unknown = List.copyOf(unknown);
        unfit = List.copyOf(unfit);
    }

    public static ParameterComparison of(ParameterSet vehicle, List<ParameterValue> file) {
        List<Difference> different = new ArrayList<>();
        List<Difference> unfit = new ArrayList<>();
        List<String> unknown = new ArrayList<>();
        int same = 0;
        for (ParameterValue wanted : file) {
            Parameter held = vehicle.find(wanted.name()).orElse(null);
            if (held == null) {
                unknown.add(wanted.name());
            } else if (!held.type().holds(wanted.value())) {
                // Even where it would be rounded to what the vehicle has.
                unfit.add(new Difference(held, wanted.value()));
            } else if (held.type().held(wanted.value()) == held.value()) {
                same++;
            } else {
                different.add(new Difference(held, held.type().held(wanted.value())));
            }
        }
        return new ParameterComparison(different, same, unknown, unfit);
    }

    /** What has to be sent so that the vehicle is as the file says, as far as it can be. */
    public List<ParameterValue> changes() {
        return different.stream()
                .map(difference -> new ParameterValue(difference.held().name(), difference.wanted()))
                .toList();
    }
}
