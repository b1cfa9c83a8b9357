package org.dronemap.core.cloud.rule;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.drone.KnownMission;
import org.dronemap.core.drone.MissionPhase;
import org.dronemap.core.event.DroneEvent.MissionCurrentReported;
import org.dronemap.core.event.DroneEvent.MissionItemReached;
import org.dronemap.core.event.DroneEvent.MissionRead;
import org.dronemap.core.mission.MissionItem;
import org.junit.jupiter.api.Test;

class MissionTrackerTest {
    private static final List<MissionItem> THREE = List.of(
            new MissionItem.TakeOff(10),
            new MissionItem.TakeOff(20),
            new MissionItem.TakeOff(30),
            new MissionItem.Land());
    private static final List<MissionItem> OTHER = List.of(new MissionItem.TakeOff(99));

    private final List<KnownMission> kept = new ArrayList<>();

    @Test
    void keepsWhatWasUploadedAndTheItemItHeadsFor() {
        MissionTracker tracker = new MissionTracker(null, kept::add);

        tracker.apply(new MissionRead(THREE, true));
        tracker.apply(new MissionCurrentReported(1, null));

        assertThat(kept).containsExactly(new KnownMission(THREE, null), new KnownMission(THREE, 1));
        assertThat(tracker.progress().notice()).isNull();
    }

    @Test
    void saysThatTheVehicleFlewOnWhileTheCloudWasAway() {
        MissionTracker tracker = new MissionTracker(new KnownMission(THREE, 1), kept::add);

        tracker.apply(new MissionRead(THREE, false));

        assertThat(tracker.apply(new MissionCurrentReported(3, null)))
                .contains("While the cloud was away the vehicle flew on from item 2 to item 4 of its mission.");
        assertThat(tracker.progress().reached()).containsExactly(0, 1, 2);
    }

    @Test
    void saysSoAlsoWhenTheItemIsHeardBeforeTheMission() {
        MissionTracker tracker = new MissionTracker(new KnownMission(THREE, 1), kept::add);

        tracker.apply(new MissionCurrentReported(3, null));

        assertThat(tracker.apply(new MissionRead(THREE, false)))
                .hasValueSatisfying(sentence -> assertThat(sentence).contains("flew on"));
    }

    @Test
    void noticesAMissionThatSomebodyElsePutThere() {
        MissionTracker tracker = new MissionTracker(new KnownMission(THREE, 1), kept::add);

        assertThat(tracker.apply(new MissionRead(OTHER, false))).isPresent();

        assertThat(tracker.progress().items()).isEqualTo(OTHER);
        assertThat(tracker.progress().notice())
                .isEqualTo("The mission on the vehicle is not the one that the cloud last knew:"
                        + " 1 item instead of 4; item 1 differs.");
        assertThat(kept)
                .as("what was known stays known until the cloud uploads")
                .isEmpty();
    }

    @Test
    void noticesThatOnlyTheFinerSettingsOfAMissionWereChanged() {
        MissionTracker tracker = new MissionTracker(null, kept::add);
        tracker.apply(new MissionRead(THREE, "aa", true));
        assertThat(tracker.apply(new MissionRead(THREE, "aa", false))).isEmpty();

        assertThat(tracker.apply(new MissionRead(THREE, "bb", false)))
                .contains("The mission on the vehicle is not the one that the cloud last knew:"
                        + " its items have other settings.");
        assertThat(tracker.progress().hash()).isEqualTo("bb");
        assertThat(tracker.apply(new MissionRead(THREE, "aa", false))).isEmpty();
        assertThat(tracker.progress().notice()).isNull();
    }

    @Test
    void learnsTheHashOfAMissionThatItRemembersFromBeforeARestart() {
        MissionTracker tracker = new MissionTracker(new KnownMission(THREE, null), kept::add);
        tracker.apply(new MissionRead(THREE, "aa", false));

        assertThat(kept).containsExactly(new KnownMission(THREE, "aa", null));
        assertThat(tracker.apply(new MissionRead(THREE, "bb", false))).isPresent();
    }

    @Test
    void noticesFinerSettingsThatChangedWhileItWasAway() {
        MissionTracker before = new MissionTracker(null, kept::add);
        before.apply(new MissionRead(THREE, "aa", true));

        MissionTracker after = new MissionTracker(kept.get(kept.size() - 1), kept::add);

        assertThat(after.apply(new MissionRead(THREE, "bb", false)))
                .hasValueSatisfying(told -> assertThat(told).contains("other settings"));
    }

    @Test
    void knowsAMissionByItsHashThatWasWordedOtherwise() {
        KnownMission worded = new KnownMission(List.of(new MissionItem.Other("command 189")), "aa", null);
        MissionTracker tracker = new MissionTracker(worded, kept::add);
        List<MissionItem> now = List.of(new MissionItem.Other("begin of the landing sequence"));

        assertThat(tracker.apply(new MissionRead(now, "aa", false, true))).isEmpty();
        assertThat(tracker.progress().notice()).isNull();
        assertThat(tracker.progress().landingSequence()).isTrue();
        assertThat(tracker.apply(new MissionRead(now, "bb", false, true))).isPresent();
    }

