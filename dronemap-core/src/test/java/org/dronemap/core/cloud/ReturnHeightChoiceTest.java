package org.dronemap.core.cloud;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class ReturnHeightChoiceTest {
    private static OptionalDouble of(double owners, Double... taken) {
        return ReturnHeightChoice.of(owners, List.of(taken), height -> true);
    }

    @Test
    void leavesWhatItsOwnerHasSetWhereNobodyElseFlies() {
        assertThat(of(15)).hasValue(15);
        assertThat(of(0)).hasValue(0);
        assertThat(of(300)).hasValue(300);
    }

    @Test
    void leavesWhatItsOwnerHasSetWhereOthersAreFarFromIt() {
        assertThat(of(15, 20.0, 10.0)).hasValue(15);
    }

    @Test
    void takesTheNextStepAboveThatIsFree() {
        assertThat(of(15, 15.0)).hasValue(20);
        assertThat(of(15, 15.0, 20.0, 25.0)).hasValue(30);
        assertThat(of(15, 12.0, 21.0)).hasValue(30);
    }

    /** One that flies home as high as it is may be at any height. */
    @Test
    void givesAHeightToOneThatFliesHomeAsHighAsItIs() {
        assertThat(of(0, 30.0)).hasValue(5);
    }

    @Test
    void staysBelowWhatAirspaceEndsAtAndWhereItMayFly() {
        Double[] all = IntStream.rangeClosed(3, 24).mapToObj(step -> step * 5.0).toArray(Double[]::new);
        assertThat(of(15, all)).isEmpty();
        assertThat(ReturnHeightChoice.of(15, List.of(15.0), height -> height <= 15))
                .isEmpty();
        assertThat(of(150, 150.0)).isEmpty();
    }
}
