package org.dronemap.ws.server;

import java.util.List;
import org.dronemap.cognitive.operation.dispatch.DispatchInput;
import org.dronemap.cognitive.operation.dispatch.DispatchOperation;
import org.dronemap.cognitive.operation.dispatch.DispatchState;
import org.dronemap.cognitive.operation.follow.FollowInput;
import org.dronemap.cognitive.operation.follow.FollowOperation;
import org.dronemap.cognitive.operation.follow.FollowState;
import org.dronemap.cognitive.operation.recovery.RecoveryInput;
import org.dronemap.cognitive.operation.recovery.RecoveryOperation;
import org.dronemap.cognitive.operation.recovery.RecoveryState;
import org.dronemap.cognitive.operation.run.MissionRunOperation;
import org.dronemap.cognitive.operation.run.RunState;
import org.dronemap.cognitive.operation.run.model.RunInput;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.conduct.OperationRights;
import org.dronemap.core.conduct.Operations;
import org.dronemap.core.conduct.SeparationConductor;
import org.dronemap.core.operation.OperationKind;
import org.dronemap.core.operation.OperationStore;
import org.dronemap.core.separation.Separation;
import org.dronemap.core.separation.SeparationBoard;
import org.dronemap.core.time.Time;
import org.dronemap.ws.journal.DispatchJournalCodec;
import org.dronemap.ws.journal.FollowJournalCodec;
import org.dronemap.ws.journal.RecoveryJournalCodec;
import org.dronemap.ws.journal.RunJournalCodec;

/**
 * The components that conduct operations, with the four kinds there are: mission runs, follows,
 * dispatches and recoveries.
 *
 * @param apart what is kept between any two drones
 * @param board where all operations say what they mean to do, and see to whom their drones give way
 */
public record OperationComponents(
        Operations operations,
        OperationKind<RunState, RunInput> kind,
        OperationKind<FollowState, FollowInput> follows,
        OperationKind<DispatchState, DispatchInput> dispatches,
        OperationKind<RecoveryState, RecoveryInput> recoveries,
        Separation apart,
        SeparationBoard board) {
    /** Stored with each mission run. */
    private static final String MISSION_RUN = "missionRun";

    /** Stored with each follow. */
    private static final String FOLLOW = "follow";

    /** Stored with each dispatch. */
    private static final String DISPATCH = "dispatch";

    /** Stored with each recovery. */
    private static final String RECOVERY = "recovery";

    /** Begun before anybody conducts anything: who gives way to whom is known before drones are judged by it. */
    static SeparationConductor separation(
            CloudManager cloud, Separation apart, SeparationBoard board, ShutdownSequence closing, Time time) {
        SeparationConductor separation = new SeparationConductor(cloud, board, apart.aimedFor(), time);
        separation.start();
        return closing.adding("the separation of drones", separation);
    }

    /** Not started yet; {@code apart}: what drones that follow keep from others. */
    public static OperationComponents of(
            CloudManager cloud,
            OperationStore store,
            OperationRights rights,
            Separation apart,
            SeparationBoard board,
            Time time) {
        OperationKind<RunState, RunInput> kind =
                new OperationKind<>(MISSION_RUN, new MissionRunOperation(), new RunJournalCodec());
        OperationKind<FollowState, FollowInput> follows =
                new OperationKind<>(FOLLOW, new FollowOperation(apart), new FollowJournalCodec());
        OperationKind<DispatchState, DispatchInput> dispatches =
                new OperationKind<>(DISPATCH, new DispatchOperation(), new DispatchJournalCodec());
        OperationKind<RecoveryState, RecoveryInput> recoveries =
                new OperationKind<>(RECOVERY, new RecoveryOperation(), new RecoveryJournalCodec());
        return new OperationComponents(
                new Operations(cloud, store, rights, board, time, List.of(kind, follows, dispatches, recoveries)),
                kind,
                follows,
                dispatches,
                recoveries,
                apart,
                board);
    }
}
