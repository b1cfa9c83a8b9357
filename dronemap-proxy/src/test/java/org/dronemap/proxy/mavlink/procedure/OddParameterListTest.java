package org.dronemap.proxy.mavlink.procedure;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.parameter.Parameter;
import org.dronemap.mavlink.message.ParamRequestList;
import org.dronemap.mavlink.message.ParamRequestRead;
import org.dronemap.mavlink.message.ParamValue;
import org.junit.jupiter.api.Test;

/** Lists of parameters that are numbered, counted or named in an odd way: none is dropped in silence. */
class OddParameterListTest {
    private static final Outcome DONE = new Outcome.Succeeded();
    private static final int NO_INDEX = 65_535;
    private static final int REAL32 = 9;

    private final TestWire wire = new TestWire();

    private ParameterDownload listing() {
        return new ParameterDownload(wire.target(), new ParameterCodec(false), ExchangeObserver.NONE);
    }

    private void says(String name, double value, int count, int index) {
        wire.answer(new ParamValue(name, (float) value, REAL32, count, index));
    }

    /** Answers to the list, and to questions for one, with those of these names that may be told. */
    private void vehicle(List<String> names) {
        wire.peer((w, message) -> {
            if (message instanceof ParamRequestList) {
                for (int index = 0; index < names.size(); index++) {
                    says(names.get(index), index, names.size(), index);
                }
            } else if (message instanceof ParamRequestRead read && read.paramIndex() < names.size()) {
                says(names.get(read.paramIndex()), read.paramIndex(), names.size(), read.paramIndex());
            }
        });
    }

    private static List<String> names(ParameterDownload listing) {
        return listing.parameters().stream().map(Parameter::name).toList();
    }

    @Test
    void ofSeveralWithOneNameTheLastIsShownAndTheNameTold() {
        vehicle(List.of("A", "B", "A", "C"));
        ParameterDownload listing = listing();

        assertThat(wire.runWhole(listing)).isEqualTo(DONE);
        assertThat(listing.parameters()).extracting(Parameter::value).containsExactly(2.0, 1.0, 3.0);
        assertThat(listing.incomplete()).get().asString().contains("3 of 4", "several that are called A;");
    }

    @Test
    void twoWithOneNumberAreBothTaken() {
        wire.peer((w, message) -> {
            if (message instanceof ParamRequestList) {
                says("A", 0, 3, 0);
                says("B", 1, 3, 1);
                says("C", 2, 3, 1);
            }
        });
        ParameterDownload listing = listing();

        assertThat(wire.runWhole(listing)).isEqualTo(DONE);
        assertThat(names(listing)).containsExactlyInAnyOrder("A", "B", "C");
        assertThat(listing.incomplete()).isEmpty();
    }

    @Test
    void aCountThatChangesWhileListingHasAllReadAnew() {
        List<String> names = new ArrayList<>(List.of("A", "B", "C", "D", "E", "F"));
        vehicle(names);
        ParameterDownload listing = listing();
        wire.fault(MessageFault.LOST, 6);
        listing.start(wire.now());
        wire.run(listing, 0.05);
        names.add(2, "NEW");

        assertThat(wire.run(listing, 30)).isEqualTo(DONE);
        assertThat(names(listing)).containsExactlyElementsOf(names);
    }

    @Test
    void aListWithoutNumbersIsWholeWhenItHasAsManyNamesAsItCounts() {
        wire.peer((w, message) -> {
            if (message instanceof ParamRequestList) {
                says("A", 0, 2, NO_INDEX);
                says("B", 1, 2, NO_INDEX);
            }
        });
        ParameterDownload listing = listing();

        assertThat(wire.runWhole(listing)).isEqualTo(DONE);
        assertThat(names(listing)).containsExactly("A", "B");
    }

    @Test
    void aListWithoutNumbersThatMayNotBeWholeIsToldSo() {
        wire.chatter(true);
        wire.peer((w, message) -> {
            if (message instanceof ParamRequestList) {
                says("A", 0, 3, NO_INDEX);
            }
        });

        assertThat(wire.runWhole(listing()))
                .isInstanceOf(Outcome.TimedOut.class)
                .asString()
                .contains("without their numbers; 1 different");
    }

    /** One that is told by itself, and is not in the list, fills no hole. */
    @Test
    void oneWithoutANumberFillsNoHole() {
        wire.chatter(true);
        says("STAT_RUNTIME", 5, 3, NO_INDEX);
        wire.peer((w, message) -> {
            if (message instanceof ParamRequestList) {
                says("STAT_RUNTIME", 5, 3, NO_INDEX);
                says("A", 0, 3, 0);
                says("STAT_RUNTIME", 6, 3, NO_INDEX);
                says("C", 2, 3, 2);
            }
        });
        ParameterDownload listing = listing();

        assertThat(wire.runWhole(listing)).isEqualTo(DONE);
        assertThat(names(listing)).containsExactly("A", "C");
        assertThat(listing.incomplete()).get().asString().contains("2 of 3", "number 1 (after A)");
    }
}
