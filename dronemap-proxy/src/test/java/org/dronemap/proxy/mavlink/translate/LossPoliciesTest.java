package org.dronemap.proxy.mavlink.translate;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.CompletableFuture;
import org.dronemap.core.command.CloudLoss;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OwnersKeeper;
import org.dronemap.core.command.PutBack;
import org.dronemap.core.command.SetCloudLoss;
import org.dronemap.core.parameter.OwnersValue;
import org.dronemap.core.parameter.ParameterValue;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.ParamRequestRead;
import org.dronemap.mavlink.message.ParamSet;
import org.dronemap.mavlink.message.ParamValue;
import org.dronemap.proxy.mavlink.procedure.Wire;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

/** What each kind of vehicle is set to, read back, and given back as its owner had it. */
class LossPoliciesTest {
    private static final Outcome DONE = new Outcome.Succeeded();
    private static final Heartbeat PLANE = new Heartbeat(1, 3, 81, 0, 3, 3);
    private static final Heartbeat ROVER = new Heartbeat(10, 3, 81, 0, 3, 3);
    private static final Heartbeat SUB = new Heartbeat(12, 3, 81, 0, 3, 3);
    private static final int INT32 = 6;
    private static final int REAL32 = 9;

    /** As the vehicle holds them; those of PX4 that are whole numbers travel as their bits. */
    private final Map<String, Double> held = new LinkedHashMap<>();

    private final Map<String, Integer> types = new HashMap<>();
    private final Keeper keeper = new Keeper();
    private boolean bytewise;
    private int powerLostAfter = Integer.MAX_VALUE;
    private int sets;
    private @Nullable PlanBench bench;

    /** Remembers what it was told, and says when that is kept. */
    private static final class Keeper implements OwnersKeeper {
        private CompletableFuture<Void> kept = CompletableFuture.completedFuture(null);
        private double meters = Double.NaN;
        private final List<ParameterValue> left = new ArrayList<>();
        private @Nullable Plan plan;

        @Override
        public double returnMeters(double owners) {
            return Double.isNaN(meters) ? owners : meters;
        }

        @Override
        public CompletableFuture<Void> keep(Plan found) {
            plan = found;
            return kept;
        }

        @Override
        public void leftAlone(List<ParameterValue> shown) {
            left.addAll(shown);
        }

        Plan plan() {
            return Objects.requireNonNull(plan);
        }
    }

    private void has(String name, int type, double value) {
        held.put(name, value);
        types.put(name, type);
    }

    private PlanBench bench(Heartbeat heartbeat) {
        PlanBench made = new PlanBench(heartbeat);
        made.wire.peer(this::vehicle);
        bench = made;
        return made;
    }

    private void vehicle(Wire wire, Message message) {
        if (message instanceof ParamSet set && sets++ < powerLostAfter && held.containsKey(set.paramId())) {
            held.put(set.paramId(), decoded(set.paramId(), set.paramValue()));
            tell(wire, set.paramId());
        } else if (message instanceof ParamRequestRead question
                && sets <= powerLostAfter
                && held.containsKey(question.paramId())) {
            tell(wire, question.paramId());
        }
    }

    private void tell(Wire wire, String name) {
        wire.answer(new ParamValue(name, encoded(name), types.getOrDefault(name, REAL32), 900, 1));
    }

    private boolean asBits(String name) {
        return bytewise && types.getOrDefault(name, REAL32) == INT32;
    }

    private float encoded(String name) {
        double value = held.getOrDefault(name, 0.0);
        return asBits(name) ? Float.intBitsToFloat((int) value) : (float) value;
    }

    private double decoded(String name, float raw) {
        return asBits(name) ? Float.floatToRawIntBits(raw) : raw;
    }

    private @Nullable Outcome set(OwnersValue... kept) {
        return bench().perform(new SetCloudLoss(20, List.of(kept), keeper));
    }

    private @Nullable Outcome putBack() {
        return bench().perform(new PutBack(keeper.plan().values(), keeper));
    }

    private PlanBench bench() {
        return Objects.requireNonNull(bench);
    }

    private List<String> written() {
        return bench().wire.sent(ParamSet.class).stream()
                .map(ParamSet::paramId)
                .distinct()
                .sorted()
                .toList();
    }

    private void isACopter() {
        has("FS_GCS_ENABLE", INT32, 0);
        has("FS_GCS_TIMEOUT", REAL32, 5);
        has("FS_OPTIONS", INT32, 1);
        has("FS_THR_ENABLE", INT32, 1);
        has("RTL_ALT", INT32, 1_500);
        bench(PlanBench.ARDUCOPTER);
    }

    private void isAPlane(double enabled, double action, double seconds) {
        has("FS_GCS_ENABL", INT32, enabled);
        has("FS_LONG_ACTN", INT32, action);
        has("FS_LONG_TIMOUT", REAL32, seconds);
        has("THR_FAILSAFE", INT32, 1);
        bench(PLANE);
    }

