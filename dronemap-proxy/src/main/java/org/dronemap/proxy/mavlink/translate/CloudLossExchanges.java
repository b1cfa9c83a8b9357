package org.dronemap.proxy.mavlink.translate;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.command.ParameterOverrideRecorder;
import org.dronemap.core.command.RestoreParameters;
import org.dronemap.core.command.SetCloudLossAction;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.parameter.OverriddenParameter;
import org.dronemap.core.parameter.Parameter;
import org.dronemap.core.parameter.ParameterValue;
import org.dronemap.proxy.mavlink.procedure.Exchange;
import org.dronemap.proxy.mavlink.procedure.ExchangeSequence;
import org.dronemap.proxy.mavlink.procedure.FutureExchange;
import org.dronemap.proxy.mavlink.procedure.ImmediateExchange;
import org.dronemap.proxy.mavlink.procedure.ParameterRead;
import org.dronemap.proxy.mavlink.procedure.ParameterUpdateExchange;
import org.dronemap.proxy.mavlink.procedure.ParameterWrite;
import org.jspecify.annotations.Nullable;

/**
 * Makes the exchanges that set a vehicle's own reaction to losing the ground station, and restore its old parameters.
 */
final class CloudLossExchanges {
    private CloudLossExchanges() {}

    /**
     * The parameter of one autopilot by which a copter that waits comes home, or down.
     *
     * @param stays its values by which the vehicle stays where it is
     */
    record Setting(String name, Set<Integer> stays, int comesHome, boolean bytewise) {}

    static Exchange comeHome(CommandContext cockpit, VehicleKind kind, Setting setting) {
        if (kind != VehicleKind.MULTICOPTER && kind != VehicleKind.HELICOPTER) {
            return BasicExchanges.refuse(
                    OutcomeCode.NOT_SETTABLE, "What this vehicle does when the cloud falls silent cannot be set.");
        }
        return new ParameterUpdateExchange(
                cockpit.target(),
                new ParameterUpdateExchange.Wanted(
                        setting.name(),
                        old -> setting.stays().contains(old) ? setting.comesHome() : old,
                        setting.bytewise()));
    }

    /** Reads, has the owner's values kept, writes and reads back. {@code policy}: null where there is nothing to set. */
    static Exchange set(CommandContext cockpit, SetCloudLossAction command, @Nullable CloudLossParameters policy) {
        if (policy == null) {
            return BasicExchanges.refuse(
                    OutcomeCode.NOT_SETTABLE, "What this vehicle does without the cloud cannot be set.");
        }
        ParameterRead reading =
                new ParameterRead(cockpit.target(), cockpit.parameters().codec(), policy.names());
        List<OverriddenParameter> values = new ArrayList<>();
        return new ExchangeSequence(List.of(
                ExchangeSequence.Step.of(() -> reading),
                ExchangeSequence.Step.of(() -> new ImmediateExchange(() -> missing(policy, reading))),
                ExchangeSequence.Step.of(() -> {
                    ParameterOverrideRecorder.OverridePlan plan = plan(command, policy, reading);
                    values.addAll(plan.values());
                    return new FutureExchange(
                            command.keeper().keep(plan),
                            "What its owner had set could not be kept, so nothing was changed on it.");
                }),
                ExchangeSequence.Step.of(() -> writing(
                        cockpit,
                        values.stream()
                                .filter(value -> shown(reading, value.name()) != value.ours())
                                .map(value -> new ParameterValue(value.name(), value.ours()))
                                .toList(),
                        reading))));
    }

    private static Outcome missing(CloudLossParameters policy, ParameterRead reading) {
        return policy.settings().stream()
                .filter(setting ->
                        setting.needed() && reading.findAny(setting.names()).isEmpty())
                .findFirst()
                .<Outcome>map(setting ->
                        new Outcome.TimedOut("The vehicle did not tell its parameter " + setting.name() + "."))
                .orElseGet(Outcome.Succeeded::new);
    }