    @Test
    void saysCalmlyThatTheVehicleHoldsNoMissionAfterARestart() {
        MissionTracker tracker = new MissionTracker(new KnownMission(THREE, 1), kept::add);

        assertThat(tracker.apply(new MissionRead(List.of(), false)))
                .as("a vehicle that forgets with its power is no cause for a warning")
                .isEmpty();

        assertThat(tracker.progress().notice())
                .isEqualTo("The vehicle holds no mission now; the last one that the cloud knew had 4 items.");
    }

    @Test
    void warnsWhenAMissionIsTakenAwayUnderTheCloudsEyes() {
        MissionTracker tracker = new MissionTracker(null, kept::add);
        tracker.apply(new MissionRead(THREE, true));

        assertThat(tracker.apply(new MissionRead(List.of(), false)))
                .contains("The vehicle holds no mission now; the last one that the cloud knew had 4 items.");
    }

    @Test
    void dropsTheNoticeWhenTheMissionIsBack() {
        MissionTracker tracker = new MissionTracker(new KnownMission(THREE, 1), kept::add);
        tracker.apply(new MissionRead(List.of(), false));

        tracker.apply(new MissionRead(THREE, false));

        assertThat(tracker.progress().notice()).isNull();
    }

    @Test
    void dropsTheNoticeWithTheNextUpload() {
        MissionTracker tracker = new MissionTracker(new KnownMission(THREE, 1), kept::add);
        tracker.apply(new MissionRead(OTHER, false));

        tracker.apply(new MissionRead(THREE, true));

        assertThat(tracker.progress().notice()).isNull();
    }

    @Test
    void forgetsWhatWasReachedWhenTheMissionChangesOrBeginsAgain() {
        MissionTracker tracker = new MissionTracker(null, kept::add);
        tracker.apply(new MissionRead(THREE, true));
        tracker.apply(new MissionItemReached(0));
        tracker.apply(new MissionItemReached(1));
        assertThat(tracker.progress().reached()).containsExactly(0, 1);

        tracker.apply(new MissionCurrentReported(2, null));
        tracker.apply(new MissionCurrentReported(0, null));

        assertThat(tracker.progress().reached()).isEmpty();
    }

    @Test
    void keepsWhatLiesBeforeTheItemThatItGoesBackTo() {
        MissionTracker tracker = new MissionTracker(null, kept::add);
        tracker.apply(new MissionRead(THREE, true));
        tracker.apply(new MissionItemReached(0));
        tracker.apply(new MissionItemReached(1));
        tracker.apply(new MissionItemReached(2));
        tracker.apply(new MissionCurrentReported(3, null));

        tracker.apply(new MissionCurrentReported(1, null));

        assertThat(tracker.progress().reached()).containsExactly(0);
    }

    @Test
    void beginsAnewWhenTheSameMissionIsUploadedAgain() {
        MissionTracker tracker = new MissionTracker(null, kept::add);
        tracker.apply(new MissionRead(THREE, true));
        tracker.apply(new MissionItemReached(0));

        tracker.apply(new MissionRead(THREE, true));

        assertThat(tracker.progress().reached()).isEmpty();
    }

    @Test
    void staysReachedWhenTheVehicleGoesToItsFirstItemAtTheEnd() {
        MissionTracker tracker = flown();

        tracker.apply(new MissionCurrentReported(0, MissionPhase.COMPLETE));

        assertThat(tracker.progress().reached()).containsExactly(0, 1, 2, 3);
        assertThat(tracker.progress().phase()).isEqualTo(MissionPhase.COMPLETE);
    }

    @Test
    void countsTheLastItemAsReachedAtTheEndAlsoWhenThatMessageWasLost() {
        MissionTracker tracker = new MissionTracker(null, kept::add);
        tracker.apply(new MissionRead(THREE, true));
        tracker.apply(new MissionCurrentReported(3, MissionPhase.RUNNING));

        tracker.apply(new MissionCurrentReported(3, MissionPhase.COMPLETE));

        assertThat(tracker.progress().reached()).containsExactly(3);
    }

    @Test
    void beginsAnewWhenAFinishedMissionIsFlownAgain() {
        MissionTracker tracker = flown();
        tracker.apply(new MissionCurrentReported(0, MissionPhase.COMPLETE));

        tracker.apply(new MissionCurrentReported(0, MissionPhase.RUNNING));
        tracker.apply(new MissionItemReached(3));

        assertThat(tracker.progress().reached())
                .as("the last item, said once more, is not reached again")
                .isEmpty();
    }

    @Test
    void saysThatTheVehicleFlewToTheEndWhileTheCloudWasAway() {
        MissionTracker tracker = new MissionTracker(new KnownMission(THREE, 1), kept::add);
        tracker.apply(new MissionRead(THREE, false));

        assertThat(tracker.apply(new MissionCurrentReported(0, MissionPhase.COMPLETE)))
                .contains("While the cloud was away the vehicle flew its mission to the end.");
        assertThat(tracker.progress().reached()).containsExactly(0, 1, 2, 3);
    }

    private MissionTracker flown() {
        MissionTracker tracker = new MissionTracker(null, kept::add);
        tracker.apply(new MissionRead(THREE, true));
        for (int index = 0; index < THREE.size(); index++) {
            tracker.apply(new MissionCurrentReported(index, MissionPhase.RUNNING));
            tracker.apply(new MissionItemReached(index));
        }
        return tracker;
    }
}
