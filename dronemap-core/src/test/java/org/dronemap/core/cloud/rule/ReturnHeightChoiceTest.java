package org.dronemap.core.cloud.rule;

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
    void leavesWhatItsOwnerHasSetAboveWhatIsUsuallyFlownWhereOthersAreFarFromIt() {
        assertThat(of(35, 40.0, 30.0)).hasValue(35);
        assertThat(of(35, 15.0)).hasValue(35);
    }

    @Test
    void takesTheNextStepAboveThatIsFree() {
        assertThat(of(35, 35.0)).hasValue(40);
        assertThat(of(35, 35.0, 40.0, 45.0)).hasValue(50);
        assertThat(of(35, 32.0, 41.0)).hasValue(50);
    }

    /** Those that fly above their return height come home as high as they fly. */
    @Test
    void begins30MetresUpForAllButTheFirst() {
        assertThat(of(15, 15.0)).hasValue(30);
        assertThat(of(15, 60.0)).hasValue(30);
        assertThat(of(15, 15.0, 30.0, 35.0)).hasValue(40);
    }

    @Test
    void goesBelowThatRatherThanAcrossAnothersWay() {
        assertThat(ReturnHeightChoice.of(15, List.of(20.0), height -> height < 30))
                .hasValue(15);
        assertThat(ReturnHeightChoice.of(15, List.of(15.0, 20.0), height -> height < 30))
                .hasValue(25);
    }

    /** One that flies home as high as it is may be at any height. */
    @Test
    void givesAHeightToOneThatFliesHomeAsHighAsItIs() {
        assertThat(of(0, 30.0)).hasValue(35);
        assertThat(of(0, 5.0)).hasValue(30);
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
