package org.dronemap.proxy.mavlink.translate;

import java.util.List;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.command.SetReturnHeight;
import org.dronemap.core.drone.ReturnHeight;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.parameter.Parameter;
import org.dronemap.core.parameter.ParameterValue;
import org.dronemap.proxy.mavlink.procedure.Exchange;
import org.dronemap.proxy.mavlink.procedure.ExchangeSequence;
import org.dronemap.proxy.mavlink.procedure.ImmediateExchange;
import org.dronemap.proxy.mavlink.procedure.ParameterRead;
import org.dronemap.proxy.mavlink.procedure.ParameterWrite;

/** Makes the exchange that sets the height at which a copter flies home, and reports the height set before. */
final class ReturnHeightExchanges {
    private ReturnHeightExchanges() {}

    /**
     * A parameter of one autopilot.
     *
     * @param perMeter in which parts of a metre it counts
     */
    record Name(String name, int perMeter) {}

    /** The names that firmware of different ages has for it; a vehicle has one of them. */
    record Setting(List<Name> names) {
        static Setting of(Name... names) {
            return new Setting(List.of(names));
        }

        List<String> words() {
            return names.stream().map(Name::name).toList();
        }

        /** In m. */
        double meters(Parameter parameter) {
            return parameter.value() / perMeter(parameter);
        }

        /** That height as the vehicle can hold it, in its own unit. */
        double held(Parameter parameter, double meters) {
            return parameter.type().held(meters * perMeter(parameter));
        }

        private int perMeter(Parameter parameter) {
            return names.stream()
                    .filter(name -> name.name().equals(parameter.name()))
                    .findFirst()
                    .orElseThrow()
                    .perMeter();
        }
    }

    static Exchange set(CommandContext cockpit, SetReturnHeight command, VehicleKind kind, Setting setting) {
        if (kind != VehicleKind.MULTICOPTER && kind != VehicleKind.HELICOPTER) {
            return BasicExchanges.refuse(OutcomeCode.NOT_SETTABLE, "How high this vehicle flies home cannot be set.");
        }
        ParameterRead reading =
                new ParameterRead(cockpit.target(), cockpit.parameters().codec(), List.of(setting.words()));
        return new ExchangeSequence(List.of(
                ExchangeSequence.Step.of(() -> reading),
                ExchangeSequence.Step.of(() -> writing(cockpit, command, setting, found(reading, setting))),
                ExchangeSequence.Step.of(() -> new ImmediateExchange(() -> {
                    Parameter before = found(reading, setting);
                    Parameter now = before.withValue(wanted(command, setting, before));
                    cockpit.news()
                            .accept(new DroneEvent.ReturnHeightSet(
                                    new ReturnHeight(setting.meters(now), setting.meters(before))));
                    return new Outcome.Succeeded();
                }))));
    }

    /** A reading that has succeeded has it: it asked for nothing else. */
    private static Parameter found(ParameterRead reading, Setting setting) {
        return reading.findAny(setting.words()).orElseThrow();
    }

    private static double wanted(SetReturnHeight command, Setting setting, Parameter before) {
        double wanted = setting.held(before, command.meters());
        return command.atLeast() ? Math.max(before.value(), wanted) : wanted;
    }

    private static Exchange writing(
            CommandContext cockpit, SetReturnHeight command, Setting setting, Parameter before) {
        double wanted = wanted(command, setting, before);
        return wanted == before.value()
                ? new ImmediateExchange(Outcome.Succeeded::new)
                : new ParameterWrite(
                        cockpit.target(),
                        cockpit.parameters().codec(),
                        List.of(new ParameterValue(before.name(), wanted)),
                        name -> before,
                        cockpit.observer());
    }
}