    private void isARover() {
        has("FS_GCS_ENABLE", INT32, 0);
        has("FS_GCS_TIMEOUT", REAL32, 5);
        has("FS_ACTION", INT32, 0);
        has("FS_THR_ENABLE", INT32, 1);
        bench(ROVER);
    }

    private void isPx4() {
        bytewise = true;
        has("NAV_DLL_ACT", INT32, 0);
        has("COM_DL_LOSS_T", INT32, 10);
        has("COM_DLL_EXCEPT", INT32, 0);
        has("NAV_RCL_ACT", INT32, 2);
        has("RTL_RETURN_ALT", REAL32, 30.5);
        bench(PlanBench.PX4);
    }

    /** It is set, and then everything is again as it was. */
    private void isSetAndPutBack() {
        Map<String, Double> before = Map.copyOf(held);
        assertThat(set()).isEqualTo(DONE);
        assertThat(held).isNotEqualTo(before);
        assertThat(putBack()).isEqualTo(DONE);
        assertThat(held).isEqualTo(before);
        assertThat(keeper.left).isEmpty();
    }

    @Test
    void setsACopterAndNothingOfItsRemoteControl() {
        isACopter();
        keeper.meters = 20;

        assertThat(set()).isEqualTo(DONE);

        assertThat(held)
                .containsEntry("FS_GCS_ENABLE", 1.0)
                .containsEntry("FS_GCS_TIMEOUT", 20.0)
                .containsEntry("FS_OPTIONS", 17.0)
                .containsEntry("FS_THR_ENABLE", 1.0)
                .containsEntry("RTL_ALT", 2_000.0);
        assertThat(written()).containsExactly("FS_GCS_ENABLE", "FS_GCS_TIMEOUT", "FS_OPTIONS", "RTL_ALT");
        assertThat(keeper.plan().before().sentence())
                .isEqualTo("When it does not hear the cloud any more, it goes on.");
        assertThat(keeper.plan().after().sentence())
                .isEqualTo("When it does not hear the cloud any more, it returns home after 20 s.");
    }

    @Test
    void putsACopterBack() {
        isACopter();
        keeper.meters = 20;
        isSetAndPutBack();
    }

    @Test
    void putsBackWhatAMissionHasChangedMeanwhile() {
        isACopter();
        assertThat(set()).isEqualTo(DONE);
        held.put("FS_OPTIONS", 17.0 + 2 + 8);

        assertThat(putBack()).isEqualTo(DONE);

        assertThat(held).containsEntry("FS_OPTIONS", 1.0 + 8);
    }

    @Test
    void leavesWhatACopterDoesAlready() {
        isACopter();
        has("FS_GCS_ENABLE", INT32, 5);
        assertThat(set()).isEqualTo(DONE);

        assertThat(held).containsEntry("FS_GCS_ENABLE", 5.0);
        assertThat(keeper.plan().after().action()).isEqualTo("it lands");
    }

    @Test
    void tellsTheTimeOfFirmwareThatCannotBeToldOne() {
        isACopter();
        held.remove("FS_GCS_TIMEOUT");

        assertThat(set()).isEqualTo(DONE);

        assertThat(keeper.plan().after().sentence())
                .isEqualTo(
                        "When it does not hear the cloud any more, it returns home after 5 s. Its time cannot be set.");
    }

    @Test
    void writesNothingBeforeTheOwnersValuesAreKept() {
        isACopter();
        keeper.kept = new CompletableFuture<>();

        assertThat(bench().perform(new SetCloudLoss(20, List.of(), keeper), 2)).isNull();
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
        OwnersValue[] kept = keeper.plan().values().toArray(OwnersValue[]::new);

        assertThat(set(kept)).isEqualTo(DONE);

        assertThat(keeper.plan().values()).containsExactly(kept);
        assertThat(putBack()).isEqualTo(DONE);
        assertThat(held).containsEntry("FS_GCS_ENABLE", 0.0).containsEntry("FS_GCS_TIMEOUT", 5.0);
    }

