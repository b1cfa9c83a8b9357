package org.dronemap.proxy.mavlink.procedure;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.IntPredicate;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.parameter.Parameter;
import org.dronemap.core.parameter.ParameterType;
import org.dronemap.core.parameter.ParameterValue;
import org.dronemap.mavlink.message.ParamRequestList;
import org.dronemap.mavlink.message.ParamRequestRead;
import org.dronemap.mavlink.message.ParamSet;
import org.dronemap.mavlink.message.ParamValue;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
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

        assertThat(wire.runWhole(writing(vehicle, List.of(to("BIG", 16_777_216), to("TENTH", 0.1)))))
                .isEqualTo(DONE);
    }

    @ParameterizedTest
    @CsvSource({
        "false, INT32, 16777217, 16777216",
        "false, UINT32, 4294967295, 4294967296",
        "true, UINT8, 300, 44",
        "true, INT64, 4294967297, 1"
    })
    void sendsNoWholeNumberThatWouldArriveAsAnother(boolean bytewise, ParameterType type, double wanted, String told) {
        ParameterVehicle vehicle = new ParameterVehicle(bytewise);
        vehicle.held.put("BITS", new Parameter("BITS", type, 33));
        vehicle.held.put("OTHER", new Parameter("OTHER", ParameterType.REAL32, 1));

        assertThat(wire.runWhole(writing(vehicle, List.of(to("OTHER", 2), to("BITS", wanted)))))
                .isEqualTo(new Outcome.Failed("BITS cannot be set to " + (long) wanted
                        + ": on the way to this vehicle it would become " + told
                        + ". The vehicle holds BITS = 33; nothing was changed."));
        assertThat(wire.sent(ParamSet.class)).isEmpty();
    }

    @Test
    void sendsNoBitsThatWouldArriveAsOthers() {
        ParameterVehicle vehicle = new ParameterVehicle(false);
        vehicle.held.put("BITS", new Parameter("BITS", ParameterType.INT32, 1 << 28));
        wire.peer(vehicle::take);

        assertThat(wire.runWhole(new ParameterUpdateExchange(
                        wire.target(), new ParameterUpdateExchange.Wanted("BITS", now -> now | 1, false))))
                .isEqualTo(new Outcome.Failed("BITS cannot be set to 268435457: on the way to this vehicle it would"
                        + " become 268435456. The vehicle holds 268435456; nothing was changed."));
        assertThat(wire.sent(ParamSet.class)).isEmpty();
    }

    private ParameterDownload withHoles(int count, IntPredicate hole) {
        ParameterVehicle vehicle = ParameterVehicle.with(count, false);
        List<Parameter> all = List.copyOf(vehicle.held.values());
        wire.chatter(true);
        wire.peer((w, message) -> {
            for (int index = 0; index < count; index++) {
                boolean asked = message instanceof ParamRequestList
                        || (message instanceof ParamRequestRead read && read.paramIndex() == index);
                if (asked && !hole.test(index)) {
                    Parameter one = all.get(index);
                    w.answer(new ParamValue(
                            one.name(), (float) one.value(), ParameterCodec.number(one.type()), count, index));
                }
            }
        });
        return new ParameterDownload(wire.target(), new ParameterCodec(false), ExchangeObserver.NONE);
    }

    @Test
    void oneThatIsNeverToldLeavesTheOthersUsable() {
        ParameterDownload listing = withHoles(60, index -> index == 17);
        listing.start(wire.now());

        assertThat(wire.run(listing, 20)).isEqualTo(DONE);
        assertThat(listing.parameters()).hasSize(59);
        assertThat(listing.incomplete())
                .contains("59 of 60 parameters were read and can be used. The vehicle did not tell number 17 (after"
                        + " P_16), counted from 0, though it was asked for it again and again.");
    }

    @Test
    void manyThatAreNeverToldDoNotHoldUpTheOthers() {
        ParameterDownload listing = withHoles(200, index -> index % 4 == 0);
        listing.start(wire.now());

        assertThat(wire.run(listing, 40)).isEqualTo(DONE);
        assertThat(listing.parameters()).hasSize(150);
        assertThat(listing.incomplete()).get().asString().contains("150 of 200", "number 0 (before P_1), 4", "47 more");
    }

    @Test
    void lessThanHalfIsNoList() {
        ParameterDownload listing = withHoles(60, index -> index > 20);

        assertThat(wire.runWhole(listing)).isInstanceOf(Outcome.TimedOut.class);
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
