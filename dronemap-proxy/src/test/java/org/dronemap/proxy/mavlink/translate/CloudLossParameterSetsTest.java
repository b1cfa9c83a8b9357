package org.dronemap.proxy.mavlink.translate;

import static org.assertj.core.api.Assertions.assertThat;

import org.dronemap.core.command.Command;
import org.dronemap.core.command.MissionCloudLossPolicy;
import org.dronemap.core.drone.CloudLossAction;
import org.dronemap.mavlink.message.Heartbeat;
import org.junit.jupiter.api.Test;

/** What each kind of vehicle is set to, read back, and given back as its owner had it. */
class CloudLossParameterSetsTest extends CloudLossTestBench {
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
    void knowsThatNewerCoptersCountTheirReturnHeightInMetres() {
        isACopter();
        held.remove("RTL_ALT");
        has("RTL_ALT_M", REAL32, 15.5);
        keeper.meters = 20.5;

        assertThat(set()).isEqualTo(DONE);
        assertThat(held).containsEntry("RTL_ALT_M", 20.5);
        assertThat(keeper.asked).isEqualTo(15.5);
        assertThat(keeper.plan().returnMeters()).isEqualTo(20.5);
        assertThat(written()).contains("RTL_ALT_M").doesNotContain("RTL_ALT");

        assertThat(putBack()).isEqualTo(DONE);
        assertThat(held).containsEntry("RTL_ALT_M", 15.5);
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
    void makesAPlaneStricterOnlyAndSaysWhatElseThatMeans() {
        isAPlane(0, 0, 30);

        assertThat(set()).isEqualTo(DONE);

        assertThat(held)
                .containsEntry("FS_GCS_ENABL", 1.0)
                .containsEntry("FS_LONG_ACTN", 1.0)
                .containsEntry("FS_LONG_TIMOUT", 20.0)
                .containsEntry("THR_FAILSAFE", 1.0);
        assertThat(keeper.plan().after().sentence())
                .isEqualTo("When it does not hear the cloud any more, it returns home after 20 s."
                        + " It does the same when it loses its remote control.");
        assertThat(keeper.plan().after().atHome())
                .as("its mission says whether it lands there")
                .isEqualTo(CloudLossAction.AtHome.BY_MISSION);
    }

    @Test
    void hasAPlaneLandAtHomeWhereItsMissionLetsIt() {
        isAPlane(1, 1, 5);
        has("RTL_AUTOLAND", INT32, 0);

        isSetAndPutBack();
        assertThat(written()).containsExactly("RTL_AUTOLAND");
        assertThat(keeper.plan().before().sentence())
                .isEqualTo("When it does not hear the cloud any more, it returns home after 5 s."
                        + " By RTL_AUTOLAND it does not land there by itself, whatever its mission: it circles.");
        assertThat(keeper.plan().after().atHome()).isEqualTo(CloudLossAction.AtHome.BY_MISSION);
    }

    @Test
    void leavesAPlaneThatLandsByItsMissionOnlyToGoAroundAndSaysThatItCircles() {
        isAPlane(1, 1, 5);
        has("RTL_AUTOLAND", INT32, 3);

        assertThat(set()).isEqualTo(DONE);

        assertThat(written()).isEmpty();
        assertThat(keeper.plan().after().atHome()).isEqualTo(CloudLossAction.AtHome.AS_SAID);
        assertThat(keeper.plan().after().note()).contains("it does not land there by itself, whatever its mission");
    }

    @Test
    void saysOfAPlaneWithRotorsThatItsOwnerHasSetHowItLands() {
        isAPlane(1, 1, 5);
        has("Q_ENABLE", INT32, 1);

        assertThat(set()).isEqualTo(DONE);

        assertThat(written()).isEmpty();
        assertThat(keeper.plan().after().atHome()).isEqualTo(CloudLossAction.AtHome.BY_ITSELF);
        assertThat(keeper.plan().after().note())
                .isEqualTo("Whether it lands there on its rotors is as its owner has set Q_RTL_MODE.");
    }

    /** As long as its owner has not set Q_MAV_TYPE. */
    @Test
    void hasAQuadPlaneThatSaysItIsAFixedWingLandOnItsRotors() {
        isAPlane(1, 1, 5);
        has("Q_ENABLE", INT32, 1);
        has("Q_RTL_MODE", INT32, 0);

        isSetAndPutBack();
        assertThat(written()).containsExactly("Q_RTL_MODE");
        assertThat(keeper.plan().after().atHome()).isEqualTo(CloudLossAction.AtHome.BY_ITSELF);
        assertThat(keeper.plan().after().note()).isEmpty();
    }

    /** Firmware tells it of planes without rotors as well. */
    @Test
    void doesNotTakeAPlaneForOneWithRotorsForThatSettingAlone() {
        isAPlane(1, 1, 5);
        has("Q_RTL_MODE", INT32, 1);

        assertThat(set()).isEqualTo(DONE);

        assertThat(keeper.plan().after().atHome()).isEqualTo(CloudLossAction.AtHome.BY_MISSION);
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
    void startsTheMissionOfAPlaneAndWritesNothingOfItsRemoteControl() {
        isAPlane(1, 1, 5);

        bench().perform(new Command.StartMission(MissionCloudLossPolicy.CONTINUE), 3);

        assertThat(written()).isEmpty();
    }

    @Test
    void saysOnlyWhatIsAboutMissionsWhenOneIsStarted() {
        isACopter();

        bench().perform(new Command.StartMission(MissionCloudLossPolicy.CONTINUE), 3);

        assertThat(written()).containsExactly("FS_OPTIONS");
        assertThat(held).containsEntry("FS_OPTIONS", 3.0);
    }

    @Test
    void leavesWhatWasChosenForMissionsWhereTheStartSaysNothingOfIt() {
        isACopter();

        bench().perform(new Command.StartMission(null), 3);

        assertThat(written()).isEmpty();
    }

    @Test
    void leavesWhatWasChosenForMissionsOfPx4Too() {
        isPx4();

        bench().perform(new Command.StartMission(null), 3);

        assertThat(written()).isEmpty();
    }
}
