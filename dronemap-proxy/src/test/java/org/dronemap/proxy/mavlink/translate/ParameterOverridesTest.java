package org.dronemap.proxy.mavlink.translate;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.SetCloudLossAction;
import org.dronemap.core.parameter.OverriddenParameter;
import org.dronemap.core.parameter.ParameterValue;
import org.junit.jupiter.api.Test;

/** What is taken for the owner's values, and what becomes of them when things go wrong. */
class ParameterOverridesTest extends CloudLossTestBench {
    @Test
    void putsBackWhatAMissionHasChangedMeanwhile() {
        isACopter();
        assertThat(set()).isEqualTo(DONE);
        held.put("FS_OPTIONS", 17.0 + 2 + 8);

        assertThat(putBack()).isEqualTo(DONE);

        assertThat(held).containsEntry("FS_OPTIONS", 1.0 + 8);
    }

    @Test
    void writesNothingBeforeTheOwnersValuesAreKept() {
        isACopter();
        keeper.kept = new CompletableFuture<>();

        assertThat(bench().perform(new SetCloudLossAction(20, List.of(), keeper), 2))
                .isNull();
        assertThat(written()).isEmpty();
    }

    @Test
    void writesNothingWhenTheyCannotBeKept() {
        isACopter();
        keeper.kept = CompletableFuture.failedFuture(new IllegalStateException("the disk is full"));

        assertThat(set()).isInstanceOf(Outcome.Failed.class);
        assertThat(written()).isEmpty();
    }

    @Test
    void doesNotTakeWhatTheCloudHadWrittenForTheOwners() {
        isACopter();
        assertThat(set()).isEqualTo(DONE);
        OverriddenParameter[] kept = keeper.plan().values().toArray(OverriddenParameter[]::new);

        assertThat(set(kept)).isEqualTo(DONE);

        assertThat(keeper.plan().values()).containsExactly(kept);
        assertThat(putBack()).isEqualTo(DONE);
        assertThat(held).containsEntry("FS_GCS_ENABLE", 0.0).containsEntry("FS_GCS_TIMEOUT", 5.0);
    }

    @Test
    void takesWhatSomebodyElseHasSetSinceForTheOwners() {
        isACopter();
        assertThat(set()).isEqualTo(DONE);
        OverriddenParameter[] kept = keeper.plan().values().toArray(OverriddenParameter[]::new);
        held.put("FS_GCS_TIMEOUT", 8.0);

        assertThat(set(kept)).isEqualTo(DONE);

        assertThat(keeper.plan().values()).contains(new OverriddenParameter("FS_GCS_TIMEOUT", 8, 20));
    }

    @Test
    void leavesWhatSomebodyElseHasSetSinceAndTellsSo() {
        isACopter();
        assertThat(set()).isEqualTo(DONE);
        held.put("FS_GCS_TIMEOUT", 8.0);

        assertThat(putBack()).isEqualTo(DONE);

        assertThat(held).containsEntry("FS_GCS_TIMEOUT", 8.0).containsEntry("FS_GCS_ENABLE", 0.0);
        assertThat(keeper.left).containsExactly(new ParameterValue("FS_GCS_TIMEOUT", 8));
    }

    @Test
    void putsBackWhatWasWrittenWhenThePowerIsLostInTheMiddle() {
        isACopter();
        powerLostAfter = 1;

        assertThat(set()).isNotEqualTo(DONE);
        assertThat(held).containsEntry("FS_GCS_ENABLE", 1.0).containsEntry("FS_GCS_TIMEOUT", 5.0);
        powerLostAfter = Integer.MAX_VALUE;

        assertThat(putBack()).isEqualTo(DONE);
        assertThat(held).containsEntry("FS_GCS_ENABLE", 0.0).containsEntry("FS_GCS_TIMEOUT", 5.0);
    }

    @Test
    void refusesWhereThereIsNothingToSet() {
        bench(SUB);

        assertThat(set()).isInstanceOf(Outcome.Refused.class);
        assertThat(bench().wire.sent()).isEmpty();
    }

    @Test
    void isNotHeldUpForLongByAVehicleThatTellsNothing() {
        bench(AutopilotTestBench.ARDUCOPTER);

        assertThat(bench().perform(new SetCloudLossAction(20, List.of(), keeper), 4))
                .isInstanceOf(Outcome.TimedOut.class);
    }
}
