package org.dronemap.core.virtual;

import java.util.List;
import java.util.Optional;
import org.dronemap.core.command.MissionCloudLossPolicy;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.core.separation.FlightIntent;

/** Derives from a virtual drone's run the intent for the real drone that serves it. */
public final class VirtualFlightIntent {
    private VirtualFlightIntent() {}

    /** Empty: nothing that moves it. */
    public static Optional<FlightIntent> of(VirtualRun run, VirtualRunAssignment assignment) {
        return switch (run.stage()) {
            case ARMING, STARTING ->
                Optional.of(onMission(run, intent(FlightIntent.Step.RISE, mission(run, assignment), assignment)));
            case FLYING -> Optional.of(onMission(run, intent(FlightIntent.Step.FLY, List.of(), assignment)));
            case RETURNING, STOPPING, GIVING_UP ->
                Optional.of(intent(FlightIntent.Step.COME_HOME, List.of(), assignment));
            case QUEUED, UPLOADING, SUSPENDED, DONE, STOPPED, FAILED -> Optional.empty();
        };
    }

    private static FlightIntent onMission(VirtualRun run, FlightIntent intent) {
        return intent.goingOnAlone(run.onCloudLoss() == MissionCloudLossPolicy.CONTINUE);
    }

    private static List<MissionItem> mission(VirtualRun run, VirtualRunAssignment assignment) {
        return run.tour()
                .share(assignment.first(), assignment.takeOffMeters())
                .mission()
                .items();
    }

    private static FlightIntent intent(
            FlightIntent.Step step, List<MissionItem> items, VirtualRunAssignment assignment) {
        // What it was told shows within moments; how it goes on after that, it shows itself.
        return new FlightIntent(step, items, null, false, assignment.changedAt());
    }
}