    @Test
    void takesWhatSomebodyElseHasSetSinceForTheOwners() {
        isACopter();
        assertThat(set()).isEqualTo(DONE);
        OwnersValue[] kept = keeper.plan().values().toArray(OwnersValue[]::new);
        held.put("FS_GCS_TIMEOUT", 8.0);

        assertThat(set(kept)).isEqualTo(DONE);

        assertThat(keeper.plan().values()).contains(new OwnersValue("FS_GCS_TIMEOUT", 8, 20));
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
    void makesAPlaneStricterOnlyAndSaysWhatElseThatMeans() {
        isAPlane(0, 0, 30);

        assertThat(set()).isEqualTo(DONE);

        assertThat(held)
                .containsEntry("FS_GCS_ENABL", 1.0)
                .containsEntry("FS_LONG_ACTN", 1.0)
                .containsEntry("FS_LONG_TIMOUT", 20.0)
                .containsEntry("THR_FAILSAFE", 1.0);
        assertThat(keeper.plan().after().sentence())
                .isEqualTo(
                        "When it does not hear the cloud any more, it returns home after 20 s. It lands there only by a landing"
                                + " sequence of its mission (DO_LAND_START), else it circles."
                                + " It does the same when it loses its remote control.");
    }

    @Test
    void hasAPlaneLandAtHomeWhereItsMissionLetsIt() {
        isAPlane(1, 1, 5);
        has("RTL_AUTOLAND", INT32, 0);

        isSetAndPutBack();
        assertThat(written()).containsExactly("RTL_AUTOLAND");
    }

    @Test
    void hasAQuadPlaneLandOnItsRotors() {
        isAPlane(1, 1, 5);
        has("Q_RTL_MODE", INT32, 0);
        bench(new Heartbeat(22, 3, 81, 0, 3, 3));

        assertThat(set()).isEqualTo(DONE);
        assertThat(held).containsEntry("Q_RTL_MODE", 1.0);
        assertThat(keeper.plan().after().sentence())
                .isEqualTo("When it does not hear the cloud any more, it returns home after 5 s.");
    }

    @Test
    void neverRaisesTheTimeThatAPlaneWaitsForItsRemoteControl() {
        isAPlane(3, 2, 1.5);

        assertThat(set()).isEqualTo(DONE);

        assertThat(held).containsEntry("FS_LONG_TIMOUT", 1.5).containsEntry("FS_LONG_ACTN", 2.0);
        assertThat(written()).containsExactly("FS_GCS_ENABL");
        assertThat(keeper.plan().after().sentence())
                .isEqualTo("When it does not hear the cloud any more, it glides down after 1.5 s.");
    }

    @Test
    void putsAPlaneBack() {
        isAPlane(0, 0, 30);
        isSetAndPutBack();
    }

    @Test
    void knowsHowNewerPlanesCallIt() {
        isAPlane(1, 1, 30);
        held.remove("FS_LONG_TIMOUT");
        has("FS_LONG_TIMEOUT", REAL32, 30);

        isSetAndPutBack();
        assertThat(written()).containsExactly("FS_LONG_TIMEOUT");
    }

    @Test
    void setsARoverAndPutsItBack() {
        isARover();
        assertThat(set()).isEqualTo(DONE);
        assertThat(held)
                .containsEntry("FS_GCS_ENABLE", 1.0)
                .containsEntry("FS_GCS_TIMEOUT", 20.0)
                .containsEntry("FS_ACTION", 1.0)
                .containsEntry("FS_THR_ENABLE", 1.0);

        assertThat(putBack()).isEqualTo(DONE);
        assertThat(held).containsEntry("FS_GCS_ENABLE", 0.0).containsEntry("FS_ACTION", 0.0);
    }

    @Test
    void leavesARoverThatStopsAndGoesOnWithItsMission() {
        isARover();
        has("FS_ACTION", INT32, 2);
        has("FS_GCS_ENABLE", INT32, 2);

        assertThat(set()).isEqualTo(DONE);

        assertThat(written()).containsExactly("FS_GCS_TIMEOUT");
        assertThat(keeper.plan().after().sentence())
                .isEqualTo("When it does not hear the cloud any more, it stops after 20 s. On a mission it goes on.");
    }

    @Test
    void setsPx4AndPutsItBackToTheBit() {
        isPx4();
        keeper.meters = 35.5;

        assertThat(set()).isEqualTo(DONE);
        assertThat(held)
                .containsEntry("NAV_DLL_ACT", 2.0)
                .containsEntry("COM_DL_LOSS_T", 20.0)
                .containsEntry("RTL_RETURN_ALT", 35.5)
                .containsEntry("NAV_RCL_ACT", 2.0);
        // As the start of a mission does.
        held.put("COM_DLL_EXCEPT", 1.0);

        assertThat(putBack()).isEqualTo(DONE);
        assertThat(held)
                .containsEntry("NAV_DLL_ACT", 0.0)
                .containsEntry("COM_DL_LOSS_T", 10.0)
                .containsEntry("COM_DLL_EXCEPT", 0.0)
                .containsEntry("RTL_RETURN_ALT", 30.5);
    }

    @Test
    void refusesWhereThereIsNothingToSet() {
        bench(SUB);

        assertThat(set()).isInstanceOf(Outcome.Refused.class);
        assertThat(bench().wire.sent()).isEmpty();
    }

    @Test
    void isNotHeldUpForLongByAVehicleThatTellsNothing() {
        bench(PlanBench.ARDUCOPTER);

        assertThat(bench().perform(new SetCloudLoss(20, List.of(), keeper), 4)).isInstanceOf(Outcome.TimedOut.class);
    }

    @Test
    void startsTheMissionOfAPlaneAndWritesNothingOfItsRemoteControl() {
        isAPlane(1, 1, 5);

        bench().perform(new Command.StartMission(CloudLoss.CONTINUE), 3);

        assertThat(written()).isEmpty();
    }

    @Test
    void saysOnlyWhatIsAboutMissionsWhenOneIsStarted() {
        isACopter();

        bench().perform(new Command.StartMission(CloudLoss.CONTINUE), 3);

        assertThat(written()).containsExactly("FS_OPTIONS");
        assertThat(held).containsEntry("FS_OPTIONS", 3.0);
    }
}
