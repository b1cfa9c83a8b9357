package org.dronemap.ws.problem;

import java.util.List;
import java.util.stream.Stream;
import org.dronemap.cognitive.operation.dispatch.DispatchObjection;
import org.dronemap.cognitive.operation.follow.FollowObjection;
import org.dronemap.cognitive.operation.recovery.RecoveryObjection;
import org.dronemap.cognitive.operation.run.model.RunObjection;
import org.dronemap.core.operation.Objection;
import org.dronemap.core.operation.ObjectionCode;
import org.dronemap.core.operation.ObjectionEntry;
import org.dronemap.core.operation.OperationObjection;
import org.dronemap.core.virtual.VirtualDroneObjection;

/** Problem code of why a mission run, a follow, a dispatch, a recovery or a virtual drone does not do what a user asked of it. */
public record ObjectionProblem(ObjectionCode code) implements ProblemCode {
    static List<ObjectionProblem> values() {
        return Stream.<ObjectionCode[]>of(
                        OperationObjection.values(),
                        RunObjection.values(),
                        FollowObjection.values(),
                        DispatchObjection.values(),
                        RecoveryObjection.values(),
                        VirtualDroneObjection.values())
                .flatMap(Stream::of)
                .map(ObjectionProblem::new)
                .toList();
    }

    /** {@code id}: of what does not take the wish. */
    public static Rejection rejection(Objection why, String id) {
        return new Rejection(
                new ObjectionProblem(why.code()),
                why.sentence(),
                Stream.concat(
                                Stream.of(ProblemParameter.ID.is(id)),
                                why.about().stream()
                                        .map(about ->
                                                new ProblemParameter.Given(parameter(about.subject()), about.value())))
                        .toList());
    }

    @Override
    public ProblemCatalogueEntry entry() {
        ObjectionEntry reason = code.entry();
        return ProblemCatalogueEntry.of(reason.word(), RejectionKind.CONFLICT, reason.meaning(), reason.example())
                .with(Stream.concat(
                                Stream.of(ProblemParameter.ID),
                                reason.subjects().stream().map(ObjectionProblem::parameter))
                        .toArray(ProblemParameter[]::new));
    }

    private static ProblemParameter parameter(Objection.Subject subject) {
        return switch (subject) {
            case DRONE -> ProblemParameter.DRONE;
            case WAYPOINT -> ProblemParameter.WAYPOINT;
            case STATE -> ProblemParameter.STATE;
            case PROPOSAL -> ProblemParameter.PROPOSAL;
            case MOST -> ProblemParameter.MOST;
        };
    }
}
