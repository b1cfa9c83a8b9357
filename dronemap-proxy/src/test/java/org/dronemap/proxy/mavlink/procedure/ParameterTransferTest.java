package org.dronemap.proxy.mavlink.procedure;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.atomic.AtomicBoolean;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.parameter.Parameter;
import org.dronemap.core.parameter.ParameterType;
import org.dronemap.core.parameter.ParameterValue;
import org.dronemap.mavlink.message.ParamRequestList;
import org.dronemap.mavlink.message.ParamRequestRead;
import org.dronemap.mavlink.message.ParamSet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ParameterTransferTest {
    private static final Outcome DONE = new Outcome.Succeeded();

    private final TestWire wire = new TestWire();

    private ParameterDownload listing(ParameterVehicle vehicle) {
        wire.peer(vehicle::take);
        return new ParameterDownload(wire.target(), vehicle.codec, ExchangeObserver.NONE);
    }

    private ParameterWrite writing(ParameterVehicle vehicle, List<ParameterValue> values) {
        wire.peer(vehicle::take);
        return new ParameterWrite(wire.target(), vehicle.codec, values, vehicle.held::get, ExchangeObserver.NONE);
    }

    private static ParameterValue to(String name, double value) {
        return new ParameterValue(name, value);
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void readsAThousandThoughATenthIsLostEachWay(boolean bytewise) {
        ParameterVehicle vehicle = ParameterVehicle.with(1000, bytewise);
        wire.lossy(0.1, new Random(5));
        ParameterDownload listing = listing(vehicle);

        assertThat(wire.runWhole(listing)).isEqualTo(DONE);
        assertThat(listing.parameters()).containsExactlyElementsOf(vehicle.held.values());
        assertThat(wire.sent(ParamRequestList.class)).hasSizeLessThan(4);
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void writesAThousandThoughATenthIsLostEachWay(boolean bytewise) {
        ParameterVehicle vehicle = ParameterVehicle.with(1000, bytewise);
        List<ParameterValue> values = new ArrayList<>();
        vehicle.held
                .values()
                .forEach(held -> values.add(to(held.name(), held.type().held(held.value() - 700))));
        wire.lossy(0.1, new Random(6));

        assertThat(wire.runWhole(writing(vehicle, values))).isEqualTo(DONE);
        assertThat(vehicle.held.values())
                .extracting(Parameter::value)
                .containsExactlyElementsOf(
                        values.stream().map(ParameterValue::value).toList());
    }

    @Test
    void asksOnlyForTheGapsOfAList() {
        ParameterVehicle vehicle = ParameterVehicle.with(50, false);
        wire.fault(MessageFault.LOST, 8);

        assertThat(wire.runWhole(listing(vehicle))).isEqualTo(DONE);
        assertThat(wire.sent(ParamRequestRead.class))
                .extracting(ParamRequestRead::paramIndex)
                .containsExactly(7);
    }

    @Test
    void goesOnWhereItWasAfterABreakOfTheLink() {
        ParameterVehicle vehicle = ParameterVehicle.with(300, false);
        List<ParameterValue> values =
                vehicle.held.keySet().stream().map(name -> to(name, 7)).toList();
        ParameterWrite writing = writing(vehicle, values);
        writing.start(wire.now());
        wire.run(writing, 0.1);
        wire.cut(true);
        assertThat(wire.run(writing, 40)).isNull();
        wire.cut(false);

        assertThat(wire.run(writing, 60)).isEqualTo(DONE);
        assertThat(vehicle.held.values()).extracting(Parameter::value).containsOnly(7.0);
    }

    @Test
    void givesUpAfterABreakThatIsTooLong() {
        ParameterVehicle vehicle = ParameterVehicle.with(300, false);
        ParameterDownload listing = listing(vehicle);
        wire.lossy(0.5, new Random(3));
        listing.start(wire.now());
        wire.run(listing, 0.1);
        wire.cut(true);

        assertThat(wire.run(listing, 70)).isInstanceOf(Outcome.TimedOut.class);
    }

    @Test
    void saysThatAVehicleMayNotHaveAParameterAndChangesNothing() {
        ParameterVehicle vehicle = ParameterVehicle.with(3, false);
        ParameterWrite writing = writing(vehicle, List.of(to("P_1", 9), to("NOBODY", 1)));
        wire.chatter(true);

        Outcome outcome = wire.runWhole(writing);

        assertThat(outcome).isInstanceOf(Outcome.TimedOut.class).asString().contains("NOBODY", "Nothing was changed");
        assertThat(wire.sent(ParamSet.class)).isEmpty();
    }

    @Test
    void saysWhatTheVehicleHoldsWhenItSilentlyKeptSomethingElse() {
        ParameterVehicle vehicle = ParameterVehicle.with(9, false);
        vehicle.altered = "P_4";

        assertThat(wire.runWhole(writing(vehicle, List.of(to("P_3", 1.5), to("P_4", 20)))))
                .isEqualTo(new Outcome.Failed("The vehicle holds P_4 = 21, not 20."));
    }

    @Test
    void takesAnEchoOfTheWritingForNoReading() {
        ParameterVehicle vehicle = ParameterVehicle.with(9, false);
        vehicle.altered = "P_4";
        ParameterWrite writing = writing(vehicle, List.of(to("P_4", 20)));
        AtomicBoolean lost = new AtomicBoolean();
        wire.peer((w, message) -> {
            if (!(message instanceof ParamRequestRead) || lost.getAndSet(true)) {
                vehicle.take(w, message);
            }
        });
        // The vehicle's answer to the writing comes once more when it may be read already.
        wire.fault(MessageFault.DOUBLED, 1);

        assertThat(wire.runWhole(writing)).isEqualTo(new Outcome.Failed("The vehicle holds P_4 = 21, not 20."));
    }

    @Test
    void takesTheRoundingOfTheWireForNoDifference() {
        ParameterVehicle vehicle = new ParameterVehicle(false);
        vehicle.held.put("BIG", new Parameter("BIG", ParameterType.INT32, 0));
        vehicle.held.put("TENTH", new Parameter("TENTH", ParameterType.REAL32, 0));

        assertThat(wire.runWhole(writing(vehicle, List.of(to("BIG", 16_777_217), to("TENTH", 0.1)))))
                .isEqualTo(DONE);
    }

    @ParameterizedTest
    @ValueSource(doubles = {-1, 0, 1, 2_147_483_647, -2_147_483_648})
    void carriesWholeNumbersByTheirBits(double value) {
        ParameterVehicle vehicle = new ParameterVehicle(true);
        vehicle.held.put("WHOLE", new Parameter("WHOLE", ParameterType.INT32, 5));

        assertThat(wire.runWhole(writing(vehicle, List.of(to("WHOLE", value))))).isEqualTo(DONE);
        assertThat(vehicle.held.get("WHOLE")).isEqualTo(new Parameter("WHOLE", ParameterType.INT32, value));
    }
}