    private static ParameterOverrideRecorder.OverridePlan plan(
            SetCloudLossAction command, CloudLossParameters policy, ParameterRead reading) {
        List<OverriddenParameter> values = new ArrayList<>();
        Map<String, Double> shown = new HashMap<>();
        Map<String, Double> owners = new HashMap<>();
        Map<String, Double> ours = new HashMap<>();
        for (CloudLossParameters.Setting setting : policy.settings()) {
            reading.findAny(setting.names()).ifPresent(found -> {
                double owner = owners(command, found);
                double wanted = found.type().held(setting.wanted().applyAsDouble(owner));
                OverriddenParameter value = new OverriddenParameter(found.name(), owner, wanted, setting.bits());
                shown.put(setting.name(), found.value());
                owners.put(setting.name(), owner);
                ours.put(setting.name(), wanted);
                if (value.isToBeWritten() || setting.bits() != 0 || found.value() != wanted) {
                    values.add(value);
                }
            });
        }
        Double returns = height(command, policy.height(), reading, values);
        return new ParameterOverrideRecorder.OverridePlan(
                policy.action().of(shown, owners), policy.action().of(ours, owners), values, returns);
    }

    private static @Nullable Double height(
            SetCloudLossAction command,
            ReturnHeightExchanges.@Nullable Setting setting,
            ParameterRead reading,
            List<OverriddenParameter> values) {
        Parameter found =
                setting == null ? null : reading.findAny(setting.words()).orElse(null);
        if (setting == null || found == null) {
            return null;
        }
        double owner = owners(command, found);
        double meters = command.keeper().returnMeters(setting.meters(found.withValue(owner)));
        double wanted = setting.held(found, meters);
        if (owner != wanted || found.value() != wanted) {
            values.add(new OverriddenParameter(found.name(), owner, wanted));
        }
        return meters;
    }

    /** What the vehicle shows may be what the cloud had written earlier. */
    private static double owners(SetCloudLossAction command, Parameter shown) {
        return command.kept().stream()
                .filter(kept -> kept.name().equals(shown.name()) && kept.isAsLeft(shown.value()))
                .map(kept -> kept.putBack(shown.value()))
                .findFirst()
                .orElse(shown.value());
    }

    private static double shown(ParameterRead reading, String name) {
        return reading.findAny(List.of(name)).map(Parameter::value).orElse(Double.NaN);
    }

    private static Exchange writing(CommandContext cockpit, List<ParameterValue> values, ParameterRead reading) {
        return values.isEmpty()
                ? new ImmediateExchange(Outcome.Succeeded::new)
                : new ParameterWrite(
                        cockpit.target(),
                        cockpit.parameters().codec(),
                        values,
                        name -> reading.findAny(List.of(name)).orElse(null),
                        cockpit.observer());
    }

    /** What somebody else has changed since stays. */
    static Exchange putBack(CommandContext cockpit, RestoreParameters command) {
        ParameterRead reading = new ParameterRead(
                cockpit.target(),
                cockpit.parameters().codec(),
                command.values().stream().map(value -> List.of(value.name())).toList());
        return new ExchangeSequence(List.of(
                ExchangeSequence.Step.of(() -> reading),
                ExchangeSequence.Step.of(() -> new ImmediateExchange(() -> untold(command, reading))),
                ExchangeSequence.Step.of(() -> writing(cockpit, toPutBack(command, reading), reading)),
                ExchangeSequence.Step.of(() -> new ImmediateExchange(() -> {
                    command.keeper().skipped(others(command, reading));
                    return new Outcome.Succeeded();
                }))));
    }

    private static Outcome untold(RestoreParameters command, ParameterRead reading) {
        return command.values().stream()
                .filter(value -> reading.findAny(List.of(value.name())).isEmpty())
                .findFirst()
                .<Outcome>map(
                        value -> new Outcome.TimedOut("The vehicle did not tell its parameter " + value.name() + "."))
                .orElseGet(Outcome.Succeeded::new);
    }

    private static List<ParameterValue> toPutBack(RestoreParameters command, ParameterRead reading) {
        return command.values().stream()
                .filter(value -> value.isAsLeft(shown(reading, value.name())))
                .filter(value -> value.putBack(shown(reading, value.name())) != shown(reading, value.name()))
                .map(value -> new ParameterValue(value.name(), value.putBack(shown(reading, value.name()))))
                .toList();
    }

    private static List<ParameterValue> others(RestoreParameters command, ParameterRead reading) {
        return command.values().stream()
                .filter(value -> !value.isAsLeft(shown(reading, value.name())))
                .map(value -> new ParameterValue(value.name(), shown(reading, value.name())))
                .toList();
    }
}
